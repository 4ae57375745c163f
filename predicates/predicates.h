// SPDX-License-Identifier: GPL-3.0-or-later
// All predicates: one function each, in a file of its own name. A certificate says "value >= 0".
#ifndef KINEX_PREDICATES_PREDICATES_H
#define KINEX_PREDICATES_PREDICATES_H

#include <memory>
#include <vector>

#include "core/predicate.h"
#include "core/scene.h"

namespace kinex {

// coordinate_order(a, b) = x_b - x_a on `axis`: positive iff a comes before b. Degree d. Alternating.
std::shared_ptr<const Predicate> make_coordinate_order(int axis);

// direction_order(a, b) = v.(b - a) for a constant vector v (one entry per axis). Degree d. Alternating.
std::shared_ptr<const Predicate> make_direction_order(const std::vector<Rational>& direction);

// The primitive integer vector of the same direction. Throws std::invalid_argument for the zero vector.
std::vector<Integer> primitive_direction(const std::vector<Rational>& direction);

// squared_distance_order(a, b, o) = |b - o|^2 - |a - o|^2 in `dimension` axes: positive iff a is closer
// to o than b. Degree 2d. Alternating in its first two arguments.
std::shared_ptr<const Predicate> make_squared_distance_order(int dimension);

// orientation_2(a, b, c): positive iff a, b, c turn counter-clockwise (twice the signed area). Degree 2d.
// Alternating in all three.
std::shared_ptr<const Predicate> make_orientation_2();

// slope_order_2(a, b, c, d) = (b - a) x (d - c): positive iff the direction from c to d is counter-clockwise
// from that from a to b (by less than half a turn). Degree 2d. Alternating in a, b.
std::shared_ptr<const Predicate> make_slope_order_2();

// in_circle_2(a, b, c, d): positive iff d lies strictly inside the circle through a, b, c, for a, b, c
// counter-clockwise. Degree 4d. Alternating in all four.
std::shared_ptr<const Predicate> make_in_circle_2();

// The order that a key stands for, as a predicate over (a, b) or, for a squared distance, (a, b, object):
// positive iff key(a) < key(b).
std::shared_ptr<const Predicate> make_key_order(const Key& key, int dimension);

// For keys that are linear in t, key_i(t) = slope_i t + height_i, seen as points (slope_i, height_i) of the
// dual plane; numbers, not functions of t: degree 0. Not for squared distances.
// line_slope_order(a, b): positive iff the key of b grows faster. Alternating.
std::shared_ptr<const Predicate> make_line_slope_order(const Key& key, int dimension);
// line_turn(a, b, c): positive iff the dual points turn counter-clockwise. Alternating in all three.
std::shared_ptr<const Predicate> make_line_turn(const Key& key, int dimension);
// line_meeting(a, b, c, d, e), where a grows slower than b and c slower than d: positive iff, at the slope
// of e, the line through the dual points of a and b is above the one through those of c and d.
std::shared_ptr<const Predicate> make_line_meeting(const Key& key, int dimension);

}  // namespace kinex

#endif
