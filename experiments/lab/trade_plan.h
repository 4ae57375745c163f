// SPDX-License-Identifier: GPL-3.0-or-later
// TradePlan: the sizes at which one structure is run in all arithmetics (`kinex trade`).
#ifndef KINEX_EXPERIMENTS_LAB_TRADE_PLAN_H
#define KINEX_EXPERIMENTS_LAB_TRADE_PLAN_H

#include <string_view>
#include <vector>

namespace kinex::lab {

// A size is the parameter n of a workload. Of two sizes the first is for --quick, the second for a
// full run.
struct TradePlan {
  std::string_view structure;
  int dimension;
  // The size of uniform-square, which is run with motions of degree 1, 2 and 3.
  int uniform[2];
  // The workload that is the structure's worst case.
  std::string_view worst;
  // The size of the workload `worst`, which is run with linear motions.
  int worst_n[2];
  // The size of grid, which is run with linear motions.
  int grid[2];
  // The size of near-one-point, whose objects all pass within 2^-60 of one point at one instant.
  int near[2];
  // The sizes of uniform-square at which `trade` counts the bits that separate consecutive instants,
  // in motions of degree 1, 2 and 3.
  std::vector<int> bits[2];
};

}  // namespace kinex::lab

#endif
