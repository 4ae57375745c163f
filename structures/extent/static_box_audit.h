// SPDX-License-Identifier: GPL-3.0-or-later
// The box with sides along the axes by exact positions: for audits.
#ifndef KINEX_STRUCTURES_EXTENT_STATIC_BOX_AUDIT_H
#define KINEX_STRUCTURES_EXTENT_STATIC_BOX_AUDIT_H

#include <vector>

#include "core/engine/audit.h"

namespace kinex {

// The ids of the minimum and the maximum of the first axis, of the next one, and so on, by exact
// comparison of all points; of equal ones the smallest id. Empty without points. Time O(dim n).
std::vector<ObjectId> static_box(const Snapshot& snapshot);

}  // namespace kinex

#endif
