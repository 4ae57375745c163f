// SPDX-License-Identifier: GPL-3.0-or-later
// Predicates on points with weights in the plane and in space, and on discs and balls, whose weights are
// the squares of their radii. The weight, or the radius, is the axis behind those of the position. The
// lifted height of a point is the sum of the squares of its coordinates, less w. d is the largest degree
// of motions and weights, or radii.
#ifndef KINEX_PREDICATES_POINTS_POWER_PREDICATES_H
#define KINEX_PREDICATES_POINTS_POWER_PREDICATES_H

#include <memory>

#include "core/arithmetic/predicate.h"

namespace kinex {

// power_2(a, b, c, e): the determinant with rows (x, y, x^2 + y^2 - w + w_e) of a - e, b - e, c - e.
// For a, b, c counter-clockwise, positive iff e lies strictly below the plane through the other
// three, all lifted: then e has a cell in their regular triangulation. Degree 4 in t, times d, at
// most; for constant weights and linear motions 4. Not homogeneous in the coordinates: the weights
// enter in the first power.
//   (1) alternating in all four
//   (2) zero if two arguments are equal, with equal weights
//   (3) unchanged by a common translation, and by a number added to all weights
//   (4) in_circle_2 if the weights are equal
std::shared_ptr<const Predicate> make_power_2();

// disc_power_2(a, b, c, e): the same for w = r^2. Degree 4 in coordinates and radii.
//   (1) alternating in all four
//   (2) zero if two arguments are equal
//   (3) unchanged by a common translation
std::shared_ptr<const Predicate> make_disc_power_2();

// power_3(a, b, c, d, e): the negated determinant with rows (x, y, z, x^2 + y^2 + z^2 - w + w_e) of a - e,
// b - e, c - e, d - e. For orientation_3(a, b, c, d) > 0, positive iff e lies strictly below the hyperplane
// through the other four, all lifted. Degree 5 in t, times d, at most. Not homogeneous, as power_2.
//   (1) alternating in all five
//   (2) zero if two arguments are equal, with equal weights
//   (3) unchanged by a common translation, and by a number added to all weights
//   (4) in_sphere_3 if the weights are equal
std::shared_ptr<const Predicate> make_power_3();

// disc_power_3(a, b, c, d, e): the same for w = r^2, of balls. Degree 5 in coordinates and radii.
//   (1) alternating in all five
//   (2) zero if two arguments are equal
//   (3) unchanged by a common translation
std::shared_ptr<const Predicate> make_disc_power_3();

// The same polynomials under the same names, for certificates that fail at touches, too
// (core/arithmetic/touch.h).
std::shared_ptr<const Predicate> make_power_2_touch();
std::shared_ptr<const Predicate> make_power_3_touch();
std::shared_ptr<const Predicate> make_disc_power_2_touch();
std::shared_ptr<const Predicate> make_disc_power_3_touch();

// power_lifted(a, b, c, e): for points of one plane in space twice the determinant with rows
// (u, v, x^2 + y^2 + z^2 - w + w_e) of a - e, b - e, c - e on two axes u < v of space (named power_xy, power_xz,
// power_yz; power_2 does the same in the plane). For four points of one plane whose projections on these axes
// are not on one line, and a, b, c counter-clockwise in projection, positive iff e lies strictly below the plane
// through the other three, all lifted. Degree 4 in t, times d, at most. Not homogeneous, as power_2. Throws
// std::invalid_argument for other axes.
//   (1) alternating in all four
//   (2) zero if two arguments are equal, with equal weights
//   (3) unchanged by a common translation, and by a number added to all weights
//   (4) in_circle_lifted if the weights are equal
//   (5) on x and y: twice power_2 if all points have the same z
std::shared_ptr<const Predicate> make_power_lifted(int first, int second);

// disc_power_lifted(a, b, c, e): the same for w = r^2, of balls (named disc_power_xy, disc_power_xz,
// disc_power_yz). Degree 4 in coordinates and radii.
//   (1) alternating in all four
//   (2) zero if two arguments are equal
//   (3) unchanged by a common translation
std::shared_ptr<const Predicate> make_disc_power_lifted(int first, int second);

// The same polynomials under the same names, for certificates that fail at touches, too.
std::shared_ptr<const Predicate> make_power_lifted_touch(int first, int second);
std::shared_ptr<const Predicate> make_disc_power_lifted_touch(int first, int second);

}  // namespace kinex

#endif
