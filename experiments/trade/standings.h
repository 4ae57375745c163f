// SPDX-License-Identifier: GPL-3.0-or-later
// The standing of each arithmetic over all scenes.
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
  std::array<int, 3> cases{};  // by Standing
};
// In the order of the first case's runs.
std::vector<ArithmeticStandings> standings_of(const TradeResult& result);

// Structures in the order of the cases, without repetitions.
std::vector<std::string> structures_of(const TradeResult& result);

}  // namespace kinex::trade

#endif
