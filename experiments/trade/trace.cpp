// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/trade/trace.h"

#include <utility>

#include "core/arithmetic/arithmetic.h"

namespace kinex::trade {

namespace {

constexpr int kDecimals = 17;
constexpr long kTraceBits = 60;  // 2^-60 < 10^-kDecimals / 8

Integer floor_of(const Rational& x) { return floor_divide(x.numerator(), x.denominator()); }

}  // namespace

std::uint32_t EventNames::number(const Event& event) {
  Name name{};
  name[0] = event.kind;
  name[1] = event.count;
  for (std::size_t i = 0; i < event.count; ++i) name[i + 2] = event.ids[i];
  return numbers_.emplace(name, static_cast<std::uint32_t>(numbers_.size())).first->second;
}

void ExactRecorder::event(const Event& event, Arithmetic& arithmetic) {
  const InstantName& now = arithmetic.name_now(InstantDetail::kName);
  if (trace.times.empty() || now.number != last_) {
    last_ = now.number;
    RealRoot root = to_root(now);
    // One instant can have two names: as a root of two polynomials.
    if (trace.times.empty() || compare(trace.times.back(), root, counters_) != 0) {
      trace.times.push_back(std::move(root));
    }
  }
  trace.names.push_back(names_.number(event));
  trace.instants.push_back(static_cast<std::uint32_t>(trace.times.size() - 1));
}

void InexactRecorder::event(const Event& event, Arithmetic& arithmetic) {
  trace.names.push_back(names_.number(event));
  trace.times.push_back(arithmetic.now_value());
}

bool equal(ExactTrace& a, ExactTrace& b) {
  if (a.names != b.names || a.instants != b.instants) return false;
  RootCounters counters;
  for (std::size_t i = 0; i < a.times.size(); ++i) {
    if (compare(a.times[i], b.times[i], counters) != 0) return false;
  }
  return true;
}

Rational rational_near(RealRoot& instant, RootCounters& counters) {
  const Rational scale(power(Integer(10), kDecimals));
  instant.refine_to(kTraceBits, counters);
  while (!instant.is_rational()) {
    const Integer high = floor_of(instant.upper() * scale);
    // Between two multiples of 10^-kDecimals all numbers have the same decimals.
    if (floor_of(instant.lower() * scale) == high) {
      return (instant.lower() + instant.upper()) / Rational(2);
    }
    if (compare(instant, Rational(high) / scale, counters) == 0) return Rational(high) / scale;
    instant.refine(counters);
  }
  return instant.value();
}

std::string time_decimal(const Rational& time) { return decimal(time, kDecimals); }

std::optional<std::string> time_decimal(const std::optional<Rational>& time) {
  if (!time) return std::nullopt;
  return time_decimal(*time);
}

}  // namespace kinex::trade
