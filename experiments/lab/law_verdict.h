// SPDX-License-Identifier: GPL-3.0-or-later
// LawVerdict: counts against a claimed law with logarithms, and that law against its neighbours.
#ifndef KINEX_EXPERIMENTS_LAB_LAW_VERDICT_H
#define KINEX_EXPERIMENTS_LAB_LAW_VERDICT_H

#include <optional>
#include <span>
#include <string>

#include "experiments/lab/neighbours.h"
#include "experiments/lab/verdict.h"

namespace kinex::lab {

struct ClaimedLaw {
  Law law;                 // of a + b law(x), with logarithms
  double tolerance = 0.1;  // of the bend
  bool at_most = false;    // or slower
};

struct LawVerdict {
  std::string expected, observed;
  Verdict verdict = Verdict::kOpen;
  std::optional<Neighbours> neighbours;
};

// Judged by the bend of the counts over the law (bend_of): confirmed if the bend's interval lies within
// the tolerance, refuted if it lies outside, else open. Open too if a neighbour fits better or is
// indistinguishable from it, and for fewer than six sizes. Of a bound (at_most) only neighbours that grow
// faster count, each against the law or a slower one; and none if the counts hardly grow: all of the
// interval of their power of x is below 0.02, where all laws with a small factor fit. So less data never
// confirms more. `x` names the variable.
LawVerdict judge_law(std::span<const FitPoint> points, const ClaimedLaw& claim, const std::string& x);

// The departure of the counts from a + b law: c (G / 2)^2 over the mean count, of the fit
// a + b law + c law^2 over a range G of the law. 0 for a straight line, and above 0 for what grows
// faster.
struct Bend {
  double value = 0;
  double lower = 0, upper = 0;  // 95 % confidence interval
};
// nullopt for fewer than four points.
std::optional<Bend> bend_of(std::span<const FitPoint> points, const Law& law);

}  // namespace kinex::lab

#endif
