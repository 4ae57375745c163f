// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/rational_root.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace kinex {

namespace {

constexpr std::size_t kMostCoefficients = 64;

// Up to this degree values need no intermediate reduction: with m = prime - 1 they are at most
// m^(degree + 1) (1 + 1 / (m - 1)), and 46^11 (1 + 1/45) < 2^64, 96^9 (1 + 1/95) < 2^64.
constexpr std::size_t short_degree(std::uint64_t prime) { return prime < 50 ? 10 : 8; }

// A root modulo a prime, one at infinity included.
template <std::uint64_t kPrime>
bool has_root_modulo(const std::uint64_t* c, std::size_t size) {
  const std::uint64_t leading = c[size - 1] % kPrime;
  if (leading == 0 || c[0] % kPrime == 0) return true;
  std::array<std::uint64_t, kMostCoefficients> residue;
  for (std::size_t i = 0; i + 1 < size; ++i) residue[i] = c[i] % kPrime;
  for (std::uint64_t x = 1; x < kPrime; ++x) {
    std::uint64_t value = leading;
    for (std::size_t i = size - 1; i-- > 0;) {
      value = value * x + residue[i];
      if (size > short_degree(kPrime) + 1) value %= kPrime;
    }
    if (value % kPrime == 0) return true;
  }
  return false;
}

// No root modulo one of these primes, whose product fits a word.
template <std::uint64_t... kPrimes>
bool lacks_roots_modulo_some(const std::vector<Integer>& c) {
  constexpr std::uint64_t kProduct = (kPrimes * ...);
  std::array<std::uint64_t, kMostCoefficients> residue;
  for (std::size_t i = 0; i < c.size(); ++i) residue[i] = mpz_fdiv_ui(c[i].raw(), kProduct);
  return (!has_root_modulo<kPrimes>(residue.data(), c.size()) || ...);
}

}  // namespace

bool lacks_rational_roots(const std::vector<Integer>& c) {
  if (c.size() > kMostCoefficients) return false;
  return lacks_roots_modulo_some<2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47>(c) ||
         lacks_roots_modulo_some<53, 59, 61, 67, 71, 73, 79, 83, 89, 97>(c);
}

std::optional<Rational> simplest_fraction(double lo, double hi) {
  const bool negative = hi < 0;
  if (negative) {
    lo = -std::exchange(hi, -lo);
  } else if (lo <= 0) {
    if (hi < 0) return std::nullopt;
    return Rational(0);
  }
  // The continued fractions of both ends, as long as they agree; p / q are their convergents.
  std::int64_t p0 = 0, q0 = 1, p1 = 1, q1 = 0;
  constexpr double kMost = 0x1p52;
  for (;;) {
    const double whole = std::floor(lo);
    if (!(whole < kMost)) return std::nullopt;
    const bool last = whole == lo || whole + 1 <= hi;
    const std::int64_t a = static_cast<std::int64_t>(whole) + (last && whole != lo ? 1 : 0);
    const double p = static_cast<double>(a) * static_cast<double>(p1) + static_cast<double>(p0);
    const double q = static_cast<double>(a) * static_cast<double>(q1) + static_cast<double>(q0);
    if (!(p < kMost && q < kMost)) return std::nullopt;
    p0 = std::exchange(p1, a * p1 + p0);
    q0 = std::exchange(q1, a * q1 + q0);
    if (last) break;
    const double next_lo = 1 / (hi - whole);
    hi = 1 / (lo - whole);
    lo = next_lo;
  }
  return Rational(Integer(negative ? -p1 : p1), Integer(q1));
}

std::optional<Rational> rational_value(const Polynomial& p, RealRoot& root,
                                       RootCounters& counters) {
  if (root.is_rational()) return root.value();
  if (lacks_rational_roots(p.coefficients())) return std::nullopt;
  const Rational leading(p.leading());
  root.refine_to(static_cast<long>(p.leading().bit_length()) + 1, counters);
  if (root.is_rational()) return root.value();
  // The root is strictly between the ends, which are less than 1 / leading apart.
  const Rational scaled = root.upper() * leading;
  const Integer below = scaled.is_integer()
                            ? scaled.numerator() - Integer(1)
                            : floor_divide(scaled.numerator(), scaled.denominator());
  const Rational candidate(below, p.leading());
  if (candidate <= root.lower() || compare(root, candidate, counters) != 0) return std::nullopt;
  return candidate;
}

}  // namespace kinex
