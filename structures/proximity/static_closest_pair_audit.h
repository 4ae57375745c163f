// SPDX-License-Identifier: GPL-3.0-or-later
// The closest pair of points at exact positions, for audits: shares no code with the predicates.
#ifndef KINEX_STRUCTURES_PROXIMITY_STATIC_CLOSEST_PAIR_AUDIT_H
#define KINEX_STRUCTURES_PROXIMITY_STATIC_CLOSEST_PAIR_AUDIT_H

#include <array>
#include <functional>
#include <vector>

#include "core/engine/audit.h"

namespace kinex {

// The two ids, ascending, of the closest pair of living points; among equal distances the
// lexicographically smallest pair. Empty if there are fewer than two. Any dimension. Skips pairs
// that are farther apart on the first axis than the best pair so far: O(n^2) at worst.
// `counts`: of the pairs that it accepts alone.
std::vector<ObjectId> static_closest_pair(
    const Snapshot& snapshot, const std::function<bool(ObjectId, ObjectId)>& counts = {});

// All pairs of living points at the smallest distance, ids ascending, ascending; of points at one place only
// those whose ids are next to each other there. As long as static_closest_pair.
std::vector<std::array<ObjectId, 2>> static_closest_pairs(const Snapshot& snapshot);

// The audit of a structure whose candidates are to have every closest pair: of those above the first one is
// the attribute, and each is an item. Points at one place stand in a row there, by id, an infinitesimal apart
// (turned_order.h): so of their pairs those of neighbours alone have to be candidates.
void check_closest_pairs(const Snapshot& snapshot, const std::vector<ObjectId>& attribute,
                         const std::function<bool(const std::array<ObjectId, 2>&)>& is_item,
                         AuditReport& report);

}  // namespace kinex

#endif
