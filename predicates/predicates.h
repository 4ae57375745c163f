// SPDX-License-Identifier: GPL-3.0-or-later
// All predicates on points: one function each, in a file of its own name. A certificate claims
// "value >= 0".
//
// d is the degree of the motions. "Degree k in the coordinates" makes a polynomial of degree k d in
// t. Alternating in some arguments: a permutation of them multiplies the value by its sign, so the
// value is zero if two of them are equal. Further identities are numbered in the .cpp files.
#ifndef KINEX_PREDICATES_PREDICATES_H
#define KINEX_PREDICATES_PREDICATES_H

#include <memory>
#include <vector>

#include "core/arithmetic/predicate.h"
#include "core/motion/scene.h"

namespace kinex {

// coordinate_order(a, b) = x_b - x_a on `axis`.
//   (1) positive iff a precedes b   (2) degree 1 in the coordinates   (3) alternating
std::shared_ptr<const Predicate> make_coordinate_order(int axis);

// direction_order(a, b) = v.(b - a) for a constant vector v (one entry per axis).
//   (1) positive iff a precedes b along v   (2) degree 1 in the coordinates   (3) alternating
std::shared_ptr<const Predicate> make_direction_order(const std::vector<Rational>& direction);

// The primitive integer vector of the same direction; std::invalid_argument for the zero vector.
std::vector<Integer> primitive_direction(const std::vector<Rational>& direction);

// squared_distance_order(a, b, o) = |b - o|^2 - |a - o|^2 in `dimension` axes.
//   (1) positive iff a is closer to o than b   (2) degree 2 in the coordinates
//   (3) alternating in a, b
std::shared_ptr<const Predicate> make_squared_distance_order(int dimension);

// pair_distance_order(a, b, c, d) = |d - c|^2 - |b - a|^2 in `dimension` axes, 1 to 3.
//   (1) positive iff a and b are closer to each other than c and d
//   (2) degree 2 in the coordinates
//   (3) exchanging a and b, or c and d, changes nothing; exchanging the pairs changes the sign
// Of pairs that share an object: squared_distance_order.
std::shared_ptr<const Predicate> make_pair_distance_order(int dimension);

// orientation_2(a, b, c) = (b - a) x (c - a), twice the signed area of the triangle.
//   (1) positive iff a, b, c turn counter-clockwise   (2) degree 2 in the coordinates
//   (3) alternating in all three
std::shared_ptr<const Predicate> make_orientation_2();
// The same polynomial under the same name, for certificates that fail at touches, too
// (core/arithmetic/touch.h).
std::shared_ptr<const Predicate> make_orientation_2_touch();

// slope_order_2(a, b, c, d) = (b - a) x (d - c).
//   (1) positive iff the direction from c to d is counter-clockwise, by less than half a turn, of
//       that from a to b
//   (2) degree 2 in the coordinates
//   (3) alternating in a, b, and in c, d; exchanging the two pairs changes the sign
std::shared_ptr<const Predicate> make_slope_order_2();

// in_circle_2(a, b, c, d): the determinant of the lifted points (x, y, x^2 + y^2).
//   (1) positive iff d lies strictly inside the circle through a, b, c, for a, b, c
//       counter-clockwise
//   (2) degree 4 in the coordinates   (3) alternating in all four
std::shared_ptr<const Predicate> make_in_circle_2();

// The order by a key, as a predicate over (a, b) or, for a squared distance, (a, b, object).
//   (1) positive iff key(a) < key(b)   (2) degree of the key   (3) alternating in a, b
std::shared_ptr<const Predicate> make_key_order(const Key& key, int dimension);

// For keys that are linear in t, key_i(t) = slope_i t + height_i, seen as points (slope_i,
// height_i) of the dual plane. The values are numbers, not functions of t: degree 0 in t. Not for
// squared distances.
//
// line_slope_order(a, b) = slope_b - slope_a.
//   (1) positive iff the key of b grows faster   (2) degree 1 in the dual points   (3) alternating
std::shared_ptr<const Predicate> make_line_slope_order(const Key& key, int dimension);
// line_turn(a, b, c): orientation_2 of the dual points.
//   (1) positive iff the dual points turn counter-clockwise   (2) degree 2 in the dual points
//   (3) alternating in all three
std::shared_ptr<const Predicate> make_line_turn(const Key& key, int dimension);
// line_meeting(a, b, c, d, e), for slope_a < slope_b and slope_c < slope_d.
//   (1) positive iff, at the slope of e, the line through the dual points of a and b is above the
//       one through those of c and d
//   (2) degree 3 in the dual points
//   (3) exchanging a and b, or c and d, or the two pairs, changes the sign
std::shared_ptr<const Predicate> make_line_meeting(const Key& key, int dimension);

}  // namespace kinex

#endif
