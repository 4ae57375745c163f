// SPDX-License-Identifier: GPL-3.0-or-later
// The closest pair of points at exact positions, for audits: shares no code with the predicates.
#ifndef KINEX_STRUCTURES_PROXIMITY_STATIC_CLOSEST_PAIR_AUDIT_H
#define KINEX_STRUCTURES_PROXIMITY_STATIC_CLOSEST_PAIR_AUDIT_H

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

}  // namespace kinex

#endif
