// SPDX-License-Identifier: GPL-3.0-or-later
// Agreement with FLINT and arb, which share only GMP with kinex.
#include <arb_fmpz_poly.h>
#include <flint/fmpz_poly.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/numbers/polynomial_gcd.h"
#include "core/numbers/real_root.h"
#include "core/numbers/sturm_sequence.h"
#include "tests/core/numbers/polynomial_fixture.h"

namespace kinex {
namespace root_oracle_test {

using fixture::chebyshev;
using fixture::mignotte;
using fixture::power;
using fixture::Random;
using fixture::wilkinson;

class FlintPolynomial {
 public:
  FlintPolynomial() { fmpz_poly_init(p_); }
  explicit FlintPolynomial(const Polynomial& p) : FlintPolynomial() {
    for (std::size_t i = 0; i < p.coefficients().size(); ++i) {
      fmpz_poly_set_coeff_mpz(p_, static_cast<slong>(i), p[i].raw());
    }
  }
  FlintPolynomial(const FlintPolynomial&) = delete;
  FlintPolynomial& operator=(const FlintPolynomial&) = delete;
  ~FlintPolynomial() { fmpz_poly_clear(p_); }
  fmpz_poly_struct* raw() { return p_; }
  Polynomial polynomial() const {
    std::vector<Integer> c(static_cast<std::size_t>(fmpz_poly_length(p_)));
    for (std::size_t i = 0; i < c.size(); ++i) {
      fmpz_poly_get_coeff_mpz(c[i].raw(), p_, static_cast<slong>(i));
    }
    return Polynomial(std::move(c));
  }

