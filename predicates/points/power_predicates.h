// SPDX-License-Identifier: GPL-3.0-or-later
// Predicates on points of the plane with weights, and on discs, whose weights are the squares of
// their radii. The weight, or the radius, is the axis behind those of the position. The lifted height
// of a point is x^2 + y^2 - w. d is the largest degree of motions and weights, or radii.
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

}  // namespace kinex

#endif
