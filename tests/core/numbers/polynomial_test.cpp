// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/polynomial.h"

#include <gtest/gtest.h>

#include "tests/core/numbers/polynomial_fixture.h"

namespace kinex {
namespace polynomial_test {

using fixture::polynomial;
using fixture::Random;
using fixture::rational;

TEST(Polynomial, StripsLeadingZeros) {
  EXPECT_EQ(polynomial({1, 2, 0, 0}).degree(), 1);
  EXPECT_EQ(polynomial({0, 0}).degree(), -1);
  EXPECT_TRUE((polynomial({1, 2}) - polynomial({1, 2})).is_zero());
  EXPECT_EQ((polynomial({1, 2, 3}) + polynomial({0, 0, -3})).degree(), 1);
  EXPECT_EQ(polynomial({1, 2, 3}) - polynomial({0, 1}), polynomial({1, 1, 3}));
  EXPECT_EQ(polynomial({0, 1}) - polynomial({1, 2, 3}), polynomial({-1, -1, -3}));
}

TEST(Polynomial, ClearsDenominatorsByAPositiveFactor) {
  EXPECT_EQ(Polynomial::from_rationals({rational("-1/2"), rational("1/3")}), polynomial({-3, 2}));
  EXPECT_EQ(Polynomial::from_rationals({rational("4"), rational("-6")}), polynomial({2, -3}));
  EXPECT_TRUE(Polynomial::from_rationals({Rational(0)}).is_zero());
  EXPECT_TRUE(Polynomial::from_rationals({}).is_zero());
}

TEST(Polynomial, EvaluatesInAllWaysAlike) {
  Random random(11);
  for (int i = 0; i < 300; ++i) {
    const Polynomial p = random.polynomial(static_cast<int>(random.below(9)), 40);
    const Integer numerator = random.integer(30);
    const auto exponent = static_cast<unsigned long>(random.below(40));
    const Rational t(numerator, Integer::power_of_two(exponent));
    // The definition, in rationals.
    Rational value(0);
    Rational t_power(1);
    for (const Integer& c : p.coefficients()) {
      value += Rational(c) * t_power;
      t_power *= t;
    }
    EXPECT_EQ(p.value_at(t), value);
    EXPECT_EQ(p.sign_at(t), to_sign(value.sign()));
    EXPECT_EQ(p.sign_at_dyadic(numerator, exponent), to_sign(value.sign()));
    const Rational third = t / Rational(3);
    EXPECT_EQ(p.sign_at(third), to_sign(p.value_at(third).sign()));
  }
}

TEST(Polynomial, ZeroPolynomial) {
  const Polynomial zero;
  EXPECT_EQ(zero.sign_at(Rational(3)), Sign::kZero);
  EXPECT_EQ(zero.sign_at_dyadic(Integer(3), 1), Sign::kZero);
  EXPECT_EQ(zero.value_at(Rational(3)), Rational(0));
  EXPECT_EQ(zero.sign_at_plus_infinity(), Sign::kZero);
  EXPECT_EQ(zero.sign_at_minus_infinity(), Sign::kZero);
  EXPECT_TRUE(zero.content().is_zero());
  EXPECT_TRUE(zero.canonical().is_zero());
  EXPECT_TRUE((zero * polynomial({1, 2})).is_zero());
  EXPECT_TRUE(zero.derivative().is_zero());
  EXPECT_EQ(zero.max_bits(), 0U);
  EXPECT_EQ(zero.to_string(), "0");
}

TEST(Polynomial, SignsAtInfinity) {
  EXPECT_EQ(polynomial({5, -2}).sign_at_plus_infinity(), Sign::kNegative);
  EXPECT_EQ(polynomial({5, -2}).sign_at_minus_infinity(), Sign::kPositive);
  EXPECT_EQ(polynomial({5, 0, -2}).sign_at_minus_infinity(), Sign::kNegative);
}

TEST(Polynomial, NamesUpToAConstantFactor) {
  EXPECT_EQ(polynomial({6, -4}).primitive_part(), polynomial({3, -2}));
  EXPECT_EQ(polynomial({6, -4}).canonical(), polynomial({-3, 2}));
  EXPECT_EQ(polynomial({6, -4}).content(), Integer(2));
  EXPECT_EQ(polynomial({0, 0, -7}).canonical(), polynomial({0, 0, 1}));
}

TEST(Polynomial, Derivative) {
  EXPECT_EQ(polynomial({7, 5, 3, 2}).derivative(), polynomial({5, 6, 6}));
  EXPECT_TRUE(polynomial({7}).derivative().is_zero());
}

TEST(Polynomial, Prints) { EXPECT_EQ(polynomial({1, -2, 0, 3}).to_string(), "1 -2 0 3"); }

}  // namespace polynomial_test
}  // namespace kinex
