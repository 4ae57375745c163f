// SPDX-License-Identifier: GPL-3.0-or-later
// The residuals of a fitted power as a picture.
#ifndef KINEX_EXPERIMENTS_LAB_RESIDUAL_FIGURE_H
#define KINEX_EXPERIMENTS_LAB_RESIDUAL_FIGURE_H

#include <string>
#include <vector>

#include "experiments/lab/fit.h"
#include "experiments/lab/gnuplot.h"

namespace kinex::lab {

// What the picture says of itself: the title's two lines, and the axis.
struct ResidualWords {
  std::string structure, family, x;
};

// Sets the script and height of a figure: counts over the fit, in per cent, with bars of two standard
// errors, in the 95 % interval of the exponent. `points`: those that were fitted, ascending;
// `references`: other counts to be drawn beside them, may be empty.
void set_residuals(Figure& figure, const Fit& fit, const std::vector<FitPoint>& points,
                   const std::vector<FitPoint>& references, const ResidualWords& words);

}  // namespace kinex::lab

#endif
