// SPDX-License-Identifier: GPL-3.0-or-later
// Least squares with any number of columns.
#ifndef KINEX_EXPERIMENTS_LAB_LEAST_SQUARES_H
#define KINEX_EXPERIMENTS_LAB_LEAST_SQUARES_H

#include <optional>
#include <vector>

namespace kinex::lab {

struct LeastSquares {
  std::vector<double> coefficients;
  // 95 % confidence intervals by Student's t, as Fit has them: widened where the points scatter
  // more than their errors allow.
  std::vector<double> lower, upper;
  double chi_square = 0;  // weighted sum of squares
  int degrees = 0;        // of freedom
  bool weighted = false;  // every point has an error
};

// y = sum of coefficient times column. Columns are as long as y. Weighted by the errors of y where
// all are above 0, else unweighted. nullopt without a degree of freedom, or if the columns are
// linearly dependent.
std::optional<LeastSquares> least_squares(const std::vector<std::vector<double>>& columns,
                                          const std::vector<double>& y,
                                          const std::vector<double>& error);

}  // namespace kinex::lab

#endif
