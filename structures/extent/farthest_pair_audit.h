// SPDX-License-Identifier: GPL-3.0-or-later
// The farthest pair at exact positions, for audits.
#ifndef KINEX_STRUCTURES_EXTENT_FARTHEST_PAIR_AUDIT_H
#define KINEX_STRUCTURES_EXTENT_FARTHEST_PAIR_AUDIT_H

#include <vector>

#include "core/engine/audit.h"

namespace kinex {

// The two ids, ascending, of the lexicographically smallest pair of largest distance; empty for
// fewer than two points. O(n^2).
std::vector<ObjectId> static_farthest_pair(const Snapshot& snapshot);

}  // namespace kinex

#endif
