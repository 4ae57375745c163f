// SPDX-License-Identifier: GPL-3.0-or-later
// The order of points along an axis of octants at exact positions, for audits: sorted by definition, from
// coordinates alone.
#ifndef KINEX_STRUCTURES_PROXIMITY_STATIC_ORDER_AUDIT_H
#define KINEX_STRUCTURES_PROXIMITY_STATIC_ORDER_AUDIT_H

#include <vector>

#include "core/engine/audit.h"
#include "structures/proximity/cone_frame.h"

namespace kinex {

// The points that are alive; of level ones the first is the one that is so after an infinitesimal
// counter-clockwise turn, of equal ones the one with the smallest id (turned_order.h). O(n log n).
std::vector<ObjectId> static_order(const Snapshot& snapshot, OctantAxis axis);

// Checks that `order` is that one.
void check_order(const Snapshot& snapshot, OctantAxis axis, const std::vector<ObjectId>& order,
                 AuditReport& report);

}  // namespace kinex

#endif
