// SPDX-License-Identifier: GPL-3.0-or-later
// One line that halves two sets of points of the dual plane, which another line separates: a
// ham-sandwich cut.
//
//        A     |     B          for every a there is one line from a that halves B; the points of A
//      .    .  |  .     .       are totally ordered by the side of these lines on which they are, and
//   ----a------|------b----->   the middle one has the line that halves A, too
//      .    .  |   .    .
//
// Cost: expected O((|A| + |B|) log |A|) turns; few rounds, since pivots come from a sample.
//
// Source: Edelsbrunner, Welzl, "Halfplanar range search in linear space and O(n^0.695) query time"
// (1986), for the use of it; the search by selection is ours.
#ifndef KINEX_STRUCTURES_RANGE_HALVING_LINE_H
#define KINEX_STRUCTURES_RANGE_HALVING_LINE_H

#include <cstddef>
#include <span>

#include "structures/range/dual_points.h"

namespace kinex {

// The number of points of m on the first side.
inline std::size_t first_half(std::size_t m) { return (m + 1) / 2; }

// Puts the first_half() points of either set that are to the left of a common line in front of the
// others. Requires that a line separates the sets; otherwise (in an inexact arithmetic) it ends with
// some order. Neither is empty.
void halve_both(const DualPoints& points, std::span<ObjectId> a, std::span<ObjectId> b);

}  // namespace kinex

#endif
