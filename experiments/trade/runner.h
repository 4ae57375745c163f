// SPDX-License-Identifier: GPL-3.0-or-later
// Runner: all cases of the trade, several at a time if requested, and the growth of bits needed.
#ifndef KINEX_EXPERIMENTS_TRADE_RUNNER_H
#define KINEX_EXPERIMENTS_TRADE_RUNNER_H

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/lab/fit.h"
#include "experiments/lab/statistics.h"
#include "experiments/trade/case_run.h"

namespace kinex::trade {

// The scenes of one size of a family.
struct BitsResult {
  BitsCase which;
  lab::RunningMean most, percentile_99;  // bits needed, over the scenes
  lab::RunningMean instants;             // distinct ones
};

// The smallest gap shrinks like n^-exponent: bits grow by `exponent` with every doubling of n.
struct BitsGrowth {
  std::string structure, family;
  std::optional<lab::Fit> most, percentile_99;  // of 2^bits over n
};

struct TradeResult {
  std::vector<CaseResult> cases;  // those that finished
  std::vector<BitsResult> bits;
  std::vector<BitsGrowth> growths;
  bool interrupted = false;
  bool gave_up() const;  // true if an exact arithmetic gave up
  std::vector<std::string> faults() const;
};

struct TradeWatch {
  // Work is about to start. Called from any thread, several at a time. Indices: cases, then bits.
  std::function<void(std::size_t index, const std::string& what)> on_work;
  std::function<void(std::size_t index)> on_finished;  // one at a time, in order
  std::function<void(const CaseResult&)> on_case;
  std::function<void(const BitsResult&)> on_bits;
};

// All scenes of one size; nullopt if go_on returns false or a run gave up.
std::optional<BitsResult> run_bits(const BitsCase& which, const TradeOptions& options);

// Results do not depend on the number of jobs, times aside.
TradeResult run_trade(const TradeCatalogue& catalogue, const TradeOptions& options,
                      const TradeWatch& watch);

// Fits every family of at least three sizes. 2^bits must be a double: families that need more than
// 1000 bits have no fit.
std::vector<BitsGrowth> fit_bits(const std::vector<BitsResult>& bits);

}  // namespace kinex::trade

#endif
