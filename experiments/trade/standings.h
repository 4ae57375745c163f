// SPDX-License-Identifier: GPL-3.0-or-later
// Standings of `kinex trade`: for each arithmetic, how many of its runs were the same as the exact
// run, valid, or wrong (Standing in case_run.h).
#ifndef KINEX_EXPERIMENTS_TRADE_STANDINGS_H
#define KINEX_EXPERIMENTS_TRADE_STANDINGS_H

#include <array>
#include <string>
#include <vector>

#include "experiments/trade/runner.h"

namespace kinex::trade {

std::string_view standing_name(Standing standing);  // "same", "valid", "wrong"

struct ArithmeticStandings {
  std::string arithmetic;
  std::array<int, 3> cases{};  // number of cases, indexed by Standing
};
// One entry for each arithmetic that was run, in the order of the first case's runs.
std::vector<ArithmeticStandings> standings_of(const TradeResult& result);

// Structures in the order of the cases, without repetitions.
std::vector<std::string> structures_of(const TradeResult& result);

}  // namespace kinex::trade

#endif
