// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/real_root.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/numbers/polynomial_gcd.h"
#include "core/numbers/sturm_sequence.h"
#include "tests/core/numbers/polynomial_fixture.h"

namespace kinex {
namespace real_root_test {

using fixture::chebyshev;
using fixture::mignotte;
using fixture::polynomial;
using fixture::power;
using fixture::Random;
using fixture::rational;
using fixture::wilkinson;
using fixture::with_root;
using fixture::with_roots;

Rational small(unsigned long bits) { return Rational(Integer(1), Integer::power_of_two(bits)); }

RealRoot square_root_of(int n) {
  return RealRoot(polynomial({-n, 0, 1}), Rational(0), Rational(n + 1));
}

// The guarantees of isolate_real_roots, apart from the number of roots.
void expect_isolated(const Polynomial& p, const std::vector<RootWithMultiplicity>& roots) {
  const Polynomial square_free = square_free_part(p);
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const RealRoot& r = roots[i].root;
    if (r.is_rational()) {
      EXPECT_EQ(p.sign_at(r.value()), Sign::kZero);
    } else {
      EXPECT_LT(r.lower(), r.upper());
      EXPECT_EQ(r.polynomial().sign_at(r.lower()), r.sign_at_lower());
      EXPECT_NE(r.sign_at_lower(), Sign::kZero);
      EXPECT_EQ(r.polynomial().sign_at(r.upper()), -r.sign_at_lower());
      EXPECT_EQ(square_free.sign_at(r.lower()) * square_free.sign_at(r.upper()), Sign::kNegative);
    }
    if (i == 0) continue;
    const RealRoot& previous = roots[i - 1].root;
    EXPECT_LE(previous.upper(), r.lower());
    if (previous.is_rational() || r.is_rational()) {
      EXPECT_LT(previous.upper(), r.lower());
    }
  }
}

TEST(RealRoot, ConstructorChecksItsArguments) {
  const Polynomial p = polynomial({-2, 0, 1});
  EXPECT_NO_THROW(RealRoot(p, Rational(1), rational("3/2")));
  EXPECT_THROW(RealRoot(p, Rational(1), rational("4/3")), std::logic_error);  // same sign
  EXPECT_THROW(RealRoot(p, Rational(1), rational("5/3")), std::logic_error);  // not dyadic
  EXPECT_THROW(RealRoot(p, Rational(2), Rational(1)), std::logic_error);      // wrong order
  EXPECT_THROW(RealRoot(polynomial({-1, 1}), Rational(1), Rational(2)), std::logic_error);
  EXPECT_THROW(square_root_of(2).value(), std::logic_error);
}

TEST(RealRoot, RefinesToAnyWidth) {
  RootCounters counters;
  for (const int bits : {1, 10, 52, 100, 1000, 5000}) {
    RealRoot r = square_root_of(2);
    r.refine_to(bits, counters);
    EXPECT_LE(r.upper() - r.lower(), small(static_cast<unsigned long>(bits)));
    EXPECT_LT(r.lower() * r.lower(), Rational(2));
    EXPECT_GT(r.upper() * r.upper(), Rational(2));
  }
  EXPECT_GT(counters.refinements, 0U);
}

TEST(RealRoot, WidthsThatAreNoPowerOfTwo) {
  RootCounters counters;
  RealRoot r(polynomial({-2, 0, 1}), Rational(0), Rational(3));
  r.refine_to(-2, counters);
  EXPECT_EQ(r.upper(), Rational(3));  // narrow enough as it is
  r.refine_to(-1, counters);
  EXPECT_LE(r.upper() - r.lower(), Rational(2));
}

TEST(RealRoot, EveryRefinementHalvesAtLeast) {
  RootCounters counters;
  Random random(21);
  for (int i = 0; i < 40; ++i) {
    const Polynomial p = random.polynomial(5, 20);
    for (RootWithMultiplicity& entry : isolate_real_roots(p, counters)) {
      RealRoot& r = entry.root;
      for (int k = 0; k < 8 && !r.is_rational(); ++k) {
        const Rational before = r.upper() - r.lower();
        const Rational lower = r.lower();
        const Rational upper = r.upper();
        r.refine(counters);
        EXPECT_LE((r.upper() - r.lower()) * Rational(2), before);
        EXPECT_LE(lower, r.lower());
        EXPECT_LE(r.upper(), upper);
        if (!r.is_rational()) {
          EXPECT_EQ(p.sign_at(r.lower()) * p.sign_at(r.upper()),
                    entry.multiplicity % 2 == 1 ? Sign::kNegative : Sign::kPositive);
        }
      }
    }
  }
}

TEST(RealRoot, BecomesRationalWhenAnEndHitsIt) {
  RootCounters counters;
  RealRoot r(polynomial({-1, 3, -3, 1}), Rational(0), Rational(2));  // (t - 1)^3
  while (!r.is_rational()) r.refine(counters);
  EXPECT_EQ(r.value(), Rational(1));
  EXPECT_EQ(r.lower(), Rational(1));
  EXPECT_EQ(r.upper(), Rational(1));
  EXPECT_EQ(r.sign_at_lower(), Sign::kZero);
  EXPECT_EQ(r.polynomial(), polynomial({-1, 1}));
  r.refine(counters);
  r.refine_to(1000, counters);
  EXPECT_EQ(r.value(), Rational(1));
}

TEST(RealRoot, HugeAndTinyNumbers) {
  RootCounters counters;
  const Integer huge = power(Integer(10), 200);
  std::vector<RootWithMultiplicity> roots =
      isolate_real_roots(Polynomial({-huge, Integer(0), Integer(2)}), counters);
  ASSERT_EQ(roots.size(), 2U);
  EXPECT_EQ(decimal(roots[1].root, 0, counters).size(), 100U);  // 0.707 * 10^100
  EXPECT_EQ(decimal(roots[1].root, 2, counters).substr(0, 8), "70710678");
  roots = isolate_real_roots(Polynomial({Integer(-2), Integer(0), huge}), counters);
  ASSERT_EQ(roots.size(), 2U);
  EXPECT_EQ(decimal(roots[1].root, 106, counters), "0." + std::string(99, '0') + "1414213");
}

TEST(RealRoot, DoubleEnclosure) {
  RootCounters counters;
  RealRoot r = square_root_of(2);
  r.refine_to(200, counters);
  EXPECT_EQ(r.lower_double(), 0x1.6a09e667f3bccp+0);
  EXPECT_EQ(r.upper_double(), 0x1.6a09e667f3bcdp+0);
  const RealRoot third(rational("1/3"));
  EXPECT_LT(third.lower_double(), third.upper_double());
}

TEST(IsolateRealRoots, ConstructedRationalRoots) {
  RootCounters counters;
  const std::vector<Rational> expected = {rational("-1000"), rational("-22/7"),  rational("-1/3"),
                                          Rational(0),       rational("1/1024"), rational("2/3"),
                                          Rational(1),       rational("355/113")};
  const Polynomial rootless = polynomial({3, 1, 1}) * polynomial({1, 0, 0, 0, 5});
  Polynomial p = rootless;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    p = p * power(with_root(expected[i]), 1 + static_cast<int>(i % 3));
  }
  for (const Polynomial& q : {p, -p}) {
    std::vector<RootWithMultiplicity> roots = isolate_real_roots(q, counters);
    ASSERT_EQ(roots.size(), expected.size());
    expect_isolated(q, roots);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_EQ(compare(roots[i].root, expected[i], counters), 0);
      EXPECT_EQ(roots[i].multiplicity, 1 + static_cast<int>(i % 3));
    }
  }
}

