// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates with known failure instants, for both exact arithmetics.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "tests/core/arithmetic/certificate_fixture.h"

namespace kinex {
namespace exact_certificates_test {

using namespace test;

class ExactArithmetics : public testing::TestWithParam<const char*> {
 protected:
  std::string name() const { return GetParam(); }
};
INSTANTIATE_TEST_SUITE_P(Both, ExactArithmetics, testing::Values("sturm", "exact"),
                         [](const auto& parameter) { return std::string(parameter.param); });

TEST_P(ExactArithmetics, FindsTheFirstTurnFromPlusToMinus) {
  Tracks t(name(),
           {
               {Rational(3), Rational(-2)},  // 0: 3/2
               {Rational(-3), Rational(2)},  // 1: negative now
               {Rational(1), Rational(1)},   // 2: root before now
               with_roots({rational("1/3"), Rational(2), Rational(5)}, kMinus),  // 3: 1/3
               with_roots({rational("-1/3"), Rational(2), Rational(5)}, kPlus),  // 4: negative now
               with_roots({Rational(2), Rational(5)}, kRootless),                // 5: 2
               with_roots({Rational(-1), Rational(-2)}, kRootless),              // 6: never
               with_roots({Rational(7)}, times(kMinus, kRootless)),              // 7: 7
               {Rational(4)},                                                    // 8: constant
               {Rational(-4)},                                                   // 9
               {Rational(0)},                                                    // 10
           },
           Rational(0));
  EXPECT_TRUE(t.fails_at(0, rational("3/2")));
  EXPECT_EQ(t.failure(1), Outlook::kFailsNow);
  EXPECT_EQ(t.failure(2), Outlook::kNever);
  EXPECT_TRUE(t.fails_at(3, rational("1/3")));
  EXPECT_EQ(t.sign(4), Sign::kPositive);
  EXPECT_TRUE(t.fails_at(4, Rational(2)));
  EXPECT_TRUE(t.fails_at(5, Rational(2)));
  EXPECT_EQ(t.failure(6), Outlook::kNever);
  EXPECT_TRUE(t.fails_at(7, Rational(7)));
  EXPECT_EQ(t.failure(8), Outlook::kNever);
  EXPECT_EQ(t.failure(9), Outlook::kFailsNow);
  EXPECT_EQ(t.failure(10), Outlook::kIdenticallyZero);
  FailureTime time;
  t.failure(3, time);
  EXPECT_TRUE(0 <= time.lo && time.hi <= 2);
  t->release(time);
  EXPECT_EQ(t.sign(8), Sign::kPositive);
  EXPECT_EQ(t.sign(9), Sign::kNegative);
  EXPECT_EQ(t.sign(10), Sign::kZero);
}

TEST_P(ExactArithmetics, PassesOverGrazingRoots) {
  const Rational one(1), two(2), third = rational("1/3");
  Tracks t(name(),
           {
               with_roots({third, third}, kPlus),              // 0: never
               with_roots({third, third, two}, kMinus),        // 1: 2
               with_roots({third, third, third, two}, kPlus),  // 2: 1/3? + on (.., 1/3)
               with_roots({third, third, third, third, one, one, two}, kMinus),  // 3: 2
               times(times(kTwo, kTwo), {Rational(3), Rational(-1)}),            // 4: 3
               times(times(times(kTwo, kTwo), kMinusTwo), kRootless),            // 5: sqrt 2
           },
           Rational(0));
  EXPECT_EQ(t.failure(0), Outlook::kNever);
  EXPECT_TRUE(t.fails_at(1, two));
  EXPECT_TRUE(t.fails_at(2, third));
  EXPECT_TRUE(t.fails_at(3, two));
  EXPECT_TRUE(t.fails_at(4, Rational(3)));
  FailureTime time;
  ASSERT_EQ(t.failure(5, time), Outlook::kFails);
  EXPECT_EQ(t->compare(t.query(5), time, rational("1.41421356237309504880168872420")), 1);
  EXPECT_EQ(t->compare(t.query(5), time, rational("1.41421356237309504880168872421")), -1);
  EXPECT_NEAR(time.lo, std::sqrt(2.0), 1e-15);
  t->release(time);
}

TEST_P(ExactArithmetics, RootsAtNowBelongToThePast) {
  for (const char* text : {"0", "1/3", "-7/5", "1e-30"}) {
    const Rational now = rational(text), later = now + Rational(1);
    Tracks t(name(),
             {
                 with_roots({now}, kPlus),                    // 0: never
                 with_roots({now}, kMinus),                   // 1: fails now
                 with_roots({now, now}, kPlus),               // 2: grazes now
                 with_roots({now, now}, kMinus),              // 3: fails now
                 with_roots({now, later}, kMinus),            // 4: at later
                 with_roots({now, later}, kPlus),             // 5: fails now
                 with_roots({now, now, now, later}, kMinus),  // 6: at later
             },
             now);
    const Sign after[] = {Sign::kPositive, Sign::kNegative, Sign::kPositive, Sign::kNegative,
                          Sign::kPositive, Sign::kNegative, Sign::kPositive};
    for (ObjectId i = 0; i < 7; ++i) EXPECT_EQ(t.sign(i), after[i]) << text << " " << i;
    EXPECT_EQ(t.failure(0), Outlook::kNever);
    EXPECT_EQ(t.failure(1), Outlook::kFailsNow);
    EXPECT_EQ(t.failure(2), Outlook::kNever);
    EXPECT_EQ(t.failure(3), Outlook::kFailsNow);
    EXPECT_TRUE(t.fails_at(4, later));
    EXPECT_EQ(t.failure(5), Outlook::kFailsNow);
    EXPECT_TRUE(t.fails_at(6, later));
  }
}

TEST_P(ExactArithmetics, AlgebraicNow) {
  // At sqrt 2: the same number as a root of others, simple or multiple, and numbers next to it.
  const Coefficients near{rational("2") + Rational(Integer(1), Integer::power_of_two(80)),
                          Rational(0), Rational(-1)};  // root beyond sqrt 2 by about 2^-81.5
  Tracks t(name(),
           {
               kMinusTwo,                                                    // 0
               kTwo,                                                         // 1: never after now
               times(kTwo, kTwo),                                            // 2: grazes now
               times(times(kTwo, kTwo), kMinus),                             // 3: fails now
               times(kTwo, {Rational(5), Rational(-1)}),                     // 4: 5
               times(kMinusTwo, {Rational(5), Rational(-1)}),                // 5: fails now
               near,                                                         // 6: just after now
               times(near, kMinus),                                          // 7: negative now
               times(times(kTwo, kTwo), with_roots({Rational(4)}, kMinus)),  // 8: 4
           },
           Rational(0));
  t.advance(0);
  EXPECT_EQ(t.sign(0), Sign::kNegative);
  EXPECT_EQ(t.failure(0), Outlook::kFailsNow);
  EXPECT_EQ(t.sign(1), Sign::kPositive);
  EXPECT_EQ(t.failure(1), Outlook::kNever);
  EXPECT_EQ(t.sign(2), Sign::kPositive);
  EXPECT_EQ(t.failure(2), Outlook::kNever);
  EXPECT_EQ(t.failure(3), Outlook::kFailsNow);
  EXPECT_TRUE(t.fails_at(4, Rational(5)));
  EXPECT_EQ(t.failure(5), Outlook::kFailsNow);
  EXPECT_TRUE(t.fails_at(8, Rational(4)));
  FailureTime time;
  ASSERT_EQ(t.failure(6, time), Outlook::kFails);
  EXPECT_EQ(t->compare_with_now(t.query(6), time), 1);
  const auto between = t->rational_between(nullptr, nullptr);
  ASSERT_TRUE(between);
  const Query q6 = t.query(6);
  const auto gap = t->rational_between(&q6, &time);
  ASSERT_TRUE(gap);
  EXPECT_GT(*gap * *gap, Rational(2));
  EXPECT_LT(*gap * *gap, near[0]);
  t->release(time);
  EXPECT_EQ(t.sign(7), Sign::kNegative);
  t.advance(6);
  EXPECT_EQ(t.sign(7), Sign::kPositive);
  EXPECT_EQ(t.failure(7), Outlook::kNever);
}

TEST_P(ExactArithmetics, OrdersInstantsExactly) {
  const Rational tiny(Integer(1), Integer::power_of_two(80));
  const Rational one(1);
  const Coefficients three{Rational(3), Rational(0), Rational(-1)};
  Tracks t(name(),
           {
               {one, Rational(-1)},                                // 0: 1
               {one + tiny, Rational(-1)},                         // 1: 1 + 2^-80
               with_roots({one, one + tiny, one + tiny}, kMinus),  // 2: 1
               kMinusTwo,                                          // 3: sqrt 2
               times(kMinusTwo, kRootless),                        // 4: sqrt 2
               times(kMinusTwo, {rational("7/2"), Rational(-1)}),  // 5: sqrt 2
               {Rational(2) + tiny, Rational(0), Rational(-1)},    // 6: after sqrt 2
               times(times(kMinusTwo, kTwo), kTwo),                // 7: sqrt 2, triple
               {Rational(4), Rational(0), Rational(0), Rational(0), Rational(-1)},  // 8: sqrt 2
               with_roots({one, one + tiny}, kMinus),                       // 9: negative now
               {Rational(-2), Rational(3), Rational(-1)},                   // 10: negative now
               times(kMinusTwo, {Rational(-5), Rational(0), Rational(1)}),  // 11: negative now
               times(kMinusTwo, three),                                     // 12: sqrt 2, shares a
               times({Rational(2) + tiny, Rational(0), Rational(-1)}, three),  // 13: factor, later
           },
           Rational(0));
  EXPECT_EQ(t.order(0, 1), -1);
  EXPECT_EQ(t.order(0, 2), 0);
  EXPECT_EQ(t.order(2, 1), -1);
  EXPECT_EQ(t.order(1, 3), -1);
  for (ObjectId i : {3u, 4u, 5u, 7u, 8u}) {
    for (ObjectId j : {3u, 4u, 5u, 7u, 8u}) EXPECT_EQ(t.order(i, j), 0) << i << " " << j;
    EXPECT_EQ(t.order(i, 6), -1) << i;
    EXPECT_EQ(t.order(0, i), -1) << i;
  }
  EXPECT_EQ(t.order(12, 13), -1);
  EXPECT_EQ(t.order(12, 3), 0);
  EXPECT_EQ(t.order(13, 6), 0);
  for (ObjectId i : {9u, 10u, 11u}) EXPECT_EQ(t.failure(i), Outlook::kFailsNow) << i;
}

TEST_P(ExactArithmetics, NextRootAfterAdvance) {
  // The permuted certificate is the negated polynomial: 1 and 1 + 2^-80, then 3.
  const Rational tiny(Integer(1), Integer::power_of_two(80));
  const Coefficients p = with_roots({Rational(1), Rational(1) + tiny, Rational(3)}, kMinus);
  Scene scene = make_track_scene({p}, Rational(0));
  const auto arithmetic = make_arithmetic(name(), scene);
  const PredicateId order = arithmetic->bind(make_predicate<Order>());
  set_motions(scene, *arithmetic);
  const Query q(order, {1, 0}), swapped(order, {0, 1});
  const Rational expected[] = {Rational(1), Rational(1) + tiny, Rational(3)};
  for (int i = 0; i < 3; ++i) {
    const Query& current = i % 2 == 0 ? q : swapped;
    FailureTime time;
    ASSERT_EQ(arithmetic->failure(current, time), Outlook::kFails) << i;
    EXPECT_EQ(arithmetic->compare(current, time, expected[i]), 0) << i;
    EXPECT_EQ(arithmetic->compare_with_now(current, time), 1) << i;
    arithmetic->advance(current, time);
    EXPECT_EQ(arithmetic->sign_after(current), Sign::kNegative) << i;
    const InstantText text = arithmetic->describe_now();
    EXPECT_TRUE(text.exact);
    EXPECT_EQ(text.root, 1);
    EXPECT_EQ(text.polynomial.size(), 2u);
    EXPECT_EQ(rational(text.lower), expected[i]);
    EXPECT_EQ(rational(text.upper), expected[i]);
  }
  FailureTime time;
  EXPECT_EQ(arithmetic->failure(swapped, time), Outlook::kNever);
  EXPECT_EQ(time.lo, INFINITY);
  EXPECT_EQ(time.root, 0u);
}

TEST_P(ExactArithmetics, NextRootInTheSameDouble) {
  // sqrt 2, then sqrt(2 + 2^-80), then never.
  const Rational tiny(Integer(1), Integer::power_of_two(80));
  const Coefficients p = times(kMinusTwo, {Rational(2) + tiny, Rational(0), Rational(-1)});
  Scene scene = make_track_scene({p}, Rational(0));
  const auto arithmetic = make_arithmetic(name(), scene);
  const PredicateId order = arithmetic->bind(make_predicate<Order>());
  set_motions(scene, *arithmetic);
  const Query q(order, {1, 0}), swapped(order, {0, 1});
  FailureTime first, second, third;
  ASSERT_EQ(arithmetic->failure(q, first), Outlook::kFails);
  arithmetic->advance(q, first);
  EXPECT_EQ(arithmetic->describe_now().root, 3);
  ASSERT_EQ(arithmetic->failure(swapped, second), Outlook::kFails);
  EXPECT_EQ(arithmetic->compare_with_now(swapped, second), 1);
  arithmetic->advance(swapped, second);
  EXPECT_EQ(arithmetic->describe_now().root, 4);
  EXPECT_EQ(arithmetic->failure(q, third), Outlook::kNever);
  EXPECT_EQ(arithmetic->sign_after(q), Sign::kPositive);
}

TEST_P(ExactArithmetics, DescribesNow) {
  Tracks t(name(),
           {
               {rational("2/3"), Rational(-1)},                  // 0: 2/3
               times(kMinusTwo, {rational("9"), Rational(-3)}),  // 1: sqrt 2, then 3
               {Rational(0), Rational(-1)},                      // 2: negative at 2/3 and at sqrt 2
               times(kTwo, kMinus),                              // 3: sqrt 2
           },
           Rational(0));
  InstantText text = t->describe_now();
  EXPECT_EQ(text.polynomial, (std::vector<std::string>{"0", "1"}));
  EXPECT_EQ(text.root, 1);
  t.advance(0);
  text = t->describe_now();
  EXPECT_EQ(text.polynomial, (std::vector<std::string>{"-2", "3"}));
  EXPECT_EQ(text.root, 1);
  EXPECT_EQ(text.approximate, "0.666666666666");
  t.advance(2);  // not a root of this polynomial: the instant keeps its name
  EXPECT_EQ(t->describe_now().polynomial, text.polynomial);
  EXPECT_EQ(t->describe_now().root, 1);
  t.advance(1);
  text = t->describe_now();
  EXPECT_EQ(text.polynomial, (std::vector<std::string>{"6", "-2", "-3", "1"}));
  EXPECT_EQ(text.root, 2);
  EXPECT_EQ(text.approximate, "1.41421356237");
  EXPECT_EQ(text.lower, "1");
  EXPECT_EQ(text.upper, "2");
  const std::uint64_t number = t->name_now(InstantDetail::kName).number;
  t.advance(3);  // the same instant under another certificate
  EXPECT_EQ(t->describe_now().polynomial, text.polynomial);
  t.advance(2);
  EXPECT_EQ(t->describe_now().polynomial, text.polynomial);
  EXPECT_EQ(t->name_now(InstantDetail::kName).number, number);
  const InstantName& enclosed = t->name_now(InstantDetail::kInterval);
  EXPECT_NE(enclosed.number, number);
  EXPECT_EQ(enclosed.polynomial.degree(), -1);
  EXPECT_EQ(enclosed.lower, rational("0x1.6a09e667f2p+0"));
  EXPECT_EQ(enclosed.upper, rational("0x1.6a09e667f4p+0"));
  EXPECT_EQ(enclosed.decimal, "1.41421356237");
  EXPECT_NEAR(t->now_approximate(), std::sqrt(2.0), 1e-5);
  t->set_now(rational("-5/4"));
  text = t->describe_now();
  EXPECT_EQ(text.polynomial, (std::vector<std::string>{"5", "4"}));
  EXPECT_EQ(text.approximate, "-1.25000000000");
  EXPECT_EQ(text.lower, "-5/4");
  EXPECT_EQ(text.upper, "-5/4");
}

TEST_P(ExactArithmetics, FailuresUpToTheHorizon) {
  const std::vector<Coefficients> tracks{
      {Rational(1), Rational(-1)},                                          // 0: exactly at the end
      with_roots({Rational(1), Rational(2)}, kPlus),                        // 1: exactly at the end
      {rational("1/2"), Rational(-1)},                                      // 2: before it
      with_roots({rational("1/2"), rational("1/2"), Rational(1)}, kMinus),  // 3: at the end
  };
  Tracks t(name(), tracks, Rational(0), Rational(1));
  for (ObjectId i : {0u, 1u, 3u}) EXPECT_TRUE(t.fails_at(i, Rational(1))) << i;
  EXPECT_TRUE(t.fails_at(2, rational("1/2")));
}

TEST_P(ExactArithmetics, WiderMotionAtRunTime) {
  Tracks t(name(), {{Rational(1), Rational(-1)}, {Rational(2), Rational(-1)}}, Rational(0));
  Trajectory wide;
  wide.coordinates = {with_roots({rational("1/2"), Rational(2), Rational(3), Rational(4)}, kMinus)};
  wide.normalise();
  t->set_motion(0, wide, std::nullopt);
  EXPECT_EQ(t.sign(0), Sign::kNegative);
  EXPECT_TRUE(t.fails_at(1, Rational(2)));
  t->set_now(Rational(1));
  EXPECT_TRUE(t.fails_at(0, Rational(2)));
  EXPECT_TRUE(t.fails_at(1, Rational(2)));
}

TEST_P(ExactArithmetics, ExtremeMagnitudes) {
  Tracks t(name(),
           {
               {rational("1e-300"), Rational(-1)},
               {rational("1e300"), Rational(-1)},
               {rational("2e-600"), Rational(0), Rational(-1)},
               {rational("2e600"), Rational(0), Rational(-1)},
               {rational("1e400"), Rational(-1)},  // beyond the range of doubles
           },
           Rational(0));
  EXPECT_TRUE(t.fails_at(0, rational("1e-300")));
  EXPECT_TRUE(t.fails_at(1, rational("1e300")));
  EXPECT_TRUE(t.fails_at(4, rational("1e400")));
  EXPECT_EQ(t.order(0, 2), -1);
  EXPECT_EQ(t.order(2, 1), -1);
  EXPECT_EQ(t.order(1, 3), -1);
  EXPECT_EQ(t.order(3, 4), -1);
}

// Equal instants are merged into one form, but each certificate keeps its polynomial.
TEST_P(ExactArithmetics, EqualInstantsKeepTheirNames) {
  const Coefficients one{Rational(1), Rational(-1)};  // 1
  for (const Coefficients& p : {kMinusTwo, one}) {
    Tracks t(name(), {p, times(p, kRootless), {Rational(0), Rational(-1)}}, Rational(0));
    t->set_now(rational("1/2"));
    FailureTime a, b, c;
    ASSERT_EQ(t.failure(0, a), Outlook::kFails);
    ASSERT_EQ(t.failure(1, b), Outlook::kFails);
    t->advance(t.query(0), a);
    ASSERT_EQ(t.failure(2, c), Outlook::kFailsNow);
    EXPECT_EQ(t->compare(t.query(1), b, t.query(2), c), 0);
    EXPECT_EQ(t->compare(t.query(2), c, t.query(1), b), 0);
    t->advance(t.query(2), c);  // its polynomial does not vanish now
    EXPECT_EQ(t->describe_now().polynomial.size(), p.size());
    t->advance(t.query(1), b);  // this one's does, but the instant is already named
    EXPECT_EQ(t->describe_now().polynomial.size(), p.size());
  }
}

}  // namespace exact_certificates_test
}  // namespace kinex
