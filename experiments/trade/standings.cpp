// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/trade/standings.h"

#include <algorithm>

namespace kinex::trade {

std::string_view standing_name(Standing standing) {
  switch (standing) {
    case Standing::kSame:
      return "same";
    case Standing::kValid:
      return "valid";
    case Standing::kWrong:
      return "wrong";
  }
  return "";
}

std::vector<ArithmeticStandings> standings_of(const TradeResult& result) {
  std::vector<ArithmeticStandings> all;
  for (const CaseResult& one : result.cases) {
    for (const TradeRun& run : one.runs) {
      auto found = std::find_if(all.begin(), all.end(), [&](const ArithmeticStandings& other) {
        return other.arithmetic == run.arithmetic;
      });
      if (found == all.end()) {
        all.push_back({run.arithmetic, {}});
        found = all.end() - 1;
      }
      ++found->cases[static_cast<std::size_t>(run.standing())];
    }
  }
  return all;
}

std::vector<std::string> structures_of(const TradeResult& result) {
  std::vector<std::string> names;
  for (const CaseResult& one : result.cases) {
    if (std::find(names.begin(), names.end(), one.which.structure) == names.end()) {
      names.push_back(one.which.structure);
    }
  }
  return names;
}

}  // namespace kinex::trade