TEST(IsolateRealRoots, NoRoots) {
  RootCounters counters;
  EXPECT_TRUE(isolate_real_roots(polynomial({5}), counters).empty());
  EXPECT_TRUE(isolate_real_roots(polynomial({1, 0, 1}), counters).empty());
  EXPECT_TRUE(isolate_real_roots(power(polynomial({1, 1, 1}), 3), counters).empty());
  EXPECT_THROW(isolate_real_roots(Polynomial(), counters), std::logic_error);
}

TEST(IsolateRealRoots, RootsAtZeroAndAtSplittingPoints) {
  RootCounters counters;
  for (int n = 2; n < 12; ++n) {
    const Polynomial p = wilkinson(n, -n / 2) * polynomial({-2, 0, 1});
    const std::vector<RootWithMultiplicity> roots = isolate_real_roots(p, counters);
    EXPECT_EQ(static_cast<int>(roots.size()), SturmSequence(p).count_all());
    expect_isolated(p, roots);
  }
  // An interval of one factor must not end at a root of another one.
  const Polynomial q = polynomial({-3, 0, 1}) * power(with_roots({1, 2, rational("3/2")}), 2);
  const std::vector<RootWithMultiplicity> roots = isolate_real_roots(q, counters);
  EXPECT_EQ(roots.size(), 5U);
  expect_isolated(q, roots);
}

