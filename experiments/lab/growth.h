// SPDX-License-Identifier: GPL-3.0-or-later
// Growth: fits the counts of a family of cells, and compares the fit with what is claimed.
#ifndef KINEX_EXPERIMENTS_LAB_GROWTH_H
#define KINEX_EXPERIMENTS_LAB_GROWTH_H

#include <optional>
#include <vector>

#include "experiments/lab/judge.h"
#include "experiments/lab/neighbours.h"

namespace kinex::lab {

struct GrowthResult {
  GrowthClaim claim;
  std::vector<FitPoint> points;  // ascending n
  std::optional<Fit> fit;        // of a power
  // The power with a term of lower order, if chance does not explain the chi squared of `fit`.
  std::optional<Fit> corrected;
  std::optional<Neighbours> neighbours;  // of a law, not of a bound
  Check check;
};

// Fits the counts of the family over its cells. A power is judged by judge_power
// (power_verdict.h).
// A law with logarithms is judged by the bend of the counts over it (bend_of): confirmed if the
// bend's interval lies within the tolerance, refuted if it lies outside, else open; and open if a
// neighbour fits better, or (unless the law is a bound) one is indistinguishable from it.
// Nothing is confirmed from fewer cells than the claim has, or, for a law with logarithms, from
// fewer than six sizes. There is no judgement at all if a cell has fewer seeds than its least
// number, or too few for its required precision. So less data never confirm more.
GrowthResult judge_growth(const GrowthClaim& claim, const std::vector<CellResult>& cells);

// The departure of the counts from a + b law: c (G / 2)^2 over the mean count, of the fit
// a + b law + c law^2 over a range G of the law. 0 for a straight line, and above 0 for what grows
// faster.
struct Bend {
  double value = 0;
  double lower = 0, upper = 0;  // 95 % confidence interval
};
// nullopt for fewer than four points.
std::optional<Bend> bend_of(const std::vector<FitPoint>& points, const Law& law);

}  // namespace kinex::lab

#endif
