// SPDX-License-Identifier: GPL-3.0-or-later
// Continuous contact on random queries: against an independent formulation, against CGAL, against
// itself after changes that keep the answer, and the stages against each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "core/numbers/rational_value.h"
#include "predicates/ccd/contact_exact.h"
#include "predicates/ccd/contact_filter.h"
#include "predicates/ccd/continuous_contact.h"
#include "tests/predicates/ccd/contact_oracle.h"
#include "tests/predicates/ccd/contact_support.h"
#include "tests/predicates/ccd/contact_witness.h"
#include "tests/sanitized.h"

namespace kinex {
namespace contact_random_test {

using test::kSanitized;
using test::Point;
using test::Points;
using test::QueryMaker;
using test::show;

constexpr std::array<ContactKind, 2> kKinds{ContactKind::kVertexFace, ContactKind::kEdgeEdge};

std::optional<ContactTime> first(ContactKind kind, const Points& points) {
  ContactCounters counters;
  return first_contact(test::query_of(kind, points), counters);
}

bool same(std::optional<ContactTime> a, std::optional<ContactTime> b) {
  if (!a || !b) return a.has_value() == b.has_value();
  RootCounters counters;
  return compare(a->root, b->root, counters) == 0;
}

// The name does not depend on how the number was found.
bool same_name(ContactTime a, ContactTime b) {
  RootCounters counters;
  const RootName x = name_instant(a, counters), y = name_instant(b, counters);
  return x.polynomial == y.polynomial && x.index == y.index && x.lower == y.lower &&
         x.upper == y.upper;
}

class RandomContact : public testing::TestWithParam<ContactKind> {};
INSTANTIATE_TEST_SUITE_P(Kinds, RandomContact, testing::ValuesIn(kKinds), [](const auto& test) {
  return test.param == ContactKind::kVertexFace ? "VertexFace" : "EdgeEdge";
});

TEST_P(RandomContact, AgreesWithCramersRuleAndSturm) {
  QueryMaker make(1);
  int contacts = 0, irrational = 0, late = 0;
  const int rounds = kSanitized ? 40 : 400;
  for (int round = 0; round < rounds; ++round) {
    const Points points = make.small();
    std::optional<ContactTime> ours = first(GetParam(), points);
    const std::optional<test::OracleRoot> wanted = test::oracle_first_contact(GetParam(), points);
    ASSERT_EQ(ours.has_value(), wanted.has_value()) << show(GetParam(), points);
    if (!ours) continue;
    RootCounters counters;
    ++contacts;
    irrational += rational_value(ours->root, counters) ? 0 : 1;
    late += compare(ours->root, Rational(0), counters) > 0 ? 1 : 0;
    const Polynomial p = Polynomial::from_rationals(wanted->polynomial.coefficients());
    ASSERT_EQ(sign_at(p, ours->root, counters), Sign::kZero) << show(GetParam(), points);
    const int low = compare(ours->root, wanted->lower, counters);
    ASSERT_TRUE(wanted->lower == wanted->upper
                    ? low == 0
                    : low > 0 && compare(ours->root, wanted->upper, counters) <= 0)
        << show(GetParam(), points);
  }
  EXPECT_GT(contacts, rounds / 5);
  EXPECT_LT(contacts, rounds);
  EXPECT_GT(late, rounds / 20);
  EXPECT_GT(irrational, rounds / 100);
}

// At the reported time there is contact, and at no sampled time before it.
TEST_P(RandomContact, CgalSeesNoEarlierContact) {
  QueryMaker make(2);
  const int rounds = kSanitized ? 60 : 600;
  constexpr std::int64_t kSamples = 24;
  for (int round = 0; round < rounds; ++round) {
    const Points points = make.small();
    std::optional<ContactTime> ours = first(GetParam(), points);
    RootCounters counters;
    if (ours) {
      if (const std::optional<Rational> value = rational_value(ours->root, counters)) {
        ASSERT_TRUE(test::cgal_touches(GetParam(), test::positions(points, *value)))
            << show(GetParam(), points);
      }
    }
    for (std::int64_t k = 0; k <= kSamples; ++k) {
      const Rational t{Integer(k), Integer(kSamples)};
      if (ours && compare(ours->root, t, counters) <= 0) break;
      ASSERT_FALSE(test::cgal_touches(GetParam(), test::positions(points, t)))
          << show(GetParam(), points) << " at " << t.to_string();
    }
  }
}

// Invariant under reordering of the bodies' points and under affine maps.
TEST_P(RandomContact, DoesNotDependOnNamesOrCoordinates) {
  QueryMaker make(3);
  const int rounds = kSanitized ? 60 : 500;
  for (int round = 0; round < rounds; ++round) {
    const Points points = make.small();
    const std::optional<ContactTime> ours = first(GetParam(), points);
    const auto expect_same = [&](const Points& changed) {
      ASSERT_TRUE(same(ours, first(GetParam(), changed)))
          << show(GetParam(), points) << "\nand " << show(GetParam(), changed);
    };
    const auto permuted = [&](const std::array<std::size_t, 4>& order) {
      Points result;
      for (std::size_t i = 0; i < 4; ++i) {
        result[i] = points[order[i]];
        result[i + 4] = points[order[i] + 4];
      }
      return result;
    };
    if (GetParam() == ContactKind::kVertexFace) {
      for (const auto& order : {std::array<std::size_t, 4>{0, 1, 3, 2},
                                {0, 2, 1, 3},
                                {0, 2, 3, 1},
                                {0, 3, 1, 2},
                                {0, 3, 2, 1}}) {
        expect_same(permuted(order));
      }
    } else {
      for (const auto& order :
           {std::array<std::size_t, 4>{1, 0, 2, 3}, {0, 1, 3, 2}, {2, 3, 0, 1}, {3, 2, 0, 1}}) {
        expect_same(permuted(order));
      }
    }
    // An affine map, and a common motion on top.
    std::array<Rational, 9> m;
    Rational determinant;
    do {
      for (Rational& x : m) x = Rational(make.integer(-3, 3)) / Rational(make.integer(1, 3));
      determinant = m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
                    m[2] * (m[3] * m[7] - m[4] * m[6]);
    } while (determinant.is_zero());
    Points mapped;
    for (std::size_t i = 0; i < 8; ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        mapped[i][axis] = Rational(i < 4 ? 11 : -4);
        for (std::size_t k = 0; k < 3; ++k) mapped[i][axis] += m[3 * axis + k] * points[i][k];
      }
    }
    expect_same(mapped);
  }
}

// [0, 1] can be split into [0, s] and [s, 1], and time reversed.
TEST_P(RandomContact, TimeCanBeCutAndReversed) {
  QueryMaker make(4);
  const int rounds = kSanitized ? 80 : 800;
  for (int round = 0; round < rounds; ++round) {
    const Points points = make.small();
    Points reversed = points, early = points, late = points;
    std::rotate(reversed.begin(), reversed.begin() + 4, reversed.end());
    const Rational s = Rational(make.integer(1, 6)) / Rational(7);
    const std::array<Point, 4> there = test::positions(points, s);
    std::copy(there.begin(), there.end(), early.begin() + 4);
    std::copy(there.begin(), there.end(), late.begin());
    std::optional<ContactTime> whole = first(GetParam(), points);
    ASSERT_EQ(whole.has_value(), first(GetParam(), reversed).has_value())
        << show(GetParam(), points);
    RootCounters counters;
    const bool before = whole && compare(whole->root, s, counters) <= 0;
    std::optional<ContactTime> part = first(GetParam(), early);
    ASSERT_EQ(part.has_value(), before) << show(GetParam(), points);
    if (!before) part = first(GetParam(), late);
    ASSERT_EQ(part.has_value(), whole.has_value()) << show(GetParam(), points);
    if (!whole) continue;
    part->root.refine_to(80, counters);
    whole->root.refine_to(80, counters);
    // The part's clock: t = s u, or t = s + (1 - s) u.
    const Rational from = before ? Rational(0) : s, length = before ? s : Rational(1) - s;
    const Rational difference = from + length * part->root.lower() - whole->root.lower();
    ASSERT_LE(std::abs(difference.to_double()), 0x1p-78) << show(GetParam(), points);
  }
}

// A lower stage may abstain; it never contradicts the next.
TEST_P(RandomContact, FilterNeverContradictsTheExactStage) {
  QueryMaker make(5);
  const int rounds = kSanitized ? 200 : 2000;
  int known = 0, contacts = 0, misses = 0;
  for (int round = 0; round < rounds; ++round) {
    constexpr std::array<double, 8> kGaps{1, 1e-2, 1e-5, 1e-9, 1e-13, 1e-15, 1e-16, 0};
    ContactQuery::Doubles c = make.near(GetParam(), kGaps[static_cast<std::size_t>(round) % 8]);
    const int exponent = static_cast<int>(make.integer(-90, 90));
    if (make.chance(3)) {
      for (double& x : c) x = std::ldexp(x, exponent);
    }
    if (make.chance(8)) {  // in a plane, or nearly
      for (std::size_t i = 2; i < c.size(); i += 3)
        c[i] = std::ldexp(c[i], make.chance(2) ? -45 : -2000);
    }
    const ContactQuery query(GetParam(), c);
    const ContactVerdict verdict = filter_contact(query);
    if (verdict.kind == ContactVerdict::Kind::kUnknown) continue;
    ++known;
    RootCounters counters;
    const std::optional<ContactTime> exact = first_contact_exactly(query, counters);
    const bool contact = verdict.kind == ContactVerdict::Kind::kFirst;
    ++(contact ? contacts : misses);
    ASSERT_EQ(contact, exact.has_value()) << show(GetParam(), test::points_of(query));
    if (!contact) continue;
    const ContactTime time = contact_between(query, verdict.lower, verdict.upper);
    ASSERT_TRUE(same(time, exact)) << show(GetParam(), test::points_of(query));
    ASSERT_TRUE(same_name(time, *exact)) << show(GetParam(), test::points_of(query));
  }
  EXPECT_GT(known, rounds / 2);
  EXPECT_GT(contacts, rounds / 10);
  EXPECT_GT(misses, rounds / 10);
}

// The filter accounts for the rounding of coordinates that are not doubles.
TEST_P(RandomContact, RoundedCoordinates) {
  QueryMaker make(6);
  const int rounds = kSanitized ? 60 : 600;
  for (int round = 0; round < rounds; ++round) {
    Points points = make.small();
    // Thirds; or so close together that the differences are mere rounding.
    const Rational unit =
        round % 2 == 0 ? Rational(1) / Rational(3) : *Rational::from_double(0x1p-54);
    for (Point& p : points) {
      for (Rational& x : p) x = x * unit + Rational(1) / Rational(7);
    }
    const ContactQuery query = test::query_of(GetParam(), points);
    RootCounters counters;
    ContactCounters all;
    ASSERT_TRUE(same(first_contact(query, all), first_contact_exactly(query, counters)))
        << show(GetParam(), points);
  }
}

TEST_P(RandomContact, OrdinaryQueriesAreAnsweredInDoubles) {
  QueryMaker make(7);
  ContactCounters counters;
  constexpr int kRounds = 5000;
  int contacts = 0;
  for (int round = 0; round < kRounds; ++round) {
    contacts += in_contact(ContactQuery(GetParam(), make.ordinary(GetParam())), counters) ? 1 : 0;
  }
  EXPECT_EQ(counters.at_once + counters.subdivided + counters.exact,
            static_cast<std::uint64_t>(kRounds));
  EXPECT_LT(counters.exact, 5u);
  EXPECT_GT(contacts, kRounds / 20);
}

}  // namespace contact_random_test
}  // namespace kinex
