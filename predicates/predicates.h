// SPDX-License-Identifier: GPL-3.0-or-later
// All predicates on points: one function each, in a file of its own name. A certificate claims
// "value >= 0".
//
// For each predicate: its formula, the meaning of a positive value, its degree, and numbered
// identities; a test that names an identity uses its number. d is the degree of the motions. A
// predicate of degree k in the coordinates is a polynomial of degree k d in t. "Alternating" means
// that a permutation of the arguments multiplies the value by the permutation's sign; so the value
// is zero if two of the arguments are equal.
#ifndef KINEX_PREDICATES_PREDICATES_H
#define KINEX_PREDICATES_PREDICATES_H

#include <array>
#include <memory>
#include <vector>

#include "core/arithmetic/predicate.h"
#include "core/motion/scene.h"

namespace kinex {

// coordinate_order(a, b) = x_b - x_a on `axis` (named order_x, order_y, order_z).
// Positive iff a precedes b. Degree 1 in the coordinates.
//   (1) alternating: value(b, a) = -value(a, b)
//   (2) value(a, a) = 0
//   (3) value(a, b) + value(b, c) = value(a, c)
std::shared_ptr<const Predicate> make_coordinate_order(int axis);

// direction_order(a, b) = v.(b - a) for a constant vector v, one entry per axis. v is replaced by
// the primitive integer vector of the same direction: a positive factor changes no sign and no
// root. Positive iff a precedes b along v. Degree 1 in the coordinates. Throws
// std::invalid_argument for the zero vector.
//   (1) alternating: value(b, a) = -value(a, b)
//   (2) value(a, a) = 0
//   (3) value(a, b) + value(b, c) = value(a, c)
std::shared_ptr<const Predicate> make_direction_order(const std::vector<Rational>& direction);

// The primitive integer vector of the same direction; std::invalid_argument for the zero vector.
std::vector<Integer> primitive_direction(const std::vector<Rational>& direction);

// squared_distance_order(a, b, o) = |b - o|^2 - |a - o|^2 in `dimension` axes, 1 to 3.
// Positive iff a is closer to o than b. Degree 2 in the coordinates.
//   (1) alternating in a, b: value(b, a, o) = -value(a, b, o)
//   (2) value(a, a, o) = 0
//   (3) value(o, b, o) >= 0
std::shared_ptr<const Predicate> make_squared_distance_order(int dimension);

// pair_distance_order(a, b, c, d) = |d - c|^2 - |b - a|^2 in `dimension` axes, 1 to 3.
// Positive iff a and b are closer to each other than c and d. Degree 2 in the coordinates.
//   (1) value(c, d, a, b) = -value(a, b, c, d)
//   (2) value(b, a, c, d) = value(a, b, d, c) = value(a, b, c, d)
//   (3) value(a, b, a, b) = value(a, b, b, a) = 0
//   (4) value(a, a, c, d) >= 0
//   (5) value(o, a, o, b) = squared_distance_order(a, b, o), to be used for pairs with a common
//       object
std::shared_ptr<const Predicate> make_pair_distance_order(int dimension);

// extent_order(a, b, c, d) = u.(a - b) - v.(c - d) for two constant vectors, one entry per axis;
// both are replaced by integer vectors in the same ratio. Positive iff the extent from b to a along
// u is larger than that from d to c along v. Degree 1 in the coordinates. `arguments`: the place of
// a, b, c and d among the arguments, {0, 1, 2, 3} for four objects. Where two of them are one
// object they have one place, so {0, 1, 0, 2} is over (a, b, d) with c = a. Throws
// std::invalid_argument if fewer than two are left, or the value is zero for all of them.
//   (1) value(b, a, d, c) = -value(a, b, c, d)
//   (2) value(a, b, a, d) = direction_order(b, d) up to a positive factor, for u = v
std::shared_ptr<const Predicate> make_extent_order(const std::vector<Rational>& u,
                                                   const std::vector<Rational>& v,
                                                   const std::array<int, 4>& arguments);

// orientation_2(a, b, c) = (b - a) x (c - a), twice the signed area of the triangle.
// Positive iff a, b, c turn counter-clockwise. Degree 2 in the coordinates.
//   (1) alternating in all three
//   (2) zero if two arguments are equal
//   (3) unchanged by a common translation
std::shared_ptr<const Predicate> make_orientation_2();
// The same polynomial under the same name, for certificates that fail at touches, too
// (core/arithmetic/touch.h).
std::shared_ptr<const Predicate> make_orientation_2_touch();

// slope_order_2(a, b, c, d) = (b - a) x (d - c).
// Positive iff the direction from c to d is counter-clockwise, by less than half a turn, of that
// from a to b. Degree 2 in the coordinates.
//   (1) alternating in a, b, and in c, d
//   (2) value(c, d, a, b) = -value(a, b, c, d)
//   (3) zero if a = b or c = d
//   (4) value(a, b, a, d) = orientation_2(a, b, d)
//   (5) unchanged by a translation of one pair
std::shared_ptr<const Predicate> make_slope_order_2();

// in_circle_2(a, b, c, d): the determinant with rows (x, y, x^2 + y^2) of a - d, b - d, c - d.
// For a, b, c counter-clockwise, positive iff d lies strictly inside their circle. Degree 4 in the
// coordinates.
//   (1) alternating in all four
//   (2) zero if two arguments are equal
//   (3) unchanged by a common translation
std::shared_ptr<const Predicate> make_in_circle_2();

// acute_angle_2(a, b, c) = (a - b) . (c - b), and obtuse_angle_2(a, b, c), its negation.
// Positive iff the angle at b between a and c is acute, or obtuse. Degree 2 in the coordinates.
//   (1) value(c, b, a) = value(a, b, c)
//   (2) zero if b is a or c
//   (3) acute_angle_2(a, b, c) + acute_angle_2(b, a, c) = |b - a|^2
std::shared_ptr<const Predicate> make_acute_angle_2();
// The same, negated.
std::shared_ptr<const Predicate> make_obtuse_angle_2();

// The order by a key: one of the first three predicates, over (a, b) or, for a squared distance,
// (a, b, object). Positive iff key(a) < key(b). The degree is that of the key.
//   (1) alternating in a, b
std::shared_ptr<const Predicate> make_key_order(const Key& key, int dimension);

// ---- predicates on keys that are linear in t: key_i(t) = slope_i t + height_i is the point
// (slope_i, height_i) of the dual plane. The values are numbers: degree 0 in t. `key` must be a
// coordinate or a direction; throws std::invalid_argument for a squared distance.

// line_slope_order(a, b) = slope_b - slope_a.
// Positive iff the key of b grows faster. Degree 1 in the dual points.
//   (1) alternating
std::shared_ptr<const Predicate> make_line_slope_order(const Key& key, int dimension);
// line_turn(a, b, c) = orientation_2 of the dual points.
// Positive iff the dual points turn counter-clockwise. Degree 2 in the dual points.
//   (1) alternating in all three
std::shared_ptr<const Predicate> make_line_turn(const Key& key, int dimension);
// line_meeting(a, b, c, d, e) = (slope_b - slope_a) line_turn(c, d, e)
//                             - (slope_d - slope_c) line_turn(a, b, e).
// For slope_a < slope_b and slope_c < slope_d, positive iff at the slope of e the line through the
// dual points of a and b is above the line through those of c and d. Degree 3 in the dual points.
//   (1) alternating in a, b, and in c, d
//   (2) line_meeting(c, d, a, b, e) = -line_meeting(a, b, c, d, e)
std::shared_ptr<const Predicate> make_line_meeting(const Key& key, int dimension);

}  // namespace kinex

#endif
