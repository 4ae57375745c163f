// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/arithmetic/sturm_name.h"

#include <optional>
#include <utility>
#include <vector>

#include "core/numbers/instant_digits.h"

namespace kinex {

namespace {

// An integer over a power of two.
struct Dyadic {
  Integer numerator;
  unsigned long exponent = 0;
};

Rational value_of(const Dyadic& x) {
  return Rational(x.numerator, Integer::power_of_two(x.exponent));
}

Dyadic dyadic_of(const Rational& x, unsigned long exponent) {
  const Rational scaled = x * Rational(Integer::power_of_two(exponent));
  return {scaled.numerator(), exponent};
}

int sign_at(const std::vector<Integer>& p, const Dyadic& x) {
  Integer value = p.back();
  unsigned long shift = 0;
  for (std::size_t i = p.size() - 1; i-- > 0;) {
    shift += x.exponent;
    value = value * x.numerator + (p[i] << shift);
  }
  return value.sign();
}

// Coprime integers, the last one positive.
std::vector<Integer> canonical(RationalPolynomial p) {
  if (p.leading().sign() < 0) p = -std::move(p);
  p.normalise();
  std::vector<Integer> c;
  for (const Rational& q : p.coefficients()) c.push_back(q.numerator());
  return c;
}

// The root of p in (lower, upper), where it is alone and p changes sign, if it is rational: its
// denominator divides the leading coefficient, so an interval shorter than half of one over that
// holds one candidate at most.
std::optional<Rational> rational_root(const std::vector<Integer>& p, const Rational& lower,
                                      const Rational& upper) {
  const unsigned long exponent =
      std::max(lower.denominator().bit_length(), upper.denominator().bit_length()) - 1;
  Dyadic a = dyadic_of(lower, exponent), b = dyadic_of(upper, exponent);
  const int sign = sign_at(p, a);
  while (((b.numerator - a.numerator) * p.back() << 1) > Integer::power_of_two(a.exponent)) {
    a = {a.numerator << 1, a.exponent + 1};
    b = {b.numerator << 1, b.exponent + 1};
    const Dyadic middle{(a.numerator + b.numerator) >> 1, a.exponent};
    const int at_middle = sign_at(p, middle);
    if (at_middle == 0) return value_of(middle);
    (at_middle == sign ? a : b) = middle;
  }
  // k / leading between a and b.
  const Rational leading(p.back());
  const Rational scaled = value_of(a) * leading;
  const Rational candidate(floor_divide(scaled.numerator(), scaled.denominator()) + Integer(1),
                           p.back());
  if (candidate >= value_of(b)) return std::nullopt;
  std::vector<Rational> c;
  for (const Integer& x : p) c.emplace_back(x);
  if (!RationalPolynomial(std::move(c)).value_at(candidate).is_zero()) return std::nullopt;
  return candidate;
}

void set_rational(const Rational& value, InstantName& name) {
  name.polynomial = Polynomial({-value.numerator(), value.denominator()});
  name.root = 1;
  name.lower = name.upper = value;
  set_decimal(name.decimal, value);
}

}  // namespace

void name_by_sturm(const RationalPolynomial& p, SturmInstant instant, InstantName& name) {
  SturmWork work;
  const auto compare = [&](const Rational& t) { return instant.compare(t); };
  const auto refine = [&] { instant.refine(work); };
  const RationalSturm sturm(p, work);
  const RationalPolynomial& simple = sturm.square_free();
  // Until the instant is the only root of p between two dyadic numbers that are not roots.
  const auto alone = [&](const Rational& a, const Rational& b) {
    return sturm.count(a, b) == 1 && simple.sign_at(a) != Sign::kZero &&
           simple.sign_at(b) != Sign::kZero;
  };
  while (!instant.is_rational() && !(instant.lower().is_dyadic() && instant.upper().is_dyadic() &&
                                     alone(instant.lower(), instant.upper()))) {
    instant.refine(work);
  }
  if (instant.is_rational()) return set_rational(instant.lower(), name);
  std::vector<Integer> c = canonical(simple);
  if (const auto value = rational_root(c, instant.lower(), instant.upper())) {
    return set_rational(*value, name);
  }
  name.root = sturm.variations_at_minus_infinity() - sturm.variations(instant.upper());
  // The fewest bits whose cell holds no other root: by doubling, then by halving.
  const bool negative = sign_of_instant(instant, compare, refine) < 0;
  const auto isolates = [&](long bits) {
    set_interval(leading_bits(instant, bits, compare, refine), negative, name.lower, name.upper);
    return alone(name.lower, name.upper);
  };
  long few = 0, bits = 1;
  while (!isolates(bits)) few = std::exchange(bits, 2 * bits);
  while (bits - few > 1) {
    const long middle = few + (bits - few) / 2;
    (isolates(middle) ? bits : few) = middle;
  }
  isolates(bits);
  name.polynomial = Polynomial(std::move(c));
  set_exact_decimal(name.decimal, instant, compare, refine);
}

void enclose_by_sturm(SturmInstant instant, InstantName& name) {
  SturmWork work;
  const auto compare = [&](const Rational& t) { return instant.compare(t); };
  const auto refine = [&] { instant.refine(work); };
  name.polynomial = Polynomial();
  name.root = 0;
  set_exact_interval(instant, compare, refine, name.lower, name.upper);
  set_exact_decimal(name.decimal, instant, compare, refine);
}

}  // namespace kinex
