// SPDX-License-Identifier: GPL-3.0-or-later
// Signs of polynomials at real roots, and the next sign change of a polynomial.
#include <gtest/gtest.h>

#include <optional>
#include <stdexcept>
#include <vector>

#include "core/numbers/real_root.h"
#include "tests/core/numbers/polynomial_fixture.h"

namespace kinex {
namespace root_signs_test {

using fixture::chebyshev;
using fixture::mignotte;
using fixture::polynomial;
using fixture::power;
using fixture::rational;
using fixture::wilkinson;
using fixture::with_root;
using fixture::with_roots;

Rational small(unsigned long bits) { return Rational(Integer(1), Integer::power_of_two(bits)); }

RealRoot square_root_of(int n) {
  return RealRoot(polynomial({-n, 0, 1}), Rational(0), Rational(n + 1));
}

TEST(SignAt, ZeroOfEveryMultiplicity) {
  RootCounters counters;
  const Polynomial f = polynomial({-2, 0, 1});
  for (int multiplicity = 1; multiplicity <= 4; ++multiplicity) {
    const Polynomial q = power(f, multiplicity) * polynomial({-3, 1});  // negative factor there
    for (int own = 1; own <= 3; own += 2) {
      RealRoot r(power(f, own), Rational(1), Rational(2));
      EXPECT_EQ(sign_at(q, r, counters), Sign::kZero);
      EXPECT_EQ(sign_after(q, r, counters), Sign::kNegative);
      EXPECT_EQ(sign_before(q, r, counters),
                multiplicity % 2 == 0 ? Sign::kNegative : Sign::kPositive);
    }
  }
}

TEST(SignAt, AtRationalRoots) {
  RootCounters counters;
  RealRoot r{rational("1/3")};
  const Polynomial q = power(with_root(rational("1/3")), 2) * polynomial({-1, 1});
  EXPECT_EQ(sign_at(q, r, counters), Sign::kZero);
  EXPECT_EQ(sign_before(q, r, counters), Sign::kNegative);
  EXPECT_EQ(sign_after(q, r, counters), Sign::kNegative);
  EXPECT_EQ(sign_at(polynomial({-1, 2}), r, counters), Sign::kNegative);
}

TEST(SignAt, ConstantsAndZero) {
  RootCounters counters;
  RealRoot r = square_root_of(2);
  EXPECT_EQ(sign_at(Polynomial(), r, counters), Sign::kZero);
  EXPECT_EQ(sign_after(Polynomial(), r, counters), Sign::kZero);
  EXPECT_EQ(sign_before(Polynomial(), r, counters), Sign::kZero);
  EXPECT_EQ(sign_at(polynomial({-3}), r, counters), Sign::kNegative);
  EXPECT_EQ(sign_before(polynomial({-3}), r, counters), Sign::kNegative);
}

TEST(SignAt, AlmostZero) {
  RootCounters counters;
  for (const unsigned long k : {80UL, 200UL, 1000UL}) {
    const Integer scale = Integer::power_of_two(k);
    const Polynomial above({-(scale << 1) + Integer(1), Integer(0), scale});
    const Polynomial below({-(scale << 1) - Integer(1), Integer(0), scale});
    RealRoot r = square_root_of(2);
    EXPECT_EQ(sign_at(above, r, counters), Sign::kPositive);
    EXPECT_EQ(sign_at(below, r, counters), Sign::kNegative);
  }
}

TEST(SignAt, NegativeRootsAndIntervalsAroundZero) {
  RootCounters counters;
  RealRoot minus(polynomial({-2, 0, 1}), Rational(-2), Rational(0));
  EXPECT_EQ(sign_at(polynomial({0, 1}), minus, counters), Sign::kNegative);
  EXPECT_EQ(sign_at(polynomial({0, 0, 0, 1}), minus, counters), Sign::kNegative);
  EXPECT_EQ(sign_at(polynomial({3, 2}), minus, counters), Sign::kPositive);
  RealRoot tiny(polynomial({-1, 1000, 0, 1}), Rational(-1), Rational(1));
  EXPECT_EQ(sign_at(polynomial({0, 1}), tiny, counters), Sign::kPositive);
  EXPECT_EQ(sign_at(polynomial({0, 0, -1}), tiny, counters), Sign::kNegative);
}

TEST(FirstSignChange, SkipsEvenMultiplicities) {
  RootCounters counters;
  const Polynomial p = power(with_root(rational("1/3")), 2) * power(with_root(Rational(1)), 4) *
                       power(with_root(rational("5/3")), 3) * power(polynomial({-5, 0, 1}), 2) *
                       with_root(Rational(4));
  RealRoot start{Rational(0)};
  std::optional<RealRoot> root = first_sign_change_after(p, start, std::nullopt, counters);
  ASSERT_TRUE(root);
  EXPECT_EQ(compare(*root, rational("5/3"), counters), 0);
  root = first_sign_change_after(p, *root, std::nullopt, counters);
  ASSERT_TRUE(root);
  EXPECT_EQ(compare(*root, Rational(4), counters), 0);
  EXPECT_FALSE(first_sign_change_after(p, *root, std::nullopt, counters));
}

TEST(FirstSignChange, TheStartIsExcludedAndTheEndIncluded) {
  RootCounters counters;
  const Polynomial p = with_roots({rational("1/3"), rational("2/3"), Rational(1)});
  RealRoot start{rational("1/3")};
  std::optional<RealRoot> root = first_sign_change_after(p, start, rational("2/3"), counters);
  ASSERT_TRUE(root);
  EXPECT_EQ(compare(*root, rational("2/3"), counters), 0);
  EXPECT_FALSE(first_sign_change_after(p, start, rational("65/100"), counters));
  EXPECT_FALSE(first_sign_change_after(p, start, rational("1/3"), counters));
  EXPECT_FALSE(first_sign_change_after(p, start, Rational(-5), counters));
  RealRoot dyadic_start{Rational(1)};
  EXPECT_FALSE(first_sign_change_after(p, dyadic_start, std::nullopt, counters));
  RealRoot before{rational("3/4")};
  EXPECT_TRUE(first_sign_change_after(p, before, Rational(1), counters));
  EXPECT_FALSE(first_sign_change_after(p, before, rational("99/100"), counters));
}

TEST(FirstSignChange, EndBetweenTheUnitsOfTheSearch) {
  RootCounters counters;
  const Polynomial p = with_roots({rational("5/8"), rational("11/16")});
  RealRoot zero{Rational(0)};
  std::optional<RealRoot> root = first_sign_change_after(p, zero, rational("3/4"), counters);
  ASSERT_TRUE(root);
  EXPECT_EQ(compare(*root, rational("5/8"), counters), 0);
  root = first_sign_change_after(p, *root, rational("11/16"), counters);
  ASSERT_TRUE(root);
  EXPECT_EQ(compare(*root, rational("11/16"), counters), 0);
}

TEST(FirstSignChange, LinearPolynomials) {
  RootCounters counters;
  const Polynomial p = polynomial({-1, 3});
  RealRoot zero{Rational(0)};
  const std::optional<RealRoot> root = first_sign_change_after(p, zero, rational("1/3"), counters);
  ASSERT_TRUE(root);
  EXPECT_EQ(root->value(), rational("1/3"));
  RealRoot third{rational("1/3")};
  EXPECT_FALSE(first_sign_change_after(p, third, std::nullopt, counters));
  EXPECT_FALSE(first_sign_change_after(p, zero, rational("1/4"), counters));
  EXPECT_FALSE(first_sign_change_after(polynomial({4}), zero, std::nullopt, counters));
  EXPECT_THROW(first_sign_change_after(Polynomial(), zero, std::nullopt, counters),
               std::logic_error);
}

TEST(FirstSignChange, StartsAtAnAlgebraicRootOfThePolynomial) {
  RootCounters counters;
  const Polynomial p = polynomial({-2, 0, 1}) * polynomial({-3, 0, 1}) * polynomial({-5, 0, 1});
  RealRoot start = square_root_of(2);  // known from another polynomial, coarsely
  std::optional<RealRoot> root = first_sign_change_after(p, start, std::nullopt, counters);
  ASSERT_TRUE(root);
  RealRoot three = square_root_of(3);
  EXPECT_EQ(compare(*root, three, counters), 0);
  root->refine_to(300, counters);
  root = first_sign_change_after(p, *root, std::nullopt, counters);
  ASSERT_TRUE(root);
  RealRoot five = square_root_of(5);
  EXPECT_EQ(compare(*root, five, counters), 0);
  EXPECT_FALSE(first_sign_change_after(p, *root, std::nullopt, counters));
}

TEST(FirstSignChange, NextRootIsVeryNearTheStart) {
  RootCounters counters;
  for (const unsigned long k : {10UL, 20UL, 80UL, 200UL, 1000UL}) {
    for (const Rational& at : {Rational(0), rational("1/3"), rational("7/8"), Rational(-12)}) {
      const Polynomial p = with_roots({at - small(k), at, at + small(k)}) * polynomial({1, 0, 1});
      RealRoot start{at};
      std::optional<RealRoot> root = first_sign_change_after(p, start, std::nullopt, counters);
      ASSERT_TRUE(root);
      EXPECT_EQ(compare(*root, at + small(k), counters), 0);
      EXPECT_FALSE(first_sign_change_after(p, *root, std::nullopt, counters));
      RealRoot below{at - small(k)};
      root = first_sign_change_after(p, below, std::nullopt, counters);
      ASSERT_TRUE(root);
      EXPECT_EQ(compare(*root, at, counters), 0);
    }
  }
}

TEST(FirstSignChange, VisitsAllOddRootsInOrder) {
  RootCounters counters;
  const Polynomial cases[] = {chebyshev(12),
                              wilkinson(12, -4),
                              mignotte(12, 1000),
                              mignotte(8, 1000000),
                              wilkinson(5, 1) * power(chebyshev(5), 2),
                              chebyshev(9) * chebyshev(3)};
  for (const Polynomial& p : cases) {
    std::vector<RootWithMultiplicity> expected = isolate_real_roots(p, counters);
    RealRoot now{Rational(-1000000)};
    for (RootWithMultiplicity& entry : expected) {
      if (entry.multiplicity % 2 == 0) continue;
      const std::optional<RealRoot> next = first_sign_change_after(p, now, std::nullopt, counters);
      ASSERT_TRUE(next) << p.to_string();
      now = *next;
      EXPECT_EQ(compare(now, entry.root, counters), 0) << p.to_string();
    }
    EXPECT_FALSE(first_sign_change_after(p, now, std::nullopt, counters)) << p.to_string();
  }
}

}  // namespace root_signs_test
}  // namespace kinex
