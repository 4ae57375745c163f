// SPDX-License-Identifier: GPL-3.0-or-later
// Names of instants: the filtered method, the exact one and that of `sturm` agree, and the names
// are as defined in core/numbers/real_root.h.
#include "core/numbers/instant_name.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/arithmetic/root_namer.h"
#include "core/arithmetic/sturm_name.h"
#include "core/numbers/instant_digits.h"
#include "core/numbers/number_text.h"
#include "core/numbers/polynomial_gcd.h"
#include "core/numbers/rational_root.h"
#include "core/numbers/sturm_sequence.h"
#include "tests/core/numbers/polynomial_fixture.h"

namespace kinex {
namespace instant_name_test {

using fixture::mignotte;
using fixture::polynomial;
using fixture::power;
using fixture::Random;
using fixture::rational;
using fixture::wilkinson;
using fixture::with_root;

std::string to_string(const InstantName& name) {
  return name.polynomial.to_string() + " root " + std::to_string(name.root) + " in [" +
         name.lower.to_string() + ", " + name.upper.to_string() + "]";
}

InstantName as_name(const RootName& root) {
  InstantName name;
  name.polynomial = root.polynomial;
  name.root = root.index;
  name.lower = root.lower;
  name.upper = root.upper;
  return name;
}

// t -> p(t - by), cleared of denominators.
Polynomial moved(const Polynomial& p, const Rational& by) {
  std::vector<Rational> c(p.coefficients().begin(), p.coefficients().end());
  for (std::size_t i = 0; i + 1 < c.size(); ++i) {
    for (std::size_t j = c.size() - 1; j-- > i;) c[j] -= by * c[j + 1];
  }
  return Polynomial::from_rationals(c);
}

// t -> p(t / by).
Polynomial stretched(const Polynomial& p, const Rational& by) {
  std::vector<Rational> c;
  Rational factor(1);
  for (const Integer& x : p.coefficients()) {
    c.push_back(Rational(x) * factor);
    factor /= by;
  }
  return Polynomial::from_rationals(c);
}

// The coarser cell of which a cell (or its mirror image) is a half; false if it is a whole binade.
bool widen(const Rational& lower, const Rational& upper, Rational& wide_lower,
           Rational& wide_upper) {
  const Rational width = upper - lower;
  const Rational near = lower.sign() < 0 ? -upper : lower;
  if (near == width) return false;
  const bool odd = !((near / width).numerator().is_even());
  const Rational from = odd ? near - width : near;
  wide_lower = lower.sign() < 0 ? -(from + width + width) : from;
  wide_upper = lower.sign() < 0 ? -from : from + width + width;
  return true;
}

struct Tally {
  int roots = 0, fast = 0, rational = 0;
};

// All odd roots of p.
void check_names(const Polynomial& p, Tally& tally, const std::string& what) {
  RootCounters counters;
  const SturmSequence sturm(p);
  for (RootWithMultiplicity& entry : isolate_real_roots(p, counters)) {
    RealRoot& root = entry.root;
    ++tally.roots;
    const std::string where = what + ": " + p.to_string();
    const RootName name = name_root(p, root, counters);
    if (name.lower == name.upper) {
      ++tally.rational;
      EXPECT_EQ(p.sign_at(name.lower), Sign::kZero) << where;
      EXPECT_EQ(name.polynomial, with_root(name.lower)) << where;
      EXPECT_EQ(name.index, 1) << where;
    } else {
      EXPECT_EQ(name.polynomial, square_free_part(p)) << where;
      EXPECT_EQ(sturm.count_between(name.lower, name.upper), 1) << where;
      EXPECT_NE(p.sign_at(name.lower), Sign::kZero) << where;
      EXPECT_NE(p.sign_at(name.upper), Sign::kZero) << where;
      EXPECT_EQ(sturm.count_all() - sturm.count_above(name.upper), name.index) << where;
      EXPECT_LT(compare(root, name.upper, counters), 0) << where;
      EXPECT_GT(compare(root, name.lower, counters), 0) << where;
      Rational lower, upper;
      if (widen(name.lower, name.upper, lower, upper)) {
        EXPECT_TRUE(sturm.count_between(lower, upper) > 1 || p.sign_at(lower) == Sign::kZero)
            << where << ": not the coarsest";
      }
    }
    const InstantName expected = as_name(name);
    InstantName by_sturm;
    const Polynomial& own = root.polynomial();
    name_by_sturm(RationalPolynomial({p.coefficients().begin(), p.coefficients().end()}),
                  root.is_rational() ? SturmInstant(root.value())
                                     : SturmInstant(RationalPolynomial({own.coefficients().begin(),
                                                                        own.coefficients().end()}),
                                                    root.lower(), root.upper()),
                  by_sturm);
    EXPECT_EQ(to_string(by_sturm), to_string(expected)) << where;
    if (entry.multiplicity % 2 == 0) continue;
    double lo = 0, hi = 0;
    do {
      root.refine(counters);
      lo = root.lower_double();
      hi = root.upper_double();
    } while (!root.is_rational() && hi - lo > 0x1p-48 * std::max(std::fabs(lo), std::fabs(hi)) &&
             hi - lo > 0x1p-1000);
    if (!(lo < hi) || !std::isfinite(lo) || !std::isfinite(hi) ||
        sturm.count_between(*Rational::from_double(lo), *Rational::from_double(hi)) != 1 ||
        p.sign_at(*Rational::from_double(lo)) == Sign::kZero ||
        p.sign_at(*Rational::from_double(hi)) == Sign::kZero) {
      continue;
    }
    RootNamer namer;
    InstantName fast;
    std::vector<Integer> c = p.coefficients();
    if (!namer.name(c, lo, hi, fast)) continue;
    ++tally.fast;
    EXPECT_EQ(to_string(fast), to_string(expected)) << where;
  }
}

TEST(InstantName, OfRandomPolynomials) {
  Random random(1);
  for (const int bits : {3, 8, 20, 60, 200}) {
    Tally tally;
    for (int i = 0; i < 360; ++i) {
      const Polynomial p = random.polynomial(1 + i % 12, bits);
      if (p.degree() < 1) continue;
      check_names(p, tally, std::to_string(bits) + " bits");
    }
    EXPECT_GT(tally.roots, 500);
    EXPECT_GT(10 * tally.fast, 8 * tally.roots)
        << bits << " bits: " << tally.fast << " of " << tally.roots;
  }
}

TEST(InstantName, OfRationalRootsAmongOthers) {
  Random random(2);
  Tally tally;
  for (int i = 0; i < 300; ++i) {
    Polynomial p = random.polynomial(1 + i % 4, 12);
    for (int k = 0; k <= i % 3; ++k) {
      const Integer den = Integer(1) + abs(random.integer(i % 5 * 8));
      p = p * with_root(Rational(random.integer(10 + i % 20), den));
    }
    if (i % 7 == 0) p = p * with_root(Rational(0));
    if (p.degree() < 1) continue;
    check_names(p, tally, "rational roots");
  }
  EXPECT_GT(tally.rational, 500);
}

TEST(InstantName, OfMultipleAndCloseRoots) {
  Tally tally;
  Random random(3);
  for (int i = 0; i < 60; ++i) {
    const Polynomial p = random.polynomial(1 + i % 3, 10), q = random.polynomial(1 + i % 2, 6);
    if (p.degree() < 1 || q.degree() < 1) continue;
    check_names(power(p, 1 + i % 3) * power(q, 1 + i % 4), tally, "multiple roots");
  }
  for (const int d : {3, 4, 5, 8}) {
    for (const std::int64_t a : {10, 1000, 12345678})
      check_names(mignotte(d, a), tally, "Mignotte");
  }
  for (int bits = 20; bits <= 200; bits += 30) {
    // sqrt 2 and sqrt(2 + 2^-bits), and their negatives.
    const Integer scale = Integer::power_of_two(static_cast<unsigned long>(bits));
    const Polynomial close({-(scale * Integer(2) + Integer(1)), Integer(0), scale});
    check_names(close * polynomial({-2, 0, 1}), tally, "close");
  }
  check_names(wilkinson(9, -4), tally, "Wilkinson");
  check_names(wilkinson(9, -4) + polynomial({1}), tally, "Wilkinson");
  EXPECT_GT(tally.roots, 200);
}

TEST(InstantName, FarAwayHugeAndTiny) {
  Tally tally;
  Random random(4);
  for (int i = 0; i < 60; ++i) {
    const Polynomial p = random.polynomial(2 + i % 7, 10);
    if (p.degree() < 1) continue;
    check_names(moved(p, rational("1700000000")), tally, "far away");
    check_names(moved(p, rational("-12345.6789")), tally, "far away");
    check_names(stretched(p, rational(i % 2 == 0 ? "1e-30" : "1e25")), tally, "stretched");
  }
  EXPECT_GT(10 * tally.fast, 8 * tally.roots) << tally.fast << " of " << tally.roots;
  for (const char* by : {"1e-300", "1e300", "1e-320", "1e-400", "1e400"}) {
    for (int i = 0; i < 8; ++i) {
      const Polynomial p = random.polynomial(2 + i % 4, 10);
      if (p.degree() > 0) check_names(stretched(p, rational(by)), tally, by);
    }
  }
}

// Against integers.
std::string truncated(const Rational& t) {
  std::string text;
  set_decimal(text, t);
  return text;
}

TEST(InstantName, DecimalsAreTruncatedToSignificantDigits) {
  EXPECT_EQ(truncated(Rational(0)), "0");
  EXPECT_EQ(truncated(Rational(1)), "1.00000000000");
  EXPECT_EQ(truncated(rational("-2/3")), "-0.666666666666");
  EXPECT_EQ(truncated(rational("0.00001")), "0.0000100000000000");
  EXPECT_EQ(truncated(rational("0.00000999999999999")), "9.99999999999e-6");
  EXPECT_EQ(truncated(rational("999999999999.99")), "999999999999");
  EXPECT_EQ(truncated(rational("-1000000000000")), "-1.00000000000e12");
  EXPECT_EQ(truncated(rational("1e-320")), "1.00000000000e-320");
  EXPECT_EQ(truncated(rational("-123456789012345678e-400")), "-1.23456789012e-383");
  EXPECT_EQ(truncated(rational("9.99999999999999e999")), "9.99999999999e999");
  Random random(5);
  for (int i = 0; i < 3000; ++i) {
    const Integer n = random.integer(1 + i % 90);
    const Rational t(n, Integer(1) + abs(random.integer(1 + i % 70)));
    const std::string text = truncated(t);
    const std::optional<DecimalRange> range = decimal_range(text);
    ASSERT_TRUE(range) << text;
    const Rational near = t.sign() < 0 ? range->upper : range->lower;
    const Rational far = t.sign() < 0 ? range->lower : range->upper;
    EXPECT_TRUE(t.sign() < 0 ? far < t && t <= near : t == near || (near < t && t < far)) << text;
    // Doubles around it give the same, or abstain.
    std::string filtered;
    if (set_decimal(filtered, t.lower_double(), t.upper_double())) {
      EXPECT_EQ(filtered, text);
    } else {
      EXPECT_TRUE(filtered.empty());
    }
    RealRoot root(t);
    RootCounters counters;
    EXPECT_EQ(instant_decimal(root, counters), text);
  }
  for (const char* other : {"", "1", "1.0", "0.0", "-0", "10.0000000000 ", "1.00000000000e11",
                            "nan", "1.000000000000", "1.00000000000e0", "00.500000000000", "1/2"}) {
    EXPECT_FALSE(decimal_range(other)) << other;
  }
}

TEST(InstantName, AreComparedExactly) {
  RootCounters counters;
  Random random(6);
  std::vector<InstantName> names;
  std::vector<RealRoot> roots;
  const auto add = [&](const Polynomial& p) {
    for (RootWithMultiplicity& entry : isolate_real_roots(p, counters)) {
      names.push_back(as_name(name_root(p, entry.root, counters)));
      names.back().detail = InstantDetail::kName;
      names.back().exact = true;
      roots.push_back(std::move(entry.root));
    }
  };
  // Roots of several polynomials, isolated by a cell in one and not in another; rational roots.
  const Polynomial two = polynomial({-2, 0, 1});
  for (const std::int64_t k : {-3, 1, 2, 3})
    add(two * polynomial({-k, 0, 2}) * polynomial({-k, 3}));
  for (int i = 0; i < 6; ++i) add(two * random.polynomial(3, 4));
  for (std::size_t i = 0; i < names.size(); ++i) {
    for (std::size_t j = 0; j < names.size(); ++j) {
      EXPECT_EQ(compare(names[i], names[j], counters), compare(roots[i], roots[j], counters))
          << to_string(names[i]) << " and " << to_string(names[j]);
    }
  }
}

TEST(InstantName, NumbersAreWrittenAsTheyAre) {
  Random random(7);
  for (int i = 0; i < 4000; ++i) {
    const Integer n = random.integer(1 + i % 200);
    std::string text = "x";
    append(text, n);
    EXPECT_EQ(text, "x" + n.to_string());
    const Rational q(n, Integer(1) + abs(random.integer(i % 90)));
    append(text, q);
    EXPECT_EQ(text, "x" + n.to_string() + q.to_string());
  }
  for (const char* edge :
       {"0", "-1", "9999999999999999999", "10000000000000000000",
        "100000000000000000000000000000000000000", "18446744073709551615", "18446744073709551616",
        "340282366920938463463374607431768211455", "-340282366920938463463374607431768211456"}) {
    std::string text;
    append(text, *Integer::parse(edge));
    EXPECT_EQ(text, edge);
  }
}

TEST(InstantName, CellIsTheBinaryDigitsThatTellTheRootFromTheOthers) {
  RootCounters counters;
  // 1.41.. alone in [1, 2]; with 1.73.. beside it, in [1, 3/2].
  RealRoot root(polynomial({-2, 0, 1}), Rational(1), Rational(2));
  RootName name = name_root(polynomial({-2, 0, 1}), root, counters);
  EXPECT_EQ(to_string(as_name(name)), "-2 0 1 root 2 in [1, 2]");
  name = name_root(polynomial({-2, 0, 1}) * polynomial({-3, 0, 1}), root, counters);
  EXPECT_EQ(to_string(as_name(name)), "6 0 -5 0 1 root 3 in [1, 3/2]");
  RealRoot below(polynomial({-3, 0, 1}), Rational(-2), Rational(-1));
  name = name_root(polynomial({-2, 0, 1}) * polynomial({-3, 0, 1}), below, counters);
  EXPECT_EQ(to_string(as_name(name)), "6 0 -5 0 1 root 1 in [-2, -3/2]");
  // A cell may not end at a root: 3/2 is one.
  name = name_root(polynomial({-2, 0, 1}) * polynomial({-3, 2}), root, counters);
  EXPECT_EQ(to_string(as_name(name)), "6 -4 -3 2 root 2 in [11/8, 23/16]");
}

}  // namespace instant_name_test
}  // namespace kinex
