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
  std::string axis;              // of the family's cells (Axis::name)
  std::vector<FitPoint> points;  // ascending values of that
  std::optional<Fit> fit;        // of a power
  std::optional<Fit> corrected;  // the power with a term of lower order: PowerVerdict::corrected
  std::optional<Neighbours> neighbours;  // of a law, not of a bound
  Check check;
};

// Fits the counts of the family over its cells. A power is judged by judge_power
// (power_verdict.h).
// A law with logarithms is judged by judge_law (law_verdict.h).
// Nothing is confirmed from fewer cells than the claim has. There is no judgement at all if a cell has
// fewer seeds than its least number, or too few for its required precision: no part of the data that a
// claim requires confirms what the whole does not. Data beyond those may show a misfit that smaller
// samples hide: their chi squared is then bad, and the claim, which they confirmed, is open again.
GrowthResult judge_growth(const GrowthClaim& claim, const std::vector<CellResult>& cells);

}  // namespace kinex::lab

#endif
