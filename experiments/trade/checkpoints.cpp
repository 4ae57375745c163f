// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/trade/checkpoints.h"

#include <algorithm>
#include <cstddef>

namespace kinex::trade {

namespace {

constexpr int kByTime = 7;
constexpr int kWays = 97;
constexpr std::size_t kByCount = 3;

struct Gap {
  Rational lower, upper;  // inside, near its ends
};

// The first instant after t.
std::size_t instant_after(ExactTrace& exact, const Rational& t) {
  RootCounters counters;
  std::size_t low = 0, high = exact.times.size();
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (compare(exact.times[middle], t, counters) <= 0) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

// The gap below the instant `low`, refined until a sixteenth of it at most is lost at its ends.
Gap gap_below(ExactTrace& exact, std::size_t low, const Rational& start, const Rational& end) {
  RootCounters counters;
  for (;;) {
    const bool first = low == 0, last = low == exact.times.size();
    const Rational lost_below =
        first ? Rational(0) : exact.times[low - 1].upper() - exact.times[low - 1].lower();
    const Rational lost_above =
        last ? Rational(0) : exact.times[low].upper() - exact.times[low].lower();
    const Gap gap{first ? start : std::max(start, exact.times[low - 1].upper()),
                  last ? end : std::min(end, exact.times[low].lower())};
    const Rational width = gap.upper - gap.lower;
    if (width.sign() > 0 && std::max(lost_below, lost_above) * Rational(16) <= width) return gap;
    if (!first) exact.times[low - 1].refine(counters);
    if (!last) exact.times[low].refine(counters);
  }
}

}  // namespace

std::vector<Rational> checkpoints_of(ExactTrace& exact, const Rational& start,
                                     const Rational& end) {
  std::vector<Rational> result;
  for (int k = 1; k <= kByTime; ++k) {
    Rational t = start + (end - start) * Rational(Integer(12 * k + 1), Integer(kWays));
    const Gap gap = gap_below(exact, instant_after(exact, t), start, end);
    const Rational margin = (gap.upper - gap.lower) / Rational(8);
    result.push_back(std::clamp(t, gap.lower + margin, gap.upper - margin));
  }
  for (std::size_t k = 1; k <= kByCount; ++k) {
    const std::size_t i = exact.times.size() * k / (kByCount + 1);
    if (i == 0) continue;
    const Gap gap = gap_below(exact, i, start, end);
    result.push_back(gap.lower + (gap.upper - gap.lower) * Rational(Integer(15), Integer(32)));
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace kinex::trade
