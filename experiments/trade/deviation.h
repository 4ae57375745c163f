// SPDX-License-Identifier: GPL-3.0-or-later
// Deviation: the distance of an inexact run's events from those of the exact run of its scene.
#ifndef KINEX_EXPERIMENTS_TRADE_DEVIATION_H
#define KINEX_EXPERIMENTS_TRADE_DEVIATION_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiments/trade/trace.h"

namespace kinex::trade {

inline constexpr std::size_t kUnmatched = static_cast<std::size_t>(-1);

// Two events are the same if kind and ids agree. Repeated events are matched in order, k-th with
// k-th; if one run has more of them, so that the matched times differ by the smallest sum. So
// missed and invented are differences of counts.
struct Deviation {
  std::uint64_t missed = 0;    // in the exact run only
  std::uint64_t invented = 0;  // in the inexact run only
  // Pairs of matched events in the wrong order: the earlier instant comes later. Events at one
  // exact instant are never in the wrong order.
  std::uint64_t inversions = 0;
  // Index (from 1) of the first event that is not due: of an exact instant any event may come
  // first, after all of those before it. 0: none. If a run has ended too early, the index after its
  // last.
  std::uint64_t first = 0;
  // rational_near the time of the due event in the exact run; past its end, that of the inexact run's
  // event, nullopt if it is no number.
  std::optional<Rational> first_time;
  // Of the matched events: |time - exact time|, from instants refined until 20 bits of it are
  // right, rounded up. A time that is no number counts as infinitely wrong.
  double error = 0;       // seconds: the scene's unit of time
  double error_ulps = 0;  // in ulp_of(exact time); events at exactly 0 have none and are left out
  std::uint64_t matched = 0;

  // Every event is there, in its place in time, and no other.
  bool same_events() const { return missed == 0 && invented == 0 && inversions == 0 && first == 0; }
};

// May refine the exact instants. O(m log m) for m events, except for those that repeat often.
Deviation deviation_of(ExactTrace& exact, const InexactTrace& inexact);

// For each exact event the matching inexact one, or kUnmatched.
std::vector<std::size_t> match_events(const ExactTrace& exact, const InexactTrace& inexact);

}  // namespace kinex::trade

#endif
