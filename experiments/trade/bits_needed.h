// SPDX-License-Identifier: GPL-3.0-or-later
// How many bits of precision the instants of a run need in order to be told apart.
#ifndef KINEX_EXPERIMENTS_TRADE_BITS_NEEDED_H
#define KINEX_EXPERIMENTS_TRADE_BITS_NEEDED_H

#include <cstddef>
#include <string>

#include "experiments/trade/trace.h"

namespace kinex {

// For two distinct instants a < b that follow each other: the significant bits of a number that
// tell them apart, ceil(log2(max(|a|, |b|) / (b - a))) + 1, at least 1. With so many bits the
// rounded times are at most one another's neighbours; a run that loses bits on its way needs more.
struct BitsNeeded {
  std::size_t instants = 0;
  std::size_t pairs = 0;   // of instants that follow each other, and of the last one and the end
  long most = 0;           // 0: there are no pairs
  long percentile_99 = 0;  // nearest rank: no more than 1 in 100 pairs need more
  std::string time;        // decimal: the earlier of the pair that needs most
};

// Exact, from refined instants; where the ratio is within 2^-64 of a power of two the larger one
// is said. `end`: of the scene, at or after the last instant: a run has to know that this comes
// before. May refine the instants.
BitsNeeded bits_needed(ExactTrace& exact, const Rational& end);

// For one pair; requires a < b.
long bits_between(RealRoot& a, RealRoot& b, RootCounters& counters);

}  // namespace kinex

#endif
