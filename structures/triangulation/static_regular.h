// SPDX-License-Identifier: GPL-3.0-or-later
// The static algorithm for regular triangulations in the plane and in space, right after now: points are
// inserted one by one (point_location.h), and those that come to lie above the lower hull are hidden.
#ifndef KINEX_STRUCTURES_TRIANGULATION_STATIC_REGULAR_H
#define KINEX_STRUCTURES_TRIANGULATION_STATIC_REGULAR_H

#include <span>

#include "structures/triangulation/regular_geometry.h"
#include "structures/triangulation/static_result.h"

namespace kinex {

// Triangulates `points`, distinct ids in the order of insertion; those that are no vertices of `store`
// afterwards are hidden. `quick`: inserts them in an order along a curve instead, for many points.
// kFlat: they are identically in one plane (on one line).
template <class Complex>
StaticResult build_static(const RegularGeometry<Complex>& geometry,
                          std::span<const ObjectId> points, bool quick,
                          typename Complex::Store& store);

}  // namespace kinex

#endif
