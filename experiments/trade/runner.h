// SPDX-License-Identifier: GPL-3.0-or-later
// Runner: all cases of the trade, several at a time where asked to, and how bits needed grow.
#ifndef KINEX_EXPERIMENTS_TRADE_RUNNER_H
#define KINEX_EXPERIMENTS_TRADE_RUNNER_H

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/trade/case_run.h"
#include "experiments/verify/statistics.h"

namespace kinex {

// The scenes of one size.
struct BitsResult {
  BitsCase which;
  RunningMean most, percentile_99;  // bits needed, over the scenes
  RunningMean instants;             // distinct ones
};

// The smallest gap shrinks like n^-exponent: bits grow by `exponent` for every doubling of n.
struct BitsGrowth {
  std::string structure, family;
  std::optional<PowerFit> most, percentile_99;  // of 2^bits over n
};

struct TradeResult {
  std::vector<CaseResult> cases;  // those that were finished
  std::vector<BitsResult> bits;
  std::vector<BitsGrowth> growths;
  bool interrupted = false;
  bool gave_up() const;  // an exact arithmetic did
  std::vector<std::string> faults() const;
};

struct TradeWatch {
  // Something is about to be done; from all threads. Indices: cases, then bits.
  std::function<void(std::size_t index, const std::string& what)> on_work;
  std::function<void(std::size_t index)> on_finished;  // one at a time, in order
  std::function<void(const CaseResult&)> on_case;
  std::function<void(const BitsResult&)> on_bits;
};

// What comes out does not depend on the number of jobs, times aside.
TradeResult run_trade(const TradeCatalogue& catalogue, const TradeOptions& options,
                      const TradeWatch& watch);

// Fits every family of three sizes or more. 2^bits has to be a double: families that need more than
// 1000 bits have no fit.
std::vector<BitsGrowth> fit_bits(const std::vector<BitsResult>& bits);

}  // namespace kinex

#endif
