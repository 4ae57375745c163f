// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/trade/checkpoints.h"

#include <algorithm>
#include <cstddef>

namespace kinex {

namespace {

constexpr int kCheckpoints = 7;
constexpr int kWays = 97;
// A nominal time is kept if it is this part of the gap away from both ends; else it is moved to
// kPlace of the gap.
const Rational& margin() {
  static const Rational kMargin(Integer(1), Integer(8));
  return kMargin;
}
const Rational& place() {
  static const Rational kPlace(Integer(15), Integer(32));
  return kPlace;
}

struct Gap {
  Rational lower, upper;  // inside, near its ends
};

// The gap that holds t, which may be the instant at its lower end; refined until what is lost at
// the ends is a sixteenth of it.
Gap gap_around(ExactTrace& exact, const Rational& t, const Rational& start, const Rational& end) {
  RootCounters counters;
  std::size_t low = 0, high = exact.times.size();  // the first instant after t
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (compare(exact.times[middle], t, counters) <= 0) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  for (;;) {
    const bool first = low == 0, last = low == exact.times.size();
    const Rational lost_below =
        first ? Rational(0) : exact.times[low - 1].upper() - exact.times[low - 1].lower();
    const Rational lost_above =
        last ? Rational(0) : exact.times[low].upper() - exact.times[low].lower();
    const Gap gap{first ? start : std::max(start, exact.times[low - 1].upper()),
                  last ? end : std::min(end, exact.times[low].lower())};
    if (std::max(lost_below, lost_above) * Rational(16) <= gap.upper - gap.lower) return gap;
    if (!first) exact.times[low - 1].refine(counters);
    if (!last) exact.times[low].refine(counters);
  }
}

}  // namespace

std::vector<Rational> checkpoints_of(ExactTrace& exact, const Rational& start,
                                     const Rational& end) {
  std::vector<Rational> result;
  for (int k = 1; k <= kCheckpoints; ++k) {
    Rational t = start + (end - start) * Rational(Integer(12 * k + 1), Integer(kWays));
    const Gap gap = gap_around(exact, t, start, end);
    if (!(gap.lower < gap.upper)) continue;  // an event at the end, and t after the one before
    const Rational width = gap.upper - gap.lower;
    if (t < gap.lower + margin() * width || t > gap.upper - margin() * width) {
      t = gap.lower + place() * width;
    }
    if (result.empty() || result.back() < t) result.push_back(std::move(t));
  }
  return result;
}

}  // namespace kinex
