// SPDX-License-Identifier: GPL-3.0-or-later
// PowerVerdict: counts against a claimed power.
#ifndef KINEX_EXPERIMENTS_LAB_POWER_VERDICT_H
#define KINEX_EXPERIMENTS_LAB_POWER_VERDICT_H

#include <optional>
#include <span>
#include <string>

#include "experiments/lab/fit.h"
#include "experiments/lab/verdict.h"

namespace kinex::lab {

struct ClaimedPower {
  double exponent = 1;
  double tolerance = 0.03;
  bool at_most = false;  // or slower
  // The term of lower order of a power that is not one alone: n^(exponent - lower_order). That of
  // n (n - 1), of a + b n, and of Delaunay events of points in a square is 1.
  double lower_order = 1;
};

struct PowerVerdict {
  std::optional<Fit> fit;
  // With a term of lower order, if chance does not explain the chi squared of `fit`.
  std::optional<Fit> corrected;
  Verdict verdict = Verdict::kOpen;
  std::string observed;
};

//   confirmed  the confidence interval of the exponent lies within the tolerance
//   refuted    it lies outside
//   open       otherwise
// Where chance does not explain the chi squared of the fit, the interval is that of the fit with a
// term of lower order; if chance does not explain that one either, nothing is confirmed, and
// refuted only what both intervals refute. Nothing is confirmed of fewer than three points (four
// without standard errors). `x` names the variable.
PowerVerdict judge_power(std::span<const FitPoint> points, const ClaimedPower& claim,
                         const std::string& x);

}  // namespace kinex::lab

#endif
