// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/arithmetic/root_namer.h"

#include <cmath>
#include <optional>
#include <utility>

#include "core/numbers/rational_root.h"
#include "core/numbers/real_root.h"

namespace kinex {

namespace {

// Bisections of a binade; roots that need more are named exactly.
constexpr int kMostHalvings = 48;
// Bits of the origin near a root that is not separated about 0.
constexpr int kOriginBits = 30;

// Whether the root of p in [lo, hi] is rational, and its value.
std::optional<Rational> decide_rational(const std::vector<Integer>& p, double lo, double hi) {
  if (lo == hi) return Rational::from_double(lo);
  if (lacks_rational_roots(p)) return std::nullopt;
  const Polynomial polynomial(p);
  RootCounters counters;
  RealRoot root(polynomial, *Rational::from_double(lo), *Rational::from_double(hi));
  if (const std::optional<Rational> guess = simplest_fraction(lo, hi)) {
    if (compare(root, *guess, counters) == 0) return guess;
  }
  return rational_value(polynomial, root, counters);
}

// The content; most polynomials are found to be primitive in machine words.
Integer content_of(const std::vector<Integer>& p) {
  Integer content = abs(p.back());
  for (std::size_t i = p.size() - 1; i-- > 0;) {
    if (mpz_size(content.raw()) > 1) {
      mpz_gcd(content.raw(), content.raw(), p[i].raw());
      continue;
    }
    const unsigned long word = mpz_get_ui(content.raw());
    if (word == 1) break;
    mpz_set_ui(content.raw(), mpz_gcd_ui(nullptr, p[i].raw(), word));
  }
  return content;
}

}  // namespace

void make_canonical(std::vector<Integer>& p) {
  const bool negative = p.back().sign() < 0;
  Integer content = content_of(p);
  if (mpz_cmp_ui(content.raw(), 1) == 0) {
    if (!negative) return;
    for (Integer& c : p) c.negate();
    return;
  }
  if (negative) content.negate();
  for (Integer& c : p) c.divide_exactly(content);
}

void set_rational_name(const Rational& value, InstantName& name) {
  name.polynomial = Polynomial({-value.numerator(), value.denominator()});
  name.root = 1;
  name.lower = name.upper = value;
}

bool RootNamer::name(std::vector<Integer>& p, double lo, double hi, InstantName& name) {
  while (!p.empty() && p.back().is_zero()) p.pop_back();
  if (p.size() < 2 || !std::isfinite(lo) || !std::isfinite(hi)) return false;
  make_canonical(p);
  if (p.size() == 2) {
    mpz_neg(mpq_numref(name.lower.edit()), p[0].raw());
    mpz_set(mpq_denref(name.lower.edit()), p[1].raw());
    name.upper = name.lower;
    name.root = 1;
    name.polynomial = Polynomial(std::move(p));
    return true;
  }
  if (const std::optional<Rational> value = decide_rational(p, lo, hi)) {
    set_rational_name(*value, name);
    return true;
  }
  if (!(lo > 0 || hi < 0)) return false;
  const int binade = std::ilogb(lo);
  if (std::ilogb(hi) != binade || std::abs(binade) > 1000) return false;
  Frame frame{0, binade};
  const bool found = (sturm_.make(p, frame.scale) && count(frame, lo, hi, name)) ||
                     (make_near(p, lo, frame) && count(frame, lo, hi, name));
  if (found) name.polynomial = Polynomial(std::move(p));
  return found;
}

// Halves the root's binade until the root is alone in its cell.
bool RootNamer::count(const Frame& frame, double lo, double hi, InstantName& name) const {
  const auto variations = [&](double t) -> std::optional<int> {
    const double x = t - frame.origin;
    if (x + frame.origin != t || t - x != frame.origin) return std::nullopt;
    return sturm_.variations(std::ldexp(x, -frame.scale));
  };
  const double near = std::ldexp(1.0, std::ilogb(lo)), far = 2 * near;
  double a = lo > 0 ? near : -far, b = lo > 0 ? far : -near;
  std::optional<int> at_a = variations(a), at_b = variations(b);
  for (int i = 0; at_a && at_b && i <= kMostHalvings; ++i) {
    if (*at_a - *at_b == 1) {
      name.root = sturm_.variations_at_minus_infinity() - *at_a + 1;
      mpq_set_d(name.lower.edit(), a);
      mpq_set_d(name.upper.edit(), b);
      return true;
    }
    const double middle = 0.5 * (a + b);
    if (lo > middle) {
      a = middle;
      at_a = variations(middle);
    } else if (hi < middle) {
      b = middle;
      at_b = variations(middle);
    } else {
      return false;
    }
  }
  return false;
}

// The sequence about a number of few bits near the root, computed exactly: for roots that are close
// to each other and far from 0.
bool RootNamer::make_near(const std::vector<Integer>& p, double lo, Frame& frame) {
  const int unit = std::ilogb(lo) - (kOriginBits - 1);
  const auto count = static_cast<std::int64_t>(std::ldexp(lo, -unit));
  frame.origin = std::ldexp(static_cast<double>(count), unit);
  frame.scale = unit;
  // In units of 2^-down, of which the origin is a multiple.
  const unsigned long down = unit < 0 ? static_cast<unsigned long>(-unit) : 0;
  Integer origin(count);
  if (unit > 0) origin <<= static_cast<unsigned long>(unit);
  shifted_ = p;
  const std::size_t n = p.size() - 1;
  for (std::size_t i = 0; i < n; ++i) shifted_[i] <<= down * (n - i);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = n; j-- > i;) shifted_[j].add_product(origin, shifted_[j + 1]);
  }
  return sturm_.make(shifted_, unit > 0 ? unit : 0);
}

}  // namespace kinex
