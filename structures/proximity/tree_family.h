// SPDX-License-Identifier: GPL-3.0-or-later
// The descriptors of spanning trees: Euclidean ones, those in other norms, and those of graphs.
#ifndef KINEX_STRUCTURES_PROXIMITY_TREE_FAMILY_H
#define KINEX_STRUCTURES_PROXIMITY_TREE_FAMILY_H

#include <optional>
#include <vector>

#include "structures/parts/descriptor.h"

namespace kinex {

// The descriptors of all spanning trees.
std::vector<StructureInfo> spanning_trees();
// Refuses scenes of more than three axes.
std::optional<Refusal> beyond_space(const Scene& scene);

}  // namespace kinex

#endif
