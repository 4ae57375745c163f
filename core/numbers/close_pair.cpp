// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/close_pair.h"

#include <utility>

#include "core/numbers/check.h"
#include "core/numbers/dyadic.h"

namespace kinex {

namespace {

Rational times_power(Rational value, unsigned long k) {
  mpq_mul_2exp(value.edit(), value.raw(), k);
  return value;
}

struct Bracket {
  Rational near, far;  // p has the sign `inside` at near and the opposite one at far
};

// A bracket of the only sign change between `inside` and `outside`, which is much nearer to
// `inside`, by galloping: the distances tried are unit * 2^k. |far - inside| = 2 |near - inside|,
// unless the sign changes within the first unit or `far` is `outside`.
Bracket gallop(const Polynomial& p, const Rational& inside, const Rational& outside,
               const Rational& unit, Sign sign_inside, Deadline* deadline) {
  const bool upwards = outside > inside;
  const auto at = [&](unsigned long k) {
    const Rational distance = times_power(unit, k);
    return upwards ? inside + distance : inside - distance;
  };
  const auto is_inside = [&](unsigned long k) {
    look(deadline);
    const Rational x = at(k);
    return (upwards ? x < outside : x > outside) && p.sign_at(x) == sign_inside;
  };
  if (!is_inside(0)) {
    const Rational x = at(0);
    const bool usable = (upwards ? x < outside : x > outside) && p.sign_at(x) == -sign_inside;
    return {inside, usable ? x : outside};
  }
  unsigned long low = 0;
  unsigned long high = 1;
  while (is_inside(high)) {
    low = high;
    high *= 2;
  }
  while (high - low > 1) {
    const unsigned long middle = low + (high - low) / 2;
    (is_inside(middle) ? low : high) = middle;
  }
  const Rational x = at(high);
  const bool usable = (upwards ? x < outside : x > outside) && p.sign_at(x) == -sign_inside;
  return {at(low), usable ? x : outside};
}

}  // namespace

std::optional<ClosePair> separate_close_pair(const Polynomial& p, const Rational& lower,
                                             const Rational& upper, RootCounters& counters) {
  const Sign outside = p.sign_at(lower);
  RealRoot extremum(p.derivative(), lower, upper);
  for (;;) {
    const Rational left = extremum.lower();
    const Rational right = extremum.upper();
    for (const Rational& x : {left, right}) {
      if (p.sign_at(x) != -outside) continue;
      const Rational unit = extremum.is_rational() ? (upper - lower) : right - left;
      Bracket first = gallop(p, x, lower, unit, -outside, counters.deadline);
      Bracket second = gallop(p, x, upper, unit, -outside, counters.deadline);
      return ClosePair{std::move(first.far), std::move(first.near), std::move(second.near),
                       std::move(second.far)};
    }
    if (extremum.is_rational()) {
      require(p.sign_at(left) == outside, "separate_close_pair: a multiple root");
      return std::nullopt;
    }
    const long exponent = std::max(dyadic_exponent(left), dyadic_exponent(right));
    const auto raised = [exponent](const Rational& x) {
      return x.numerator() << static_cast<unsigned long>(exponent - dyadic_exponent(x));
    };
    if (sign_on_interval(p, raised(left), raised(right), exponent)) return std::nullopt;
    extremum.refine(counters);
  }
}

}  // namespace kinex
