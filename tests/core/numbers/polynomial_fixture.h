// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomials with known roots, and a small deterministic source of random ones.
#ifndef KINEX_TESTS_CORE_NUMBERS_POLYNOMIAL_FIXTURE_H
#define KINEX_TESTS_CORE_NUMBERS_POLYNOMIAL_FIXTURE_H

#include <cstdint>
#include <initializer_list>
#include <random>
#include <string_view>
#include <utility>
#include <vector>

#include "core/numbers/polynomial.h"

namespace kinex::fixture {

inline Rational rational(std::string_view text) { return Rational::parse(text).value(); }

// Low degree first.
inline Polynomial polynomial(std::initializer_list<std::int64_t> coefficients) {
  std::vector<Integer> c;
  for (const std::int64_t x : coefficients) c.emplace_back(x);
  return Polynomial(std::move(c));
}

// den t - num.
inline Polynomial with_root(const Rational& root) {
  return Polynomial({-root.numerator(), root.denominator()});
}

inline Polynomial with_roots(const std::vector<Rational>& roots) {
  Polynomial p = polynomial({1});
  for (const Rational& r : roots) p = p * with_root(r);
  return p;
}

inline Polynomial power(const Polynomial& p, int exponent) {
  Polynomial result = polynomial({1});
  for (int i = 0; i < exponent; ++i) result = result * p;
  return result;
}

// x^d - 2 (ax - 1)^2: two roots about a^(-(d+2)/2) apart around 1/a.
inline Polynomial mignotte(int d, std::int64_t a) {
  std::vector<Integer> c(static_cast<std::size_t>(d) + 1);
  c.back() = Integer(1);
  return Polynomial(std::move(c)) - polynomial({2}) * power(polynomial({-1, a}), 2);
}

// (t - first) (t - first - 1) .. n factors.
inline Polynomial wilkinson(int n, std::int64_t first) {
  Polynomial p = polynomial({1});
  for (int i = 0; i < n; ++i) p = p * polynomial({-(first + i), 1});
  return p;
}

inline Polynomial chebyshev(int n) {
  Polynomial previous = polynomial({1});
  Polynomial current = polynomial({0, 1});
  if (n == 0) return previous;
  for (int i = 2; i <= n; ++i) {
    Polynomial next = polynomial({0, 2}) * current - previous;
    previous = std::move(current);
    current = std::move(next);
  }
  return current;
}

// The standard specifies engines bit by bit, distributions not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  // In [0, n).
  std::int64_t below(std::int64_t n) {
    return static_cast<std::int64_t>(engine_() % static_cast<std::uint64_t>(n));
  }
  // Signed, |value| < 2^bits.
  Integer integer(int bits) {
    Integer value;
    for (int done = 0; done < bits; done += 32) {
      value = (value << 32) + Integer(static_cast<std::int64_t>(engine_() >> 32));
    }
    value = value >> static_cast<unsigned long>((bits + 31) / 32 * 32 - bits);
    return engine_() % 2 == 0 ? value : -value;
  }
  // Of degree at most d, never zero.
  Polynomial polynomial(int d, int bits) {
    std::vector<Integer> c;
    for (int i = 0; i <= d; ++i) c.push_back(integer(bits));
    Polynomial p(std::move(c));
    return p.is_zero() ? Polynomial({Integer(1)}) : p;
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace kinex::fixture

#endif
