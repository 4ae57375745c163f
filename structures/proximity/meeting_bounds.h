// SPDX-License-Identifier: GPL-3.0-or-later
// Hard bounds on structures that maintain the pairs of boxes, or discs, that meet.
#ifndef KINEX_STRUCTURES_PROXIMITY_MEETING_BOUNDS_H
#define KINEX_STRUCTURES_PROXIMITY_MEETING_BOUNDS_H

#include <string>
#include <vector>

#include "core/engine/bound.h"
#include "structures/proximity/box_overlaps.h"

namespace kinex {

// On the lists of ends of `owner`: certificates and swaps.
std::vector<BoundCheck> end_bounds(const std::string& owner, const BoxOverlaps& overlaps,
                                   const BoundContext& context);
// On external events: a pair begins or ceases to meet only where one of `functions` polynomials of
// `factor` times the degree of the motions changes its sign. For linear motions without changes of
// flight plans a pair meets in one interval of time: n(n-1).
BoundCheck meeting_bound(const std::string& owner, int functions, int factor,
                         const BoundContext& context);

}  // namespace kinex

#endif
