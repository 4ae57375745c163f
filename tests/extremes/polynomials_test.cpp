// SPDX-License-Identifier: GPL-3.0-or-later
// The polynomials of the corpus of extremes: all real roots with their multiplicities, their number
// by both Sturm sequences, and the sign changes from each one to the next.
#include <gtest/gtest.h>

#include <limits>

#include "core/numbers/rational_sturm.h"
#include "core/numbers/sturm_sequence.h"
#include "tests/extremes/extreme.h"

namespace kinex::extremes {
namespace polynomials_test {

void expect_roots(Extreme& extreme, const Polynomial& p) {
  RootCounters counters;
  std::vector<RootWithMultiplicity> roots = isolate_real_roots(p, counters);
  ASSERT_EQ(roots.size(), extreme.roots.size());
  for (std::size_t i = 0; i < roots.size(); ++i) {
    auto& [place, multiplicity] = extreme.roots[i];
    EXPECT_TRUE(is_at(roots[i].root, place)) << "root " << i + 1 << " is not " << place.text;
    EXPECT_EQ(roots[i].multiplicity, multiplicity) << place.text;
    EXPECT_EQ(sign_at(p, roots[i].root, counters), Sign::kZero);
    const bool changes =
        sign_before(p, roots[i].root, counters) != sign_after(p, roots[i].root, counters);
    EXPECT_EQ(changes, multiplicity % 2 == 1) << place.text;
    if (i > 0) {
      EXPECT_LT(compare(roots[i - 1].root, roots[i].root, counters), 0);
    }
  }
}

void expect_counts(const Extreme& extreme, const Polynomial& p) {
  EXPECT_EQ(SturmSequence(p).count_all(), static_cast<int>(extreme.roots.size()));
  EXPECT_EQ(SturmSequence(p).count_between(extreme.start, extreme.end),
            static_cast<int>(extreme.roots.size()));
  std::vector<Rational> coefficients;
  for (const Integer& c : p.coefficients()) coefficients.emplace_back(c);
  SturmWork work;
  EXPECT_EQ(RationalSturm(RationalPolynomial(coefficients), work).count(extreme.start, extreme.end),
            static_cast<int>(extreme.roots.size()));
}

void expect_sign_changes(Extreme& extreme, const Polynomial& p) {
  RootCounters counters;
  RealRoot now(extreme.start);
  for (auto& [place, multiplicity] : extreme.roots) {
    if (multiplicity % 2 == 0) continue;
    std::optional<RealRoot> next = first_sign_change_after(p, now, extreme.end, counters);
    ASSERT_TRUE(next) << "none at " << place.text;
    EXPECT_TRUE(is_at(*next, place)) << place.text;
    now = *next;
  }
  EXPECT_FALSE(first_sign_change_after(p, now, extreme.end, counters));
}

TEST(ExtremePolynomials, HaveTheRootsThatTheIndexSays) {
  std::size_t seen = 0;
  for (Extreme& extreme : read_extremes()) {
    if (extreme.polynomial.empty()) continue;
    SCOPED_TRACE(extreme.name);
    ++seen;
    const Polynomial p = read_polynomial(extreme);
    expect_roots(extreme, p);
    expect_counts(extreme, p);
    expect_sign_changes(extreme, p);
  }
  EXPECT_GE(seen, 30u);
}

}  // namespace polynomials_test
}  // namespace kinex::extremes
