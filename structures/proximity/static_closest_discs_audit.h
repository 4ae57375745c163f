// SPDX-License-Identifier: GPL-3.0-or-later
// The closest pair of discs at exact positions, for audits: shares no code with the predicates.
#ifndef KINEX_STRUCTURES_PROXIMITY_STATIC_CLOSEST_DISCS_AUDIT_H
#define KINEX_STRUCTURES_PROXIMITY_STATIC_CLOSEST_DISCS_AUDIT_H

#include <vector>

#include "core/engine/audit.h"

namespace kinex {

// The two ids, ascending, of the living discs (balls) whose gap, their distance less their radii, is
// smallest; among equal gaps the lexicographically smallest pair. Empty if two discs meet, or if there
// are fewer than two. All pairs, whose gaps are numbers of CGAL's Sqrt_extension over rationals: O(n^2).
std::vector<ObjectId> static_closest_discs(const Snapshot& snapshot);

}  // namespace kinex

#endif
