// SPDX-License-Identifier: GPL-3.0-or-later
// Predicates on points in space: the side of a plane, the side of a sphere, and those of points that are in
// one plane. The terms are those of predicates/predicates.h.
#ifndef KINEX_PREDICATES_POINTS_SPACE_PREDICATES_H
#define KINEX_PREDICATES_POINTS_SPACE_PREDICATES_H

#include <memory>

#include "core/arithmetic/predicate.h"

namespace kinex {

// orientation_3(a, b, c, d) = det(b - a, c - a, d - a), six times the signed volume of the
// tetrahedron. Positive iff a, b, c turn counter-clockwise as seen from a place from which d lies
// behind their plane; (0,0,0), (1,0,0), (0,1,0), (0,0,1) give 1. Degree 3 in the coordinates.
//   (1) alternating in all four
//   (2) zero if two arguments are equal
//   (3) unchanged by a common translation
std::shared_ptr<const Predicate> make_orientation_3();
// The same polynomial under the same name, for certificates that fail at touches, too
// (core/arithmetic/touch.h).
std::shared_ptr<const Predicate> make_orientation_3_touch();

// in_sphere_3(a, b, c, d, e) = - the determinant with rows (x, y, z, x^2 + y^2 + z^2) of a - e,
// b - e, c - e, d - e. For orientation_3(a, b, c, d) > 0, positive iff e lies strictly inside the
// sphere through the other four. Degree 5 in the coordinates.
//   (1) alternating in all five
//   (2) zero if two arguments are equal
//   (3) unchanged by a common translation
std::shared_ptr<const Predicate> make_in_sphere_3();
// The same polynomial under the same name, for certificates that fail at touches, too.
std::shared_ptr<const Predicate> make_in_sphere_3_touch();

// unfolded_3(p, u, v, q) = ((v - u) x (p - u)) . ((v - u) x (u - q)). For triangles u v p and u v q in one
// plane, positive iff they lie on different sides of their common edge. Degree 4 in the coordinates.
//   (1) unchanged if p and q, or u and v, are exchanged
//   (2) zero if p or q is on the line through u and v
//   (3) unchanged by a common translation
std::shared_ptr<const Predicate> make_unfolded_3();

// orientation_2 of the projections on two axes, first < second, of points in space (named
// orientation_xy, orientation_xz, orientation_yz). Positive iff the projections of a, b, c turn
// counter-clockwise in the plane of the two axes. Three points are on one line iff all three
// predicates are zero. Degree 2 in the coordinates; throws std::invalid_argument for other axes.
//   (1) alternating in all three
std::shared_ptr<const Predicate> make_projected_orientation(int first, int second);
// The same polynomial under the same name, for certificates that fail at touches, too.
std::shared_ptr<const Predicate> make_projected_orientation_touch(int first, int second);

// in_circle_lifted(a, b, c, e): for points of one plane twice the determinant with rows
// (u, v, x^2 + y^2 + z^2) of a - e, b - e, c - e on two axes u < v of space (named in_circle_xy, in_circle_xz, in_circle_yz). For four points of one plane
// whose projections on these axes are not on one line, and a, b, c counter-clockwise in projection, positive
// iff e lies strictly inside the circle through a, b, c. Degree 4 in the coordinates; throws
// std::invalid_argument for other axes.
//   (1) alternating in all four
//   (2) zero if two arguments are equal
//   (3) unchanged by a common translation
//   (4) on x and y: twice in_circle_2 if all points have the same z
std::shared_ptr<const Predicate> make_in_circle_lifted(int first, int second);
// The same polynomial under the same name, for certificates that fail at touches, too.
std::shared_ptr<const Predicate> make_in_circle_lifted_touch(int first, int second);

// obtuse_angle_3(a, b, c) = (a - b) . (b - c): positive iff the angle at b is obtuse; for points on one line,
// iff b is strictly between the others. Degree 2 in the coordinates.
//   (1) unchanged if a and c are exchanged
//   (2) zero if b is equal to a or c
//   (3) unchanged by a common translation
std::shared_ptr<const Predicate> make_obtuse_angle_3();

}  // namespace kinex

#endif
