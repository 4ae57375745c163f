// SPDX-License-Identifier: GPL-3.0-or-later
// Unit directions in space: rational unit vectors that come close to every direction.
//
// s(a, b) = (2a, 2b, 1 - a^2 - b^2) / (1 + a^2 + b^2) is the point of the sphere that the
// stereographic projection from (0, 0, -1) sends to (a, b). It is taken for a = i/k and b = j/k
// with |i|, |j| <= r, where r is the integer nearest to (sqrt(2) - 1) k, and for the three cyclic
// shifts of the axes: at most 3 (2r + 1)^2 vectors.
//
// A direction whose largest coordinate is z >= 0 has |a|, |b| <= sqrt(2) - 1, so a vector is within
// 1 / (sqrt(2) k) of it in the plane, and |s(p) - s(q)| <= 2 |p - q|. So their inner product is at
// least 1 - 1/k^2. k = 1: three axes, bound 0; k = 2, 3: at most 27 vectors; k = 4, 5, 6: at most 75.
#ifndef KINEX_PREDICATES_POINTS_UNIT_DIRECTIONS_3_H
#define KINEX_PREDICATES_POINTS_UNIT_DIRECTIONS_3_H

#include "predicates/points/unit_directions.h"

namespace kinex {

// One of each pair of opposite directions. Requires k >= 1.
std::vector<DirectionVector> unit_directions_3(int k);

// In the plane unit_directions_2, in space unit_directions_3. Requires 2 or 3 axes.
std::vector<DirectionVector> unit_directions(int k, int dimension);

}  // namespace kinex

#endif
