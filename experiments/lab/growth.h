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

// Fits the counts of the family over its cells. A power is judged by judge_power (power_verdict.h), a law
// with logarithms by judge_law (law_verdict.h).
//
// Less data never confirm more. A claim asks for all cells of its family in the full experiments, and of
// each for the fewest scenes, from the first, that are as many and as precise as the cell says. Those
// decide, and nothing less confirms:
//   too few scenes    open; the check says about how many it takes
//   fewer cells       open; kAgrees if that is all that was asked for (--quick)
//   more scenes       decide nothing; if they would give another verdict, the check says that, with their
//                     numbers
GrowthResult judge_growth(const GrowthClaim& claim, const std::vector<CellResult>& cells);

}  // namespace kinex::lab

#endif
