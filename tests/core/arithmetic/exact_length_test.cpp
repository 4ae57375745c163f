// SPDX-License-Identifier: GPL-3.0-or-later
// Orders of two lengths have a path of their own to signs and failure times: its answers, enclosures and
// counters are bit for bit those of the same formula that is not known as such, for random, degenerate,
// extreme and wide motions.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <tuple>

#include "core/arithmetic/exact_arithmetic.h"
#include "tests/core/arithmetic/length_fixture.h"

namespace kinex {
namespace exact_length_test {

using namespace test;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::array<bool, 2> kShapes{true, false};  // with an end in common, and without

struct Side {
  Side(const Scene& scene, bool known) : arithmetic(scene, needs_of_objects(scene)) {
    for (const bool shared : kShapes) {
      arithmetic.bind(make_lengths(scene.dimension, shared, known, formulas));
    }
    set_motions(scene, arithmetic);
  }
  int formulas = 0;  // evaluated by the general path
  ExactArithmetic arithmetic;
};

struct Seen {
  std::array<int, 5> outlooks{};
  std::array<int, 3> signs{};
  int instants = 0;
};

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }

void expect_same_counters(const Arithmetic& a, const Arithmetic& b) {
  ASSERT_EQ(a.possible_zeros(), b.possible_zeros());
  ASSERT_EQ(a.counters().polynomials_solved, b.counters().polynomials_solved);
  ASSERT_EQ(a.counters().roots_made_exact, b.counters().roots_made_exact);
  for (std::size_t i = 0; i < kShapes.size(); ++i) {
    ASSERT_EQ(a.counters().by_predicate[i].signs, b.counters().by_predicate[i].signs);
    ASSERT_EQ(a.counters().by_predicate[i].failures, b.counters().by_predicate[i].failures);
    ASSERT_EQ(a.counters().by_predicate[i].looks, b.counters().by_predicate[i].looks);
  }
}

Query draw_query(std::mt19937_64& random) {
  const auto point = [&random] { return static_cast<ObjectId>(random() % kPoints); };
  if (random() % 2 == 0) return Query(0, {point(), point(), point()});
  const ObjectId a = point();
  return Query(1, {a, point(), random() % 4 == 0 ? a : point(), point()});
}

// The query with the negated value.
Query opposite(const Query& q) {
  if (q.predicate == 0) return Query(0, {q.ids[1], q.ids[0], q.ids[2]});
  return Query(1, {q.ids[2], q.ids[3], q.ids[0], q.ids[1]});
}

void expect_same(const FailureTime& at, const FailureTime& expected) {
  ASSERT_EQ(bits(at.lo), bits(expected.lo));
  ASSERT_EQ(bits(at.hi), bits(expected.hi));
  ASSERT_EQ(at.root == 0, expected.root == 0);
}

// A motion that the model of the scene's numbers does not cover, at times of a higher degree.
void renew_motion(Side& known, Side& plain, const Scene& scene, std::mt19937_64& random) {
  const auto object = static_cast<ObjectId>(random() % kPoints);
  Trajectory trajectory = scene.objects[object].motion.pieces[0].trajectory;
  for (auto& axis : trajectory.coordinates) {
    for (Rational& c : axis)
      c += draw(random, Numbers::kWide) / Rational(Integer::power_of_two(40));
    if (random() % 4 == 0) axis.push_back(Rational(1));
  }
  for (Side* side : {&known, &plain}) side->arithmetic.set_motion(object, trajectory, std::nullopt);
}

// One query in both, and what it shows of now. True: it fails later, and now has become that instant.
bool compare_query(Side& known, Side& plain, const Query& query, double limit, bool advances,
                   Seen& seen) {
  const Sign sign = known.arithmetic.sign_after(query);
  FailureTime at;
  const Outlook outlook = known.arithmetic.look_ahead(query, limit, at);
  EXPECT_EQ(plain.arithmetic.sign_after(query), sign);
  FailureTime expected;
  EXPECT_EQ(plain.arithmetic.look_ahead(query, limit, expected), outlook);
  expect_same(at, expected);
  if (outlook == Outlook::kLater) {
    FailureTime further, expected_further;
    EXPECT_EQ(known.arithmetic.look_further(query, limit, kInfinity, further),
              plain.arithmetic.look_further(query, limit, kInfinity, expected_further));
    expect_same(further, expected_further);
    known.arithmetic.release(further);
    plain.arithmetic.release(expected_further);
  }
  ++seen.outlooks[static_cast<std::size_t>(outlook)];
  ++seen.signs[static_cast<std::size_t>(to_int(sign) + 1)];
  if (outlook == Outlook::kFails && advances) {
    ++seen.instants;
    known.arithmetic.advance(query, at);
    plain.arithmetic.advance(query, expected);
    return true;
  }
  known.arithmetic.release(at);
  plain.arithmetic.release(expected);
  return false;
}

// Random queries, now and after instants of some of them; there of the query that fails, too, and of its
// opposite.
void compare_runs(std::mt19937_64& random, const Scene& scene, Seen& seen) {
  Side known(scene, true), plain(scene, false);
  Query query;
  bool advanced = false;
  for (int step = 0; step < 16; ++step) {
    if (!advanced || random() % 8 == 0) {
      query = draw_query(random);
    } else if (random() % 4 != 0) {
      query = opposite(query);
    }
    const double ahead = std::ldexp(1.0, static_cast<int>(random() % 12) - 8);
    const double limit = random() % 2 == 0 ? kInfinity : known.arithmetic.now_approximate() + ahead;
    if (random() % 64 == 0) renew_motion(known, plain, scene, random);
    advanced = compare_query(known, plain, query, limit, random() % 4 != 0, seen);
    expect_same_counters(known.arithmetic, plain.arithmetic);
    if (::testing::Test::HasFailure()) return;
  }
}

class ExactLength : public ::testing::TestWithParam<std::tuple<int, int>> {};

TEST_P(ExactLength, IsTheFormula) {
  const auto [degree, dimension] = GetParam();
  std::mt19937_64 random(static_cast<std::uint64_t>(10 * degree + dimension));
  Seen seen;
  for (int round = 0; round < 140; ++round) {
    const auto numbers = static_cast<Numbers>(round % kNumbers);
    compare_runs(random, draw_points(random, numbers, degree, dimension), seen);
    if (HasFailure()) FAIL() << "round " << round;
  }
  for (const int count : seen.outlooks) EXPECT_GT(count, 20);
  for (const int count : seen.signs) EXPECT_GT(count, 50);
  EXPECT_GT(seen.instants, 80);
}

// An arithmetic without a filter agrees on the signs.
TEST_P(ExactLength, HasTheExactSign) {
  const auto [degree, dimension] = GetParam();
  std::mt19937_64 random(static_cast<std::uint64_t>(10 * degree + dimension));
  std::array<int, 3> seen{};
  for (int round = 0; round < 42; ++round) {
    const Scene scene = draw_points(random, static_cast<Numbers>(round % 3), degree, dimension);
    Side known(scene, true);
    const auto sturm = make_arithmetic("sturm", scene);
    int formulas = 0;
    for (const bool shared : kShapes) sturm->bind(make_lengths(dimension, shared, false, formulas));
    set_motions(scene, *sturm);
    for (int i = 0; i < 8; ++i) {
      const Query query = draw_query(random);
      const Sign sign = known.arithmetic.sign_after(query);
      ASSERT_EQ(sign, sturm->sign_after(query)) << "round " << round;
      ++seen[static_cast<std::size_t>(to_int(sign) + 1)];
    }
  }
  for (const int count : seen) EXPECT_GT(count, 20);
}

// It answers nearly all that is not degenerate, and calls no formula.
TEST_P(ExactLength, NeedsNoFormula) {
  const auto [degree, dimension] = GetParam();
  std::mt19937_64 random(static_cast<std::uint64_t>(10 * degree + dimension));
  Seen seen;
  int by_known = 0, by_plain = 0;
  for (int round = 0; round < 20; ++round) {
    std::vector<std::vector<Coefficients>> points;
    for (int i = 0; i < kPoints; ++i) {
      points.emplace_back();
      for (int axis = 0; axis < dimension; ++axis) {
        points.back().emplace_back();
        for (int k = 0; k <= degree; ++k)
          points.back().back().push_back(draw(random, Numbers::kRandom));
      }
    }
    Scene scene = make_scene(points, rational("1/3"));
    scene.end = Rational(6);
    Side known(scene, true), plain(scene, false);
    for (const Query& query :
         {Query(0, {0, 1, 2}), Query(1, {2, 3, 4, 5}), Query(1, {4, 5, 4, 6})}) {
      const Query positive =
          known.arithmetic.sign_after(query) == Sign::kPositive ? query : opposite(query);
      plain.arithmetic.sign_after(query);
      compare_query(known, plain, positive, kInfinity, true, seen);
      compare_query(known, plain, opposite(positive), kInfinity, false, seen);
      expect_same_counters(known.arithmetic, plain.arithmetic);
    }
    by_known += known.formulas;
    by_plain += plain.formulas;
  }
  EXPECT_GT(by_plain, 200);
  EXPECT_LT(by_known, by_plain / 5);
}

INSTANTIATE_TEST_SUITE_P(All, ExactLength,
                         ::testing::Combine(::testing::Values(1, 2, 3), ::testing::Values(1, 2, 3)),
                         [](const auto& cell) {
                           return "degree" + std::to_string(std::get<0>(cell.param)) + "axes" +
                                  std::to_string(std::get<1>(cell.param));
                         });

}  // namespace exact_length_test
}  // namespace kinex
