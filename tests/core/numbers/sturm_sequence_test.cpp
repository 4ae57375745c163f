// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/sturm_sequence.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/core/numbers/polynomial_fixture.h"

namespace kinex {
namespace sturm_sequence_test {

using fixture::chebyshev;
using fixture::polynomial;
using fixture::power;
using fixture::rational;
using fixture::wilkinson;
using fixture::with_root;

TEST(SturmSequence, CountsHalfOpenIntervals) {
  const SturmSequence s(wilkinson(5, 1));
  EXPECT_EQ(s.count_between(Rational(0), Rational(5)), 5);
  EXPECT_EQ(s.count_between(Rational(1), Rational(4)), 3);  // (1, 4]
  EXPECT_EQ(s.count_between(Rational(1), Rational(1)), 0);
  EXPECT_EQ(s.count_between(rational("1/2"), rational("1")), 1);
  EXPECT_EQ(s.count_above(Rational(3)), 2);
  EXPECT_EQ(s.count_above(rational("5/2")), 3);
  EXPECT_EQ(s.count_all(), 5);
  EXPECT_THROW(s.count_between(Rational(1), Rational(0)), std::logic_error);
}

TEST(SturmSequence, MultipleRootsCountOnceEvenAtTheEnds) {
  const Polynomial p = power(with_root(Rational(1)), 2) * power(with_root(Rational(2)), 3) *
                       power(polynomial({1, 0, 1}), 2);
  const SturmSequence s(p);
  EXPECT_EQ(s.count_all(), 2);
  EXPECT_EQ(s.count_between(Rational(0), Rational(1)), 1);
  EXPECT_EQ(s.count_between(Rational(1), Rational(2)), 1);
  EXPECT_EQ(s.count_above(Rational(1)), 1);
  EXPECT_EQ(s.count_above(Rational(2)), 0);
}

TEST(SturmSequence, SmallDegrees) {
  EXPECT_EQ(SturmSequence(polynomial({7})).count_all(), 0);
  EXPECT_EQ(SturmSequence(polynomial({7, -2})).count_all(), 1);
  EXPECT_EQ(SturmSequence(polynomial({1, 0, 1})).count_all(), 0);
  EXPECT_EQ(SturmSequence(polynomial({-1, 0, 1})).count_all(), 2);
  EXPECT_EQ(SturmSequence(polynomial({0, 0, 0, 1})).count_all(), 1);
  EXPECT_THROW(SturmSequence{Polynomial()}, std::logic_error);
}

TEST(SturmSequence, SignOfThePolynomialDoesNotMatter) {
  const Polynomial p = wilkinson(4, -2) * polynomial({3, 1, 1});
  EXPECT_EQ(SturmSequence(p).count_all(), 4);
  EXPECT_EQ(SturmSequence(-p).count_all(), 4);
  EXPECT_EQ(SturmSequence(-p).count_between(Rational(-2), Rational(0)), 2);
}

TEST(SturmSequence, ChebyshevRootsLieBetweenMinusOneAndOne) {
  const SturmSequence s(chebyshev(40));
  EXPECT_EQ(s.count_all(), 40);
  EXPECT_EQ(s.count_between(Rational(-1), Rational(1)), 40);
  EXPECT_EQ(s.count_above(Rational(0)), 20);
}

}  // namespace sturm_sequence_test
}  // namespace kinex