TEST(IsolateRealRoots, Families) {
  RootCounters counters;
  const std::pair<Polynomial, std::size_t> cases[] = {
      {chebyshev(50), 50},        {chebyshev(51), 51},      {wilkinson(30, 1), 30},
      {wilkinson(20, 1000), 20},  {mignotte(9, 1000), 3},   {mignotte(20, 1000), 4},
      {mignotte(12, 1000000), 4}, {mignotte(101, 1000), 3}, {chebyshev(12) * mignotte(8, 1000), 16},
  };
  for (const auto& [p, count] : cases) {
    const std::vector<RootWithMultiplicity> roots = isolate_real_roots(p, counters);
    EXPECT_EQ(roots.size(), count) << p.to_string();
    expect_isolated(p, roots);
  }
}

TEST(IsolateRealRoots, NearlyADoubleRoot) {
  RootCounters counters;
  // (t^2 - 2)^2 -+ 2^-k: two pairs of close real roots, or no real root.
  for (const unsigned long k : {20UL, 80UL, 200UL, 1000UL}) {
    Polynomial square = power(polynomial({-2, 0, 1}), 2);
    std::vector<Integer> c = square.coefficients();
    for (Integer& x : c) x <<= k;
    c[0] -= Integer(1);
    const Polynomial with(c);
    c[0] += Integer(2);
    const Polynomial without(c);
    const std::vector<RootWithMultiplicity> roots = isolate_real_roots(with, counters);
    EXPECT_EQ(roots.size(), 4U) << k;
    expect_isolated(with, roots);
    EXPECT_TRUE(isolate_real_roots(without, counters).empty()) << k;
  }
}

TEST(IsolateRealRoots, IsDeterministic) {
  Random random(31);
  for (int i = 0; i < 30; ++i) {
    const Polynomial p = random.polynomial(7, 30);
    RootCounters first_counters;
    RootCounters second_counters;
    const auto a = isolate_real_roots(p, first_counters);
    const auto b = isolate_real_roots(p, second_counters);
    ASSERT_EQ(a.size(), b.size());
    EXPECT_EQ(first_counters.refinements, second_counters.refinements);
    for (std::size_t k = 0; k < a.size(); ++k) {
      EXPECT_EQ(a[k].root.lower(), b[k].root.lower());
      EXPECT_EQ(a[k].root.upper(), b[k].root.upper());
    }
  }
}

TEST(Compare, SameNumberFromDifferentPolynomials) {
  RootCounters counters;
  const Polynomial f = polynomial({-2, 0, 1});
  RealRoot a = square_root_of(2);
  RealRoot b(f * polynomial({7, 1, 3}), Rational(1), Rational(2));
  RealRoot c(power(f, 3), Rational(1), rational("3/2"));  // a triple root
  RealRoot d(power(f, 3) * polynomial({-3, 0, 1}), Rational(1), rational("3/2"));
  RealRoot* const all[] = {&a, &b, &c, &d};
  for (RealRoot* x : all) {
    for (RealRoot* y : all) {
      RealRoot left = *x;
      RealRoot right = *y;
      EXPECT_EQ(compare(left, right, counters), 0);
    }
  }
  EXPECT_GT(counters.gcds, 0U);
}

