// SPDX-License-Identifier: GPL-3.0-or-later
// Predicates on edges of a convex polygon and on figures that are flush with one: strips and
// rectangles.
//
// An edge from a to b, of a polygon that lies to its left, and the other points of contact:
//
//      +-------c-------+        u = b - a            strip      a, b, c
//      |               |        H = u x (c - a)      rectangle  a, b, r, c, l
//      l               r        W = u . (r - l)
//      |               |        height H / |u|, width W / |u|
//      +---a------->b--+
//
// The orders compare fractions whose denominators are squared lengths, without dividing. Where an
// edge has length zero for an instant, its numerator and its denominator vanish together, and the
// sign right after the instant is still that of the comparison.
#ifndef KINEX_PREDICATES_POINTS_EDGE_PREDICATES_H
#define KINEX_PREDICATES_POINTS_EDGE_PREDICATES_H

#include <memory>

#include "core/arithmetic/predicate.h"

namespace kinex {

// edge_dot_2(a, b, c, d) = (b - a) . (d - c).
// Positive iff the directions from a to b and from c to d form an acute angle. Degree 2 in the
// coordinates.
//   (1) alternating in a, b, and in c, d
//   (2) value(c, d, a, b) = value(a, b, c, d)
//   (3) value(a, b, a, b) >= 0
//   (4) unchanged by a translation of one pair
std::shared_ptr<const Predicate> make_edge_dot_2();

// strip_order_2(a, b, c, d, e, f) = H'^2 |u|^2 - H^2 |u'|^2, named order_strip.
// Positive iff the strip of a, b, c is narrower than that of d, e, f. Degree 6 in the coordinates.
//   (1) value(d, e, f, a, b, c) = -value(a, b, c, d, e, f)
//   (2) value(b, a, c, d, e, f) = value(a, b, c, d, e, f)
//   (3) value(a, b, a, d, e, f) >= 0
//   (4) unchanged by a translation of one strip
std::shared_ptr<const Predicate> make_strip_order_2();

// rectangle_area_order_2(a, b, r, c, l, a', b', r', c', l') = H' W' |u|^2 - H W |u'|^2, named
// order_rectangle_area. Positive iff the first rectangle has the smaller area. Degree 6 in the
// coordinates.
//   (1) exchanging the rectangles changes the sign
//   (2) unchanged by a translation of one rectangle
std::shared_ptr<const Predicate> make_rectangle_area_order_2();

// rectangle_perimeter_order_2(a, b, r, c, l, a', b', r', c', l') =
//   (H' + W')^2 |u|^2 - (H + W)^2 |u'|^2, named order_rectangle_perimeter. Positive iff the first
// rectangle has the smaller perimeter, for H, W, H', W' >= 0. Degree 6 in the coordinates.
//   (1) exchanging the rectangles changes the sign
//   (2) unchanged by a translation of one rectangle
std::shared_ptr<const Predicate> make_rectangle_perimeter_order_2();

}  // namespace kinex

#endif
