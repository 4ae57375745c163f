// SPDX-License-Identifier: GPL-3.0-or-later
// Hard bounds on structures of lines and points.
#ifndef KINEX_STRUCTURES_ARRANGEMENT_LINE_BOUNDS_H
#define KINEX_STRUCTURES_ARRANGEMENT_LINE_BOUNDS_H

#include <vector>

#include "core/engine/bound.h"

namespace kinex {

// By object: true for lines.
std::vector<bool> lines_of(const Scene& scene);

// The motion pieces of the lines, and of the points, that a structure is built from.
struct LinesAndPoints {
  LinesAndPoints(const BoundContext& context, const std::vector<bool>& is_line);
  std::vector<int> lines, points;
};

// Sum over all lines and points of the number of sign changes of a function of the two that is a
// polynomial of degree `degree` on each joint piece, and continuous where pieces meet:
// pair_sign_changes for pairs of a line and a point.
Integer side_changes(const LinesAndPoints& both, int degree);

// The same for all sets of two lines and a point. O(n).
Integer order_changes(const LinesAndPoints& both, int degree);

// The same for all sets of three objects: p, q and r pieces make at most p + q + r - 2 joint ones.
// degree * C(n, 3) if every object has one piece. O(n).
Integer triple_sign_changes(const std::vector<int>& pieces, int degree);

// The same for one function of each set of four objects. O(n).
Integer quadruple_sign_changes(const std::vector<int>& pieces, int degree);

}  // namespace kinex

#endif
