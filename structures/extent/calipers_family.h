// SPDX-License-Identifier: GPL-3.0-or-later
// The descriptors of the structures of rotating calipers, and of their baseline.
#ifndef KINEX_STRUCTURES_EXTENT_CALIPERS_FAMILY_H
#define KINEX_STRUCTURES_EXTENT_CALIPERS_FAMILY_H

#include <vector>

#include "structures/parts/descriptor.h"

namespace kinex {

// The descriptors of the diameter, the width and the rectangles.
std::vector<StructureInfo> caliper_structures();

}  // namespace kinex

#endif
