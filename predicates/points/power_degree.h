// SPDX-License-Identifier: GPL-3.0-or-later
// The true degree of a lifted determinant of points whose weights may be of higher degree than their
// coordinates.
#ifndef KINEX_PREDICATES_POINTS_POWER_DEGREE_H
#define KINEX_PREDICATES_POINTS_POWER_DEGREE_H

#include <algorithm>

#include "core/arithmetic/predicate.h"

namespace kinex {

// The largest power of t, at most d, that an argument has on the axes in [first, last).
inline int degree_of(const MotionView<Ball>* points, int arity, int d, int first, int last) {
  for (int k = d; k > 0; --k) {
    for (int i = 0; i < arity; ++i) {
      for (int axis = first; axis < last; ++axis) {
        const Ball& c = points[i][axis * (d + 1) + k];
        if (c.value != 0 || c.error != 0) return k;
      }
    }
  }
  return 0;
}

// What the degree of a power depends on.
struct PowerShape {
  int arity;    // of the predicate
  int axes;     // of positions; the weight is the axis behind them
  int factors;  // coordinates in a term, besides a height
};

// Coefficients beyond the true degree are exact zeros. Motions of degree d; `out`: factors + 2 times d, and one.
inline void clear_beyond_degree(int d, const MotionView<Ball>* points, const PowerShape& shape,
                                Ball* out) {
  const int place = degree_of(points, shape.arity, d, 0, shape.axes);
  const int weight = degree_of(points, shape.arity, d, shape.axes, shape.axes + 1);
  const int true_degree = shape.factors * place + std::max(2 * place, weight);
  for (int k = true_degree + 1; k <= (shape.factors + 2) * d; ++k) out[k] = Ball{};
}

}  // namespace kinex

#endif
