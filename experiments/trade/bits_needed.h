// SPDX-License-Identifier: GPL-3.0-or-later
// The bits of precision needed to separate the instants of a run.
#ifndef KINEX_EXPERIMENTS_TRADE_BITS_NEEDED_H
#define KINEX_EXPERIMENTS_TRADE_BITS_NEEDED_H

#include <cstddef>
#include <optional>

#include "experiments/trade/trace.h"

namespace kinex::trade {

// For two consecutive distinct instants a < b: the significant bits of a number that separate them,
// ceil(log2(max(|a|, |b|) / (b - a))) + 1, at least 1. With that many bits the rounded times are at
// most neighbours of each other; a run that loses bits on its way needs more.
struct BitsNeeded {
  std::size_t instants = 0;
  std::size_t pairs = 0;   // of consecutive instants, and of the last one and the end
  long most = 0;           // 0: there are no pairs
  long percentile_99 = 0;  // nearest rank: at most 1 in 100 pairs needs more
  std::optional<Rational> time;  // rational_near the earlier instant of the pair that needs most
};

// Exact, from refined instants; a ratio within 2^-64 of a power of two counts as the larger one.
// `end`: the scene's end, at or after the last instant; a run must separate the two. May refine the
// instants.
BitsNeeded bits_needed(ExactTrace& exact, const Rational& end);

// For one pair; requires a < b.
long bits_between(RealRoot& a, RealRoot& b, RootCounters& counters);

}  // namespace kinex::trade

#endif
