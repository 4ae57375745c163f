// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/polynomial_gcd.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "core/numbers/modular.h"
#include "tests/core/numbers/polynomial_fixture.h"

namespace kinex {
namespace polynomial_gcd_test {

using fixture::chebyshev;
using fixture::polynomial;
using fixture::power;
using fixture::Random;
using fixture::rational;
using fixture::with_root;

TEST(PolynomialGcd, EdgeCases) {
  EXPECT_TRUE(gcd(Polynomial(), Polynomial()).is_zero());
  EXPECT_EQ(gcd(Polynomial(), polynomial({4, -6})), polynomial({-2, 3}));
  EXPECT_EQ(gcd(polynomial({4, -6}), Polynomial()), polynomial({-2, 3}));
  EXPECT_EQ(gcd(polynomial({4}), polynomial({4, -6})), polynomial({1}));
  EXPECT_EQ(gcd(polynomial({0, 0, 6}), polynomial({0, -4})), polynomial({0, 1}));
}

TEST(PolynomialGcd, FindsTheChosenFactor) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const int bits = 5 + 20 * (i % 10);
    const Polynomial g = random.polynomial(1 + static_cast<int>(random.below(4)), bits);
    const Polynomial a = random.polynomial(static_cast<int>(random.below(5)), bits);
    const Polynomial b = random.polynomial(static_cast<int>(random.below(5)), bits);
    const Polynomial found = gcd(g * a, g * b);
    // found = g gcd(a, b): it divides both, and the cofactors are coprime.
    EXPECT_EQ(gcd(exact_quotient(g * a, found), exact_quotient(g * b, found)).degree(), 0);
    EXPECT_EQ(exact_quotient(found, gcd(a, b)).canonical(), g.canonical());
  }
}

TEST(PolynomialGcd, UnluckyFirstPrimeIsOvercome) {
  const Integer prime = Integer::power_of_two(61) - Integer(1);
  // t and t + p are equal modulo p, but coprime.
  const Polynomial a = polynomial({0, 1});
  const Polynomial b({prime, Integer(1)});
  EXPECT_FALSE(coprime_modulo_prime(a, b));
  EXPECT_EQ(gcd(a, b), polynomial({1}));
  EXPECT_EQ(gcd(a * polynomial({5, 2}), b * polynomial({5, 2})), polynomial({5, 2}));
  // The prime divides both leading coefficients, and the common factor vanishes modulo p.
  const Polynomial c({Integer(1), prime});
  EXPECT_FALSE(coprime_modulo_prime(c, c * polynomial({3, 1})));
  EXPECT_EQ(gcd(c, c * polynomial({3, 1})), c);
  EXPECT_EQ(gcd(c * polynomial({3, 1}), c * polynomial({4, 1})), c);
  // It divides one leading coefficient only.
  EXPECT_EQ(gcd(c * polynomial({3, 1}), polynomial({3, 1})), polynomial({3, 1}));
  // It divides everything.
  EXPECT_EQ(gcd(Polynomial({prime, prime}), polynomial({1, 1})), polynomial({1, 1}));
}

TEST(PolynomialGcd, UnluckyLaterPrimeIsOvercome) {
  Random random(6);
  PrimeSequence primes;
  primes.next();
  const Integer second(static_cast<std::int64_t>(primes.next()));
  const Integer third(static_cast<std::int64_t>(primes.next()));
  const Polynomial g = random.polynomial(3, 400);  // several primes are needed
  for (const Integer& prime : {second, third}) {
    EXPECT_EQ(gcd(g * polynomial({0, 1}), g * Polynomial({prime, Integer(1)})), g.canonical());
  }
}

TEST(PolynomialGcd, CoprimeModuloAPrimeIsAProof) {
  EXPECT_TRUE(coprime_modulo_prime(polynomial({1, 1}), polynomial({2, 1})));
  EXPECT_TRUE(coprime_modulo_prime(polynomial({5}), polynomial({2, 1})));
  EXPECT_FALSE(coprime_modulo_prime(polynomial({1, 1}), polynomial({2, 2})));
  EXPECT_FALSE(coprime_modulo_prime(Polynomial(), polynomial({2, 1})));
  EXPECT_FALSE(coprime_modulo_prime(Polynomial(), Polynomial()));
}

TEST(PolynomialGcd, ManyBitsAndHighDegree) {
  Random random(4);
  const Polynomial g = random.polynomial(40, 1500);
  const Polynomial a = random.polynomial(40, 1500);
  const Polynomial b = random.polynomial(40, 1500);
  EXPECT_EQ(gcd(g * a, g * b), g.canonical());
  EXPECT_EQ(gcd(chebyshev(60), chebyshev(20)), chebyshev(20).canonical());
  EXPECT_EQ(gcd(chebyshev(61), chebyshev(20)).degree(), 0);
}

