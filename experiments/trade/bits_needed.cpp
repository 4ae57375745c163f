// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/trade/bits_needed.h"

#include <algorithm>
#include <vector>

#include "experiments/lab/binary_scale.h"

namespace kinex::trade {

namespace {

constexpr long kSure = 64;

struct Range {
  Rational lower, upper;
};

// Of |x| for x in [lower, upper].
Range magnitude(const Rational& lower, const Rational& upper) {
  if (lower.sign() >= 0) return {lower, upper};
  if (upper.sign() <= 0) return {-upper, -lower};
  return {Rational(0), std::max(-lower, upper)};
}

}  // namespace

long bits_between(RealRoot& a, RealRoot& b, RootCounters& counters) {
  for (;;) {
    const Range gap{b.lower() - a.upper(), b.upper() - a.lower()};
    const Range size_a = magnitude(a.lower(), a.upper());
    const Range size_b = magnitude(b.lower(), b.upper());
    const Range size{std::max(size_a.lower, size_b.lower), std::max(size_a.upper, size_b.upper)};
    if (gap.lower.sign() > 0 && size.lower.sign() > 0) {
      const Rational least = size.lower / gap.upper, most = size.upper / gap.lower;
      const long bits = lab::ceil_log2(most);
      const bool decided = lab::ceil_log2(least) == bits;
      if (decided || (most - least) * lab::power_of_two(kSure) <= least) return std::max(1L, bits + 1);
    }
    a.refine(counters);
    b.refine(counters);
  }
}

BitsNeeded bits_needed(ExactTrace& exact, const Rational& end) {
  BitsNeeded result;
  RootCounters counters;
  std::vector<long> bits;
  const auto add = [&](RealRoot& a, RealRoot& b) {
    bits.push_back(bits_between(a, b, counters));
    if (bits.back() <= result.most) return;
    result.most = bits.back();
    result.time = rational_near(a, counters);
  };
  result.instants = exact.times.size();
  for (std::size_t i = 1; i < exact.times.size(); ++i) add(exact.times[i - 1], exact.times[i]);
  if (!exact.times.empty() && compare(exact.times.back(), end, counters) < 0) {
    RealRoot last(end);
    add(exact.times.back(), last);
  }
  result.pairs = bits.size();
  if (bits.empty()) return result;
  const std::size_t rank = (bits.size() * 99 + 99) / 100;  // from 1
  std::nth_element(bits.begin(), bits.begin() + static_cast<std::ptrdiff_t>(rank - 1), bits.end());
  result.percentile_99 = bits[rank - 1];
  return result;
}

}  // namespace kinex::trade
