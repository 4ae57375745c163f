// SPDX-License-Identifier: GPL-3.0-or-later
// The first point in each cone of each point at exact positions, for audits: by definition, from
// coordinates alone.
#ifndef KINEX_STRUCTURES_PROXIMITY_STATIC_OCTANTS_AUDIT_H
#define KINEX_STRUCTURES_PROXIMITY_STATIC_OCTANTS_AUDIT_H

#include <array>
#include <vector>

#include "core/engine/audit.h"

namespace kinex {

// By object and cone (octant_woods.h); kNoObject: none, or the object is not alive. O(n^2).
std::vector<std::array<ObjectId, 6>> static_octants(const Snapshot& snapshot);

}  // namespace kinex

#endif