TEST(Compare, CommonFactorWithoutACommonRootInTheOverlap) {
  RootCounters counters;
  // Common factors t - 5 and t^2 - 7; the roots compared are sqrt(2) and about sqrt(2) + 2^-40.
  const Polynomial common = with_root(Rational(5)) * polynomial({-7, 0, 1});
  RealRoot a(polynomial({-2, 0, 1}) * common, Rational(1), Rational(2));
  std::vector<Integer> moved = {-(Integer(2) << 40) - Integer(1), Integer(0), Integer(1) << 40};
  RealRoot b(Polynomial(moved) * common, Rational(1), Rational(2));
  EXPECT_EQ(compare(a, b, counters), -1);
  EXPECT_EQ(compare(b, a, counters), 1);
}

TEST(Compare, RootsVeryCloseTogether) {
  RootCounters counters;
  for (const unsigned long k : {20UL, 80UL, 200UL, 1000UL}) {
    // sqrt(2) against the root of 2^k t^2 - 2^(k+1) - 1, and against sqrt(2)'s rational neighbours.
    RealRoot a = square_root_of(2);
    const Integer scale = Integer::power_of_two(k);
    RealRoot b(Polynomial({-(scale << 1) - Integer(1), Integer(0), scale}), Rational(1),
               Rational(2));
    EXPECT_EQ(compare(a, b, counters), -1) << k;
    RealRoot fresh = square_root_of(2);
    RealRoot c(Polynomial({-(scale << 1) + Integer(1), Integer(0), scale}), Rational(1),
               Rational(2));
    EXPECT_EQ(compare(fresh, c, counters), 1) << k;
    fresh.refine_to(static_cast<long>(k), counters);
    const Rational below = fresh.lower();
    const Rational above = fresh.upper();
    RealRoot again = square_root_of(2);
    EXPECT_EQ(compare(again, below, counters), 1);
    EXPECT_EQ(compare(again, above, counters), -1);
    RealRoot rational_root{below};
    EXPECT_EQ(compare(rational_root, again, counters), -1);
    EXPECT_EQ(compare(again, rational_root, counters), 1);
  }
}

TEST(Compare, WithRationals) {
  RootCounters counters;
  RealRoot third(polynomial({-1, 3}) * polynomial({1, 0, 1}), Rational(0), Rational(1));
  EXPECT_EQ(compare(third, rational("1/3"), counters), 0);
  EXPECT_TRUE(third.is_rational());
  RealRoot r = square_root_of(2);
  EXPECT_EQ(compare(r, Rational(0), counters), 1);  // an end of the interval
  EXPECT_EQ(compare(r, Rational(3), counters), -1);
  EXPECT_EQ(compare(r, rational("7/5"), counters), 1);
  EXPECT_EQ(compare(r, rational("17/12"), counters), -1);
  RealRoot p{rational("2/6")};
  RealRoot q{rational("1/3")};
  EXPECT_EQ(compare(p, q, counters), 0);
  RealRoot again(polynomial({-1, 3}) * polynomial({1, 0, 1}), Rational(0), Rational(1));
  EXPECT_EQ(compare(again, q, counters), 0);
}

