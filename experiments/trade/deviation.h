// SPDX-License-Identifier: GPL-3.0-or-later
// Deviation: how far the events of an inexact run are from those of the exact run of its scene.
#ifndef KINEX_EXPERIMENTS_TRADE_DEVIATION_H
#define KINEX_EXPERIMENTS_TRADE_DEVIATION_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiments/trade/trace.h"

namespace kinex {

inline constexpr std::size_t kUnmatched = static_cast<std::size_t>(-1);

// Two events are the same if kind and ids agree. An event that occurs several times is matched in
// order, k-th with k-th; where one run has it more often, so that the times that are matched
// differ by the smallest sum. So missed and invented are the differences of the counts.
struct Deviation {
  std::uint64_t missed = 0;    // in the exact run only
  std::uint64_t invented = 0;  // in the inexact run only
  // Pairs of matched events in the wrong order: the earlier instant comes later. Events at one
  // exact instant are in no wrong order.
  std::uint64_t inversions = 0;
  // The first event of the inexact run, from 1, that is not among those that are due: of an exact
  // instant any event may come first, after all of those before it. 0: none. Where a run has ended
  // too early it is the one after its last.
  std::uint64_t first = 0;
  std::string first_time;  // decimal: when the exact run has the event that is due
  // Of the matched events: |time - exact time|, from instants refined until 20 bits of it are
  // right, and rounded up. An event whose time is no number counts as infinitely wrong.
  double error = 0;       // seconds: the scene's unit of time
  double error_ulps = 0;  // in ulp_of(exact time); events at exactly 0 have none and are left out
  std::uint64_t matched = 0;

  // Every event is there, in its place in time, and none other.
  bool same_events() const { return missed == 0 && invented == 0 && inversions == 0 && first == 0; }
};

// May refine the exact instants. O(m log m) for m events, but for those that occur often.
Deviation deviation_of(ExactTrace& exact, const InexactTrace& inexact);

// For each exact event the inexact one that it is matched with, or kUnmatched.
std::vector<std::size_t> match_events(const ExactTrace& exact, const InexactTrace& inexact);

}  // namespace kinex

#endif
