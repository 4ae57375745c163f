// SPDX-License-Identifier: GPL-3.0-or-later
// Unit directions: rational unit vectors that extents are measured along.
//
// For k >= 1: u(q) = ((1 - q^2) / (1 + q^2), 2q / (1 + q^2)) for q = 0, 1/k, .., (k-1)/k, which has
// the angle 2 atan(q), and these turned by 90, 180 and 270 degrees: 4k unit vectors. The largest
// angle between neighbours is g = 2 atan(1/k), so every direction is within g/2 of one of them, and
// cos^2(g/2) = k^2 / (k^2 + 1). k = 1: the four sides of a box; k = 2: eight directions, at 0, 53.1,
// 90, 143.1, .. degrees.
#ifndef KINEX_PREDICATES_POINTS_UNIT_DIRECTIONS_H
#define KINEX_PREDICATES_POINTS_UNIT_DIRECTIONS_H

#include <vector>

#include "core/numbers/rational.h"

namespace kinex {

using DirectionVector = std::vector<Rational>;  // one entry per axis

// One of each pair of opposite directions: 2k of the 4k, counter-clockwise from the positive x
// axis. Direction i + 2k is the opposite of direction i. Requires k >= 1.
std::vector<DirectionVector> unit_directions_2(int k);

}  // namespace kinex

#endif
