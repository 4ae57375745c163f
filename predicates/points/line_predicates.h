// SPDX-License-Identifier: GPL-3.0-or-later
// Predicates on lines y = a x + b, whose motions have the axes (a, b). The terms are those of
// predicates/predicates.h. Predicates on points, with (a, b) in the place of (x, y), say more:
//
//   order_x(l, m)            the slope of l is not greater than that of m
//   orientation_2(l, m, k)   for slopes in the order l < m < k: m is not above the crossing of l
//                            and k. Zero iff the three lines meet in a point, or two coincide, or
//                            all are parallel.
#ifndef KINEX_PREDICATES_POINTS_LINE_PREDICATES_H
#define KINEX_PREDICATES_POINTS_LINE_PREDICATES_H

#include <memory>

#include "core/arithmetic/predicate.h"

namespace kinex {

// line_side(l, p) = y_p - a_l x_p - b_l for a line l and a point p, and line_under(l, p), its
// negation. line_side is positive iff p is above l. Degree 2 in the coordinates, by value.
//   (1) line_under = -line_side
//   (2) the value falls by as much as b_l grows
//   (3) duality: with (x_p, -y_p) in the place of (a_l, b_l) and (a_l, -b_l) in that of (x_p, y_p) the
//       value is the same
std::shared_ptr<const Predicate> make_line_side();
// See make_line_side.
std::shared_ptr<const Predicate> make_line_under();

// line_order(l, m, p) = (a_m - a_l) x_p + b_m - b_l for lines l and m and a point p: positive iff m is
// above l at the x of p. Degree 2 in the coordinates, by value.
//   (1) exchanging the lines changes the sign
//   (2) line_order(l, m, p) = line_side(l, p) - line_side(m, p)
std::shared_ptr<const Predicate> make_line_order();

}  // namespace kinex

#endif
