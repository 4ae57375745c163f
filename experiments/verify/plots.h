// SPDX-License-Identifier: GPL-3.0-or-later
// The plots of the results: for every structure the observed counts and the hard bounds over n, on
// logarithmic axes, with fitted lines; and the residuals of every fit that leaves more than rounding.
#ifndef KINEX_EXPERIMENTS_VERIFY_PLOTS_H
#define KINEX_EXPERIMENTS_VERIFY_PLOTS_H

#include <string>
#include <vector>

#include "experiments/lab/gnuplot.h"
#include "experiments/verify/runner.h"

namespace kinex::verify {

// Families with fewer than three sizes are left out.
std::vector<lab::Figure> verify_figures(const VerifyResult& result);
// The titles of all figures that results of these experiments can have: before they are run.
std::vector<std::string> possible_titles(const lab::Catalogue& catalogue);

}  // namespace kinex::verify

#endif
