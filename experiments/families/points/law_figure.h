// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of a law of growth: means with their errors, the laws fitted to them, and what each fit
// leaves, in standard errors.
#ifndef KINEX_EXPERIMENTS_FAMILIES_POINTS_LAW_FIGURE_H
#define KINEX_EXPERIMENTS_FAMILIES_POINTS_LAW_FIGURE_H

#include <string>
#include <vector>

#include "experiments/lab/fit.h"
#include "experiments/lab/gnuplot.h"

namespace kinex::families {

struct LawNames {
  std::string title;      // of the caption
  std::string statement;  // above the picture
  std::string counted;    // of the upper y axis
  double exponent;        // of a claimed power, drawn as a guide; 0: a law with logarithms
};

// Requires at least two points; the fits are fits to them.
lab::Figure law_figure(const LawNames& names, const std::vector<lab::FitPoint>& points,
                       const std::vector<lab::Fit>& fits);

}  // namespace kinex::families

#endif