 private:
  fmpz_poly_t p_;
};

int flint_root_count(const Polynomial& p) {
  FlintPolynomial f(square_free_part(p));
  return static_cast<int>(fmpz_poly_num_real_roots_sturm(f.raw()));
}

// Dyadic enclosures of the real roots of a square-free polynomial, ascending.
std::vector<std::pair<Rational, Rational>> arb_real_roots(const Polynomial& p) {
  FlintPolynomial f(p);
  const slong degree = p.degree();
  acb_ptr roots = _acb_vec_init(degree);
  arb_fmpz_poly_complex_roots(roots, f.raw(), 0, 128);
  std::vector<std::pair<Rational, Rational>> result;
  const auto rational = [](const arf_t x) {
    fmpq_t q;
    fmpq_init(q);
    arf_get_fmpq(q, x);
    Rational r;
    fmpq_get_mpq(r.edit(), q);
    fmpq_clear(q);
    return r;
  };
  for (slong i = 0; i < degree; ++i) {
    if (!arb_is_zero(acb_imagref(roots + i))) continue;
    arf_t low;
    arf_t high;
    arf_init(low);
    arf_init(high);
    arb_get_interval_arf(low, high, acb_realref(roots + i), 200);
    result.emplace_back(rational(low), rational(high));
    arf_clear(low);
    arf_clear(high);
  }
  _acb_vec_clear(roots, degree);
  std::sort(result.begin(), result.end());
  return result;
}

Polynomial flint_gcd(const Polynomial& a, const Polynomial& b) {
  FlintPolynomial f(a);
  FlintPolynomial g(b);
  FlintPolynomial h;
  fmpz_poly_gcd(h.raw(), f.raw(), g.raw());
  return h.polynomial().canonical();
}

Polynomial random_case(Random& random, int i) {
  const int degree = 1 + static_cast<int>(random.below(9));
  const int bits = i % 4 == 0 ? 3 : 5 + static_cast<int>(random.below(100));
  Polynomial p = random.polynomial(degree, bits);
  if (i % 3 == 0) p = p * power(random.polynomial(2, 4), 2);
  if (i % 5 == 0) p = p * power(random.polynomial(1, 4), 3);
  return p;
}

TEST(RootOracle, CountsAgreeWithFlint) {
  Random random(101);
  RootCounters counters;
  for (int i = 0; i < 600; ++i) {
    const Polynomial p = random_case(random, i);
    const int expected = p.degree() == 0 ? 0 : flint_root_count(p);
    EXPECT_EQ(SturmSequence(p).count_all(), expected) << p.to_string();
    EXPECT_EQ(static_cast<int>(isolate_real_roots(p, counters).size()), expected) << p.to_string();
  }
}

TEST(RootOracle, CountsOfHardFamiliesAgreeWithFlint) {
  RootCounters counters;
  const Polynomial cases[] = {
      chebyshev(30),
      wilkinson(25, -7),
      wilkinson(12, 1000),
      mignotte(11, 1000),
      mignotte(16, 1000000),
      mignotte(30, 1000),
      chebyshev(9) * mignotte(7, 1000),
      wilkinson(8, 1) - fixture::polynomial({1}),
      wilkinson(15, 1) * fixture::polynomial({1 << 20}) + fixture::polynomial({0, 0, 0, 0, 0, 1})};
  for (const Polynomial& p : cases) {
    const int expected = flint_root_count(p);
    EXPECT_EQ(static_cast<int>(isolate_real_roots(p, counters).size()), expected) << p.to_string();
    EXPECT_EQ(SturmSequence(p).count_all(), expected) << p.to_string();
  }
}

TEST(RootOracle, IntervalsMeetThoseOfArb) {
  Random random(202);
  RootCounters counters;
  for (int i = 0; i < 120; ++i) {
    const Polynomial p = square_free_part(random.polynomial(2 + i % 9, 5 + i));
    if (p.degree() < 1) continue;
    const std::vector<std::pair<Rational, Rational>> expected = arb_real_roots(p);
    std::vector<RootWithMultiplicity> roots = isolate_real_roots(p, counters);
    ASSERT_EQ(roots.size(), expected.size()) << p.to_string();
    RealRoot now{Rational(Integer(-1) * Integer::power_of_two(200))};
    for (std::size_t k = 0; k < roots.size(); ++k) {
      EXPECT_GE(compare(roots[k].root, expected[k].first, counters), 0);
      EXPECT_LE(compare(roots[k].root, expected[k].second, counters), 0);
      roots[k].root.refine_to(150, counters);
      EXPECT_LE(roots[k].root.lower(), expected[k].second);
      EXPECT_GE(roots[k].root.upper(), expected[k].first);
      const std::optional<RealRoot> next = first_sign_change_after(p, now, std::nullopt, counters);
      ASSERT_TRUE(next);
      now = *next;
      EXPECT_GE(compare(now, expected[k].first, counters), 0);
      EXPECT_LE(compare(now, expected[k].second, counters), 0);
    }
  }
}

TEST(RootOracle, ComparisonsAgreeWithArb) {
  Random random(303);
  RootCounters counters;
  for (int i = 0; i < 150; ++i) {
    // Half of the pairs share a factor.
    const Polynomial f = random.polynomial(2, 8);
    const Polynomial a =
        square_free_part(i % 2 == 0 ? f * random.polynomial(2, 8) : random.polynomial(4, 8));
    const Polynomial b =
        square_free_part(i % 2 == 0 ? f * random.polynomial(3, 8) : random.polynomial(5, 8));
    if (a.degree() < 1 || b.degree() < 1) continue;
    const auto expected_a = arb_real_roots(a);
    const auto expected_b = arb_real_roots(b);
    const auto roots_a = isolate_real_roots(a, counters);
    const auto roots_b = isolate_real_roots(b, counters);
    ASSERT_EQ(roots_a.size(), expected_a.size());
    ASSERT_EQ(roots_b.size(), expected_b.size());
    for (std::size_t j = 0; j < roots_a.size(); ++j) {
      for (std::size_t k = 0; k < roots_b.size(); ++k) {
        RealRoot x = roots_a[j].root;
        RealRoot y = roots_b[k].root;
        // At 128 bits these small polynomials' roots are equal if their enclosures meet.
        const int expected = expected_a[j].second < expected_b[k].first   ? -1
                             : expected_b[k].second < expected_a[j].first ? 1
                                                                          : 0;
        EXPECT_EQ(compare(x, y, counters), expected) << a.to_string() << " | " << b.to_string();
      }
    }
  }
}

TEST(RootOracle, GcdsAgreeWithFlint) {
  Random random(404);
  for (int i = 0; i < 400; ++i) {
    const int bits = 2 + static_cast<int>(random.below(i % 10 == 0 ? 800 : 60));
    const Polynomial g = random.polynomial(static_cast<int>(random.below(5)), bits);
    const Polynomial a = g * random.polynomial(static_cast<int>(random.below(6)), bits);
    const Polynomial b = g * random.polynomial(static_cast<int>(random.below(6)), bits);
    const Polynomial expected = flint_gcd(a, b);
    EXPECT_EQ(gcd(a, b), expected) << a.to_string() << " | " << b.to_string();
    if (coprime_modulo_prime(a, b)) {
      EXPECT_EQ(expected.degree(), 0);
    }
  }
}

}  // namespace root_oracle_test
}  // namespace kinex
