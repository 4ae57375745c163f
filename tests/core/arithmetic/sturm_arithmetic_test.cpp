// SPDX-License-Identifier: GPL-3.0-or-later
// Properties of `sturm` alone; its answers are tested in exact_certificates_test.cpp and
// arithmetic_agreement_test.cpp.
#include "core/arithmetic/sturm_arithmetic.h"

#include <gtest/gtest.h>

#include "tests/core/arithmetic/certificate_fixture.h"

namespace kinex {
namespace sturm_arithmetic_test {

using namespace test;

TEST(SturmArithmetic, NothingBeyondTheHorizon) {
  Scene scene =
      make_track_scene({{Rational(1), Rational(-1)}, {Rational(3), Rational(-1)}}, Rational(0));
  scene.end = Rational(2);
  const auto arithmetic = make_arithmetic("sturm", scene);
  const PredicateId order = arithmetic->bind(make_predicate<Order>());
  set_motions(scene, *arithmetic);
  FailureTime time;
  EXPECT_EQ(arithmetic->failure(Query(order, {2, 0}), time), Outlook::kFails);
  arithmetic->release(time);
  EXPECT_EQ(arithmetic->failure(Query(order, {2, 1}), time), Outlook::kNever);
  arithmetic->set_motion(0, scene.objects[0].motion.pieces[0].trajectory, rational("9/10"));
  EXPECT_EQ(arithmetic->failure(Query(order, {2, 0}), time), Outlook::kNever);
  EXPECT_EQ(arithmetic->failure(Query(order, {1, 0}), time), Outlook::kFailsNow);
  arithmetic->release(time);
}

TEST(SturmArithmetic, CountsItsWork) {
  Scene scene = make_track_scene({kMinusTwo, {Rational(3), Rational(-1)}}, Rational(0));
  const auto arithmetic = make_arithmetic("sturm", scene);
  const PredicateId order = arithmetic->bind(make_predicate<Order>());
  set_motions(scene, *arithmetic);
  const PredicateId unused = arithmetic->bind(make_predicate<Order>());
  const Query qa(order, {2, 0}), qb(order, {2, 1});
  FailureTime a, b;
  arithmetic->failure(qa, a);
  arithmetic->failure(qb, b);
  arithmetic->compare(qa, a, qb, b);
  arithmetic->sign_after(Query(order, {0, 1}));
  const ArithmeticCounters& c = arithmetic->counters();
  const auto kExact = static_cast<std::size_t>(Stage::kExact);
  ASSERT_EQ(c.by_predicate.size(), 2u);
  EXPECT_EQ(c.by_predicate[order].failures[kExact], 2u);
  EXPECT_EQ(c.by_predicate[order].signs[kExact], 1u);
  EXPECT_EQ(c.by_predicate[unused].failures[kExact], 0u);
  EXPECT_EQ(c.comparisons[kExact], 1u);
  EXPECT_EQ(c.polynomials_solved, (std::vector<std::uint64_t>{0, 1, 1}));
  EXPECT_GT(c.max_bits, 0u);
}

TEST(SturmArithmetic, ReleasedPlacesAreUsedAgain) {
  Tracks t("sturm", {kMinusTwo, times(kMinusTwo, kRootless), kMinus}, Rational(0));
  std::size_t before = 0;
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(t.order(0, 1), 0);  // one form for both
    EXPECT_EQ(t.failure(2), Outlook::kFailsNow);
    if (i == 0) before = t->bytes();
  }
  EXPECT_EQ(t->bytes(), before);
}

TEST(SturmArithmetic, EqualInstantsShareOneForm) {
  Tracks t("sturm", {kMinusTwo, times(kMinusTwo, kRootless)}, Rational(0));
  FailureTime a, b;
  t.failure(0, a);
  t.failure(1, b);
  EXPECT_NE(a.root, b.root);
  EXPECT_EQ(t->compare(t.query(0), a, t.query(1), b), 0);
  EXPECT_EQ(a.root, b.root);
  const auto gcds = t->counters().gcds;
  EXPECT_EQ(t->compare(t.query(0), a, t.query(1), b), 0);
  EXPECT_EQ(t->counters().gcds, gcds);
  t->release(a);
  t->advance(t.query(1), b);
  EXPECT_EQ(t.sign(0), Sign::kNegative);
}

}  // namespace sturm_arithmetic_test
}  // namespace kinex
