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
  // Other orders that the term may have as well, if it is not known: see below.
  std::span<const double> other_orders = {};
};

struct PowerVerdict {
  std::optional<Fit> fit;
  // With a term of lower order, if chance does not explain the chi squared of `fit`, or if the interval
  // of `fit` would refute the claim.
  std::optional<Fit> corrected;
  Verdict verdict = Verdict::kOpen;
  std::string observed;
};

//   confirmed  the confidence interval of the exponent lies within the tolerance
//   refuted    it lies outside
//   open       otherwise
// A claim is about large x, and sizes are finite: a term of lower order shifts the exponent of the fit.
// So that term is fitted, too,
//   - where chance does not explain the chi squared of the fit: the interval is then that of the fit
//     with the term. If chance does not explain its chi squared either, nothing is confirmed, and
//     refuted only what both intervals refute. If both do, from different sides, the claim is open: one
//     term moves the exponent past it, and another could bring it back;
//   - where the interval of the fit lies outside: refuted only if the claimed power with the term does
//     not fit, else open. It does not if chance does not explain its chi squared, for any exponent
//     within the tolerance; without standard errors, if the interval of the fit with the term lies
//     outside as well. (Fewer than four points determine no such term. Four without standard errors do
//     if its interval is narrower than that of the fit without it.)
//   - where the interval of the fit is partly outside, without standard errors: confirmed if, from at
//     least five points, the interval of the fit with the term is narrower and within the tolerance.
// If the order of that term is not known (`other_orders` is not empty), and the points have standard errors,
// fits with a term of each order are made. The claim stays confirmed only if every one that chance explains has
// its exponent within the tolerance: a choice of the order must not decide.
// Nothing is confirmed from fewer than three points (four without standard errors). `x` names the
// variable.
PowerVerdict judge_power(std::span<const FitPoint> points, const ClaimedPower& claim,
                         const std::string& x);

}  // namespace kinex::lab

#endif