TEST(PolynomialGcd, ExactQuotientKeepsTheSign) {
  const Polynomial a = polynomial({-6, 6}) * polynomial({1, 2});
  EXPECT_EQ(exact_quotient(a, polynomial({1, 2})), polynomial({-1, 1}));
  EXPECT_EQ(exact_quotient(a, polynomial({-2, -4})), polynomial({1, -1}));
  EXPECT_TRUE(exact_quotient(Polynomial(), a).is_zero());
  EXPECT_THROW(exact_quotient(a, polynomial({1, 3})), std::logic_error);
  EXPECT_THROW(exact_quotient(a, Polynomial()), std::logic_error);
}

TEST(PolynomialGcd, SquareFreeDecomposition) {
  const Polynomial u = with_root(rational("1/3"));
  const Polynomial v = polynomial({1, 0, 1});
  const Polynomial w = polynomial({-2, 0, 1});
  const Polynomial p = polynomial({-6}) * u * power(v, 2) * power(w, 4);
  const std::vector<Polynomial> factors = square_free_decomposition(p);
  ASSERT_EQ(factors.size(), 4U);
  EXPECT_EQ(factors[0], u);
  EXPECT_EQ(factors[1], v);
  EXPECT_EQ(factors[2], polynomial({1}));
  EXPECT_EQ(factors[3], w);
  EXPECT_EQ(square_free_part(p), (u * v * w).canonical());
  EXPECT_EQ(odd_part(p), -u);
  EXPECT_EQ(odd_part(-p), u);
  EXPECT_TRUE(square_free_decomposition(polynomial({5})).empty());
  EXPECT_EQ(odd_part(polynomial({-5})), polynomial({-1}));
  EXPECT_THROW(square_free_decomposition(Polynomial()), std::logic_error);
  EXPECT_THROW(square_free_part(Polynomial()), std::logic_error);
  EXPECT_THROW(odd_part(Polynomial()), std::logic_error);
}

TEST(PolynomialGcd, OddPartHasTheSignOfThePolynomial) {
  Random random(8);
  for (int i = 0; i < 100; ++i) {
    Polynomial p = random.polynomial(2, 6);
    p = p * power(random.polynomial(2, 4), 2) * power(random.polynomial(1, 4), 3);
    const Polynomial odd = odd_part(p);
    for (int k = -40; k <= 40; ++k) {
      const Rational t = Rational(k) / Rational(7);
      if (p.sign_at(t) != Sign::kZero) {
        EXPECT_EQ(p.sign_at(t), odd.sign_at(t));
      }
    }
  }
}

TEST(PrimeSequence, HasAllPrimesInDescendingOrder) {
  // More primes than the table holds, checked against GMP; no prime is left out.
  PrimeSequence primes;
  std::uint64_t expected = (std::uint64_t{1} << 61) - 1;
  for (int i = 0; i < 70; ++i, expected -= 2) {
    while (mpz_probab_prime_p(Integer(static_cast<std::int64_t>(expected)).raw(), 30) == 0) {
      expected -= 2;
    }
    ASSERT_EQ(primes.next(), expected) << i;
  }
}

TEST(PrimeField, ArithmeticAgreesWithPlainIntegers) {
  PrimeSequence primes;
  EXPECT_EQ(primes.next(), (std::uint64_t{1} << 61) - 1);
  const std::uint64_t p = primes.next();
  Integer big(static_cast<std::int64_t>(p));
  EXPECT_NE(mpz_probab_prime_p(big.raw(), 30), 0);
  const PrimeField field(p);
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    const Integer a = random.integer(100);
    const Integer b = random.integer(100);
    const std::uint64_t x = field.from_integer(a);
    const std::uint64_t y = field.from_integer(b);
    EXPECT_EQ(field.multiply(x, y), field.from_integer(a * b));
    EXPECT_EQ(field.cross(x, y, y, y), field.from_integer(a * b - b * b));
    EXPECT_EQ(field.subtract(x, y), field.from_integer(a - b));
    EXPECT_EQ(field.add(x, y), field.from_integer(a + b));
    EXPECT_EQ(field.to_word(x), mpz_fdiv_ui(a.raw(), p));
    if (x != 0) {
      EXPECT_EQ(field.multiply(x, field.inverse(x)), field.from_word(1));
    }
  }
}

}  // namespace polynomial_gcd_test
}  // namespace kinex
