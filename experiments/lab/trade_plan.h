// SPDX-License-Identifier: GPL-3.0-or-later
// TradePlan: the sizes at which one structure is run in all arithmetics (`kinex trade`).
#ifndef KINEX_EXPERIMENTS_LAB_TRADE_PLAN_H
#define KINEX_EXPERIMENTS_LAB_TRADE_PLAN_H

#include <string_view>
#include <vector>

namespace kinex::lab {

// Each pair: the size for --quick, the full size.
struct TradePlan {
  std::string_view structure;
  int dimension;
  int uniform[2];          // uniform-square, of degree 1, 2 and 3
  std::string_view worst;  // the workload that is its worst case
  int worst_n[2];
  int grid[2];
  int near[2];               // near-one-point
  std::vector<int> bits[2];  // uniform-square: the sizes n at which the bits needed are counted
};

}  // namespace kinex::lab

#endif
