// SPDX-License-Identifier: GPL-3.0-or-later
// The audit of boxes with sides along the axes.
#ifndef KINEX_STRUCTURES_EXTENT_BOUNDING_BOX_AUDIT_H
#define KINEX_STRUCTURES_EXTENT_BOUNDING_BOX_AUDIT_H

#include <vector>

#include "core/engine/audit.h"

namespace kinex {

// The ids of `box` are the minimum and the maximum of the first axis, of the next one, and so on, by
// exact comparison of all; of equal ones the smallest id.
void audit_box(const std::vector<ObjectId>& box, const Snapshot& snapshot, AuditReport& report);

}  // namespace kinex

#endif