TEST(NameRoot, IsTheSameHoweverTheRootWasFound) {
  RootCounters counters;
  const Polynomial p = polynomial({-2, 0, 1}) * polynomial({-3, 0, 1}) * with_root(rational("1/3"));
  const Polynomial q = polynomial({-5}) * power(polynomial({-2, 0, 1}), 2) *
                       power(with_root(rational("1/3")), 3) * polynomial({-3, 0, 1});
  std::vector<RootWithMultiplicity> roots = isolate_real_roots(p, counters);
  ASSERT_EQ(roots.size(), 5U);
  for (std::size_t i = 0; i < roots.size(); ++i) {
    RealRoot coarse = roots[i].root;
    RealRoot fine = roots[i].root;
    fine.refine_to(300, counters);
    const RootName a = name_root(p, coarse, counters);
    const RootName b = name_root(q, fine, counters);
    EXPECT_EQ(a.polynomial, b.polynomial);
    const bool rational = i == 2;
    EXPECT_EQ(a.polynomial, rational ? polynomial({-1, 3}) : p.canonical());
    EXPECT_EQ(a.index, rational ? 1 : static_cast<int>(i) + 1);
    EXPECT_EQ(b.index, a.index);
    EXPECT_EQ(a.lower, b.lower);
    EXPECT_EQ(a.upper, b.upper);
  }
  RealRoot wide(polynomial({-2, 0, 1}), Rational(-1), Rational(1000));
  EXPECT_EQ(name_root(p, wide, counters).index, 4);
  RealRoot third{rational("1/3")};
  EXPECT_EQ(name_root(p, third, counters).index, 1);
  RealRoot wrong{Rational(100)};
  EXPECT_THROW(name_root(p, wrong, counters), std::logic_error);
  EXPECT_THROW(name_root(Polynomial(), third, counters), std::logic_error);
}

TEST(DecimalExpansion, IsCutOffCorrectly) {
  RootCounters counters;
  RealRoot two = square_root_of(2);
  EXPECT_EQ(decimal(two, 30, counters), "1.414213562373095048801688724209");
  EXPECT_EQ(decimal(two, 0, counters), "1");
  RealRoot minus(polynomial({-2, 0, 1}), Rational(-2), Rational(-1));
  EXPECT_EQ(decimal(minus, 10, counters), "-1.4142135623");
  RealRoot half(polynomial({1, 2}) * polynomial({1, 0, 1}), Rational(-3), Rational(2));
  EXPECT_EQ(decimal(half, 4, counters), "-0.5000");
  // 7/5 terminates but is not dyadic: no interval ends at it.
  RealRoot decimal_root(polynomial({-7, 5}) * polynomial({1, 0, 1}), Rational(1), Rational(2));
  EXPECT_EQ(decimal(decimal_root, 3, counters), "1.400");
  RealRoot below(polynomial({7, 5}) * polynomial({1, 0, 1}), Rational(-2), Rational(-1));
  EXPECT_EQ(decimal(below, 3, counters), "-1.400");
  RealRoot third{rational("-1/3")};
  EXPECT_EQ(decimal(third, 5, counters), "-0.33333");
  EXPECT_THROW(decimal(third, -1, counters), std::logic_error);
}

TEST(DecimalExpansion, NearATerminatingExpansion) {
  RootCounters counters;
  const Integer scale = power(Integer(10), 60);
  for (const int offset : {-1, 1}) {
    // 7/5 -+ 10^-60 times a rootless factor.
    const Rational root = rational("7/5") + Rational(Integer(offset), scale);
    RealRoot r(with_root(root) * polynomial({1, 0, 1}), Rational(1), Rational(2));
    EXPECT_EQ(decimal(r, 3, counters), offset < 0 ? "1.399" : "1.400");
    RealRoot s(with_root(-root) * polynomial({1, 0, 1}), Rational(-2), Rational(-1));
    EXPECT_EQ(decimal(s, 3, counters), offset < 0 ? "-1.399" : "-1.400");
  }
  RealRoot tiny(with_root(Rational(Integer(-1), scale)) * polynomial({1, 0, 1}), Rational(-1),
                Rational(1));
  EXPECT_EQ(decimal(tiny, 2, counters), "-0.00");
}

TEST(RootCounters, CountTheWork) {
  RootCounters counters;
  isolate_real_roots(polynomial({-2, 0, 1}), counters);
  EXPECT_EQ(counters.isolations, 1U);
  EXPECT_EQ(counters.gcds, 0U);
  EXPECT_EQ(counters.max_bits, 2U);
  RealRoot zero{Rational(0)};
  first_sign_change_after(polynomial({-1000, 0, 1}), zero, std::nullopt, counters);
  EXPECT_EQ(counters.isolations, 2U);
  EXPECT_EQ(counters.max_bits, 10U);
}

}  // namespace real_root_test
}  // namespace kinex
