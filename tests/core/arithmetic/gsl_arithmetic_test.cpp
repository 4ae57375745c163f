// SPDX-License-Identifier: GPL-3.0-or-later
// `gsl` guarantees no answers. Tested: easy certificates are right, the root at now is not found
// again, and no input crashes it or yields a NaN.
#include "core/arithmetic/gsl_arithmetic.h"

#include <gsl/gsl_errno.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>

#include "tests/core/arithmetic/certificate_fixture.h"

namespace kinex {
namespace gsl_arithmetic_test {

using namespace test;

struct Answer {
  Outlook outlook;
  double t;
};

// The failure of "track >= 0" after `now`.
Answer solve(const Coefficients& track, const Rational& now,
             const std::optional<Rational>& end = std::nullopt) {
  Scene scene = make_track_scene({track}, now);
  scene.end = end;
  const auto arithmetic = make_arithmetic("gsl", scene);
  const PredicateId id = arithmetic->bind(make_predicate<Order>());
  set_motions(scene, *arithmetic);
  FailureTime time;
  const Outlook outlook = arithmetic->failure(Query(id, {1, 0}), time);
  EXPECT_EQ(time.lo, time.hi);
  return {outlook, time.lo};
}

TEST(GslArithmetic, FindsFirstFailures) {
  const Rational zero(0);
  Answer a = solve({Rational(3), Rational(-2)}, zero);
  EXPECT_EQ(a.outlook, Outlook::kFails);
  EXPECT_DOUBLE_EQ(a.t, 1.5);
  a = solve({Rational(2), Rational(0), Rational(-1)}, zero);
  EXPECT_EQ(a.outlook, Outlook::kFails);
  EXPECT_DOUBLE_EQ(a.t, std::sqrt(2.0));
  a = solve(with_roots({Rational(-1), Rational(2), Rational(5)}, kPlus), zero);
  EXPECT_EQ(a.outlook, Outlook::kFails);
  EXPECT_NEAR(a.t, 2, 1e-14);
  for (int roots = 1; roots <= 5; ++roots) {  // degrees 3 to 7, half of them negative at 0
    std::vector<Rational> list;
    for (int k = 1; k <= roots; ++k) list.push_back(Rational(k));
    a = solve(with_roots(list, times(roots % 2 == 0 ? kPlus : kMinus, kRootless)), zero);
    EXPECT_EQ(a.outlook, Outlook::kFails) << roots;
    EXPECT_NEAR(a.t, 1, 1e-9) << roots;
    a = solve(with_roots(list, times(roots % 2 == 0 ? kMinus : kPlus, kRootless)), zero);
    EXPECT_EQ(a.outlook, Outlook::kFailsNow) << roots;
    a = solve(with_roots(list, times(kMinus, kRootless)), Rational(roots) + rational("1/2"));
    EXPECT_EQ(a.outlook, Outlook::kFailsNow) << roots;
    a = solve(with_roots(list, times(kPlus, kRootless)), Rational(roots) + rational("1/2"));
    EXPECT_EQ(a.outlook, Outlook::kNever) << roots;
    EXPECT_EQ(a.t, INFINITY);
  }
}

TEST(GslArithmetic, SolvesCubicsThatAreNotMonic) {
  for (int lead : {-6, -2}) {
    const Answer a =
        solve(with_roots({Rational(1), Rational(2), Rational(3)}, {Rational(lead)}), Rational(0));
    EXPECT_EQ(a.outlook, Outlook::kFails);
    EXPECT_NEAR(a.t, 1, 1e-12);
  }
}

TEST(GslArithmetic, PassesOverGrazingRoots) {
  for (const Coefficients& factor : {kMinus, times(kMinus, kRootless)}) {
    const Answer a =
        solve(with_roots({Rational(1), Rational(1), Rational(4)}, factor), Rational(0));
    EXPECT_EQ(a.outlook, Outlook::kFails);
    EXPECT_NEAR(a.t, 4, 1e-6);
  }
}

TEST(GslArithmetic, InfiniteCoefficientsNeverFail) {
  EXPECT_EQ(solve({Rational(1), rational("-1e400")}, Rational(-1)).outlook, Outlook::kNever);
  EXPECT_EQ(solve({rational("1e400"), Rational(-1)}, Rational(-1)).outlook, Outlook::kNever);
}

// GSL aborts by default.
TEST(GslArithmetic, TurnsOffTheErrorHandler) {
  solve({Rational(1)}, Rational(0));
  gsl_error("provoked by a test", __FILE__, __LINE__, GSL_EFAILED);
}

TEST(GslArithmetic, DegreesDropAndVanish) {
  const Rational zero(0);
  EXPECT_EQ(solve({zero}, zero).outlook, Outlook::kIdenticallyZero);
  EXPECT_EQ(solve({Rational(1)}, zero).outlook, Outlook::kNever);
  EXPECT_EQ(solve({Rational(-1)}, zero).outlook, Outlook::kFailsNow);
  EXPECT_EQ(solve({zero, Rational(-1)}, zero).outlook, Outlook::kFailsNow);
  EXPECT_EQ(solve({zero, Rational(1)}, zero).outlook, Outlook::kNever);
  // Two objects that move alike: the quadratic terms cancel.
  Scene scene =
      make_track_scene({{zero, zero, Rational(3)}, {Rational(4), Rational(-2), Rational(3)}}, zero);
  const auto arithmetic = make_arithmetic("gsl", scene);
  const PredicateId id = arithmetic->bind(make_predicate<Order>());
  set_motions(scene, *arithmetic);
  FailureTime time;
  EXPECT_EQ(arithmetic->failure(Query(id, {0, 1}), time), Outlook::kFails);
  EXPECT_DOUBLE_EQ(time.lo, 2);
  EXPECT_EQ(arithmetic->failure(Query(id, {0, 0}), time), Outlook::kIdenticallyZero);
  EXPECT_EQ(arithmetic->counters().polynomials_solved, (std::vector<std::uint64_t>{0, 1}));
  EXPECT_EQ(arithmetic->counters().by_predicate[id].failures[0], 2u);
}

TEST(GslArithmetic, StopsAtTheHorizon) {
  EXPECT_EQ(solve({Rational(3), Rational(-1)}, Rational(0), Rational(3)).outlook, Outlook::kFails);
  EXPECT_EQ(solve({Rational(3), Rational(-1)}, Rational(0), rational("2.999")).outlook,
            Outlook::kNever);
}

TEST(GslArithmetic, PassesTheRootAtNow) {
  // order(1, 0) after order(0, 1) failed has a root at now, and the computed one may lie behind it.
  std::mt19937_64 random(11);
  const auto draw = [&random] { return Rational(static_cast<int>(random() % 2001) - 1000); };
  int failures = 0;
  for (int round = 0; round < 2000; ++round) {
    const int degree = 1 + round % 5;
    Coefficients p, q;
    for (int k = 0; k <= degree; ++k) {
      p.push_back(draw());
      q.push_back(draw());
    }
    Scene scene = make_track_scene({p, q}, Rational(0));
    const auto arithmetic = make_arithmetic("gsl", scene);
    const PredicateId id = arithmetic->bind(make_predicate<Order>());
    set_motions(scene, *arithmetic);
    Query current(id, {0, 1});
    if (arithmetic->sign_after(current) == Sign::kNegative) current = Query(id, {1, 0});
    // A polynomial of degree d changes sign at most d times.
    for (int events = 0;; ++events) {
      ASSERT_LE(events, degree);
      FailureTime time;
      const Outlook outlook = arithmetic->failure(current, time);
      ASSERT_NE(outlook, Outlook::kFailsNow);
      if (outlook != Outlook::kFails) break;
      ++failures;
      ASSERT_GT(time.lo, arithmetic->now_approximate());
      arithmetic->advance(current, time);
      FailureTime again;
      ASSERT_EQ(arithmetic->failure(current, again), Outlook::kFailsNow);
      std::swap(current.ids[0], current.ids[1]);
    }
  }
  EXPECT_GT(failures, 1000);
}

TEST(GslArithmetic, DoubleArithmeticOfInstants) {
  Scene scene =
      make_track_scene({{Rational(1), Rational(-1)}, {Rational(2), Rational(-1)}}, Rational(0));
  const auto arithmetic = make_arithmetic("gsl", scene);
  const PredicateId id = arithmetic->bind(make_predicate<Order>());
  set_motions(scene, *arithmetic);
  const Query qa(id, {2, 0}), qb(id, {2, 1});
  FailureTime a, b;
  arithmetic->failure(qa, a);
  arithmetic->failure(qb, b);
  EXPECT_EQ(arithmetic->compare(qa, a, qb, b), -1);
  EXPECT_EQ(arithmetic->compare(qb, b, qa, a), 1);
  EXPECT_EQ(arithmetic->compare(qa, a, qa, a), 0);
  EXPECT_EQ(arithmetic->compare(qa, a, Rational(1)), 0);
  EXPECT_EQ(arithmetic->compare(qa, a, rational("1.5")), -1);
  EXPECT_EQ(arithmetic->compare_with_now(qa, a), 1);
  EXPECT_EQ(*arithmetic->rational_between(&qb, &b), Rational(1));
  EXPECT_EQ(*arithmetic->rational_between(nullptr, nullptr), Rational(1));
  arithmetic->advance(qa, a);
  EXPECT_EQ(arithmetic->now_approximate(), 1.0);
  FailureTime next{std::nextafter(1.0, 2.0), std::nextafter(1.0, 2.0), 0};
  EXPECT_FALSE(arithmetic->rational_between(&qb, &next));
  const InstantText text = arithmetic->describe_now();
  EXPECT_FALSE(text.exact);
  EXPECT_EQ(text.approximate, "1");
  EXPECT_TRUE(text.polynomial.empty());
}

TEST(GslArithmetic, SurvivesAnyNumbers) {
  const char* const pool[] = {"0",      "1",      "-1",     "1e308", "-1e308", "1e-308", "1e400",
                              "-1e400", "1e-400", "5e-324", "1/3",   "1e150",  "-1e150", "1e-150",
                              "7",      "-12345", "-3",     "1e20",  "-1e-20", "2",      "-1e40"};
  std::mt19937_64 random(5);
  int fails = 0, nevers = 0;
  for (int round = 0; round < 3000; ++round) {
    const int degree = static_cast<int>(random() % 6);
    std::vector<std::vector<Coefficients>> objects(4, std::vector<Coefficients>(2));
    for (auto& axes : objects) {
      for (Coefficients& axis : axes) {
        for (int k = 0; k <= degree; ++k)
          axis.push_back(rational(pool[random() % std::size(pool)]));
      }
    }
    Scene scene = make_scene(objects, rational(pool[random() % std::size(pool)]));
    const auto arithmetic = make_arithmetic("gsl", scene);
    const Query queries[] = {Query(arithmetic->bind(make_predicate<Order>()), {0, 1}),
                             Query(arithmetic->bind(make_predicate<DistanceOrder>()), {0, 1, 2}),
                             Query(arithmetic->bind(make_predicate<Orientation>()), {0, 1, 2}),
                             Query(arithmetic->bind(make_predicate<InCircle>()), {0, 1, 2, 3})};
    set_motions(scene, *arithmetic);
    for (const Query& query : queries) {
      FailureTime time;
      const Outlook outlook = arithmetic->failure(query, time);
      EXPECT_FALSE(std::isnan(time.lo));
      EXPECT_FALSE(std::isnan(time.hi));
      arithmetic->sign_after(query);
      if (outlook != Outlook::kFails) {
        ++nevers;
        continue;
      }
      ++fails;
      EXPECT_TRUE(std::isfinite(time.lo));
      EXPECT_GT(time.lo, arithmetic->now_approximate());
      arithmetic->advance(query, time);
      arithmetic->describe_now();
    }
  }
  EXPECT_GT(fails, 100);
  EXPECT_GT(nevers, 200);
}

}  // namespace gsl_arithmetic_test
}  // namespace kinex
