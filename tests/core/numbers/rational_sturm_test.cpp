// SPDX-License-Identifier: GPL-3.0-or-later
// Sturm sequences and instants over the rationals, on polynomials with chosen roots.
#include "core/numbers/rational_sturm.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "core/arithmetic/sturm_instant.h"
#include "tests/core/arithmetic/certificate_fixture.h"

namespace kinex {
namespace rational_sturm_test {

using namespace test;

TEST(RationalSturm, CountsDistinctRoots) {
  SturmWork work;
  const Rational one(1), two(2);
  const RationalPolynomial p(
      with_roots({one, one, two, two, two, rational("7/3")}, times(kMinus, kRootless)));
  const RationalSturm sturm(p, work);
  EXPECT_EQ(sturm.count(Rational(-100), Rational(100)), 3);
  EXPECT_EQ(sturm.count(one, two), 1);
  EXPECT_EQ(sturm.count(Rational(0), one), 1);
  EXPECT_EQ(sturm.count(one, one), 0);
  EXPECT_EQ(sturm.count(two, rational("7/3")), 1);
  EXPECT_EQ(sturm.variations(two) - sturm.variations_at_plus_infinity(), 1);
  EXPECT_EQ(sturm.square_free().degree(), 5);
}

TEST(SturmInstant, DyadicNearMiddle) {
  const std::pair<Rational, Rational> intervals[] = {
      {Rational(0), rational("1/3")},
      {rational("1/3"), rational("2/3")},
      {rational("-1e30"), rational("1/7")},
      {rational("1/3"), rational("1/3") + rational("1e-40")},
      {rational("1e40"), rational("1e41") / Rational(3)}};
  for (const auto& [a, b] : intervals) {
    const Rational m = dyadic_near_middle(a, b);
    EXPECT_TRUE(m.is_dyadic());
    EXPECT_GE(m, a + (b - a) / Rational(4));
    EXPECT_LE(m, b - (b - a) / Rational(4));
  }
}

// Random roots with multiplicities: known counts, square-free part, first change from + to -.
TEST(RationalSturm, ChosenRoots) {
  std::mt19937_64 random(3);
  int found = 0, none = 0;
  for (int round = 0; round < 300; ++round) {
    std::vector<Rational> roots;
    const int distinct = 1 + static_cast<int>(random() % 4);
    Coefficients c = random() % 2 == 0 ? kMinus : kRootless;
    for (int i = 0; i < distinct; ++i) {
      roots.push_back(Rational(static_cast<int>(random() % 41) - 20) /
                      Rational(static_cast<int>(random() % 5) + 1));
      for (unsigned m = random() % 3; m < 3; ++m) c = times(c, {-roots.back(), Rational(1)});
    }
    SturmWork work;
    RationalPolynomial p(c);
    std::sort(roots.begin(), roots.end());
    roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
    RationalSturm sturm(p, work);
    const Rational a = roots[random() % roots.size()];
    const Rational b = a + Rational(static_cast<int>(random() % 10)) / Rational(2);
    const auto inside = std::count_if(roots.begin(), roots.end(),
                                      [&](const Rational& r) { return a < r && r <= b; });
    ASSERT_EQ(sturm.count(a, b), inside);
    for (const Rational& r : roots) ASSERT_EQ(sturm.square_free().sign_at(r), Sign::kZero);
    ASSERT_EQ(gcd(sturm.square_free(), sturm.square_free().derivative(), work).degree(), 0);

    // The sign on each gap between roots, by evaluation in its middle.
    SturmInstant now(a);
    if (sign_after(p, sturm, now, work) == Sign::kNegative) {
      p = -p;
      sturm = RationalSturm(p, work);
    }
    std::optional<Rational> expected;
    for (std::size_t i = 0; i < roots.size() && !expected; ++i) {
      if (roots[i] <= a) continue;
      const Rational next = i + 1 < roots.size() ? roots[i + 1] : roots[i] + Rational(1);
      if (p.sign_at((roots[i] + next) / Rational(2)) == Sign::kNegative) expected = roots[i];
    }
    auto first = first_failure_after(p, sturm, a, std::nullopt, work);
    ASSERT_EQ(first.has_value(), expected.has_value());
    (expected ? found : none) += 1;
    if (!expected) continue;
    ASSERT_TRUE(vanishes_at(p, *first, work));
    for (int i = 0; i < 5; ++i) first->refine(work);
    ASSERT_EQ(first->compare(*expected), 0);
    ASSERT_TRUE(first_failure_after(p, sturm, a, *expected, work).has_value());
    ASSERT_FALSE(first_failure_after(p, sturm, a, *expected - rational("1e-9"), work).has_value());
  }
  EXPECT_GT(found, 100);
  EXPECT_GT(none, 50);
}

TEST(SturmInstant, KeepsItsInvariant) {
  const RationalPolynomial two({Rational(-2), Rational(0), Rational(1)});
  EXPECT_THROW(SturmInstant(two, Rational(2), Rational(3)), std::logic_error);
  EXPECT_THROW(SturmInstant(two, Rational(2), Rational(1)), std::logic_error);
  SturmInstant root(two, Rational(1), Rational(2));
  SturmWork work;
  for (int i = 0; i < 70; ++i) root.refine(work);
  EXPECT_EQ(work.refinements, 70u);
  EXPECT_EQ(root.upper() - root.lower(), Rational(Integer(1), Integer::power_of_two(70)));
  EXPECT_LT(root.lower() * root.lower(), Rational(2));
  EXPECT_GT(root.upper() * root.upper(), Rational(2));
  SturmInstant hit(RationalPolynomial(with_roots({rational("3/2"), Rational(7)}, kMinus)),
                   Rational(1), Rational(2));
  hit.refine(work);
  EXPECT_TRUE(hit.is_rational());
  EXPECT_EQ(hit.lower(), rational("3/2"));
  EXPECT_EQ(compare(hit, root, work), 1);
  EXPECT_EQ(compare(root, hit, work), -1);
}

}  // namespace rational_sturm_test
}  // namespace kinex
