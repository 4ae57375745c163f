// SPDX-License-Identifier: GPL-3.0-or-later
// Differences of coordinates in groups: the same answers, enclosures and counters as one by one, bit for
// bit, whatever vectors the machine has. (exact_difference_test.cpp holds the latter to the plain formula.)
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <random>
#include <vector>

#include "core/arithmetic/exact_arithmetic.h"
#include "tests/core/arithmetic/difference_fixture.h"
#include "tests/sanitized.h"

namespace kinex {
namespace exact_difference_group_test {

using namespace test;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Run {
  Run(const Scene& scene, bool anchored) : arithmetic(scene, needs(scene, anchored)) {
    difference = arithmetic.bind(std::make_shared<KnownDifference>());
    set_motions(scene, arithmetic);
  }
  static NumberNeeds needs(const Scene& scene, bool anchored) {
    NumberNeeds result = needs_of_objects(scene);
    result.anchored = anchored;
    return result;
  }
  ExactArithmetic arithmetic;
  PredicateId difference = 0;
};

struct Seen {
  std::array<int, 5> outlooks{};
  int answered = 0, not_answered = 0;
  int exchanges = 0;  // answered groups of an exchange
};

void expect_same_counters(const Arithmetic& a, const Arithmetic& b) {
  ASSERT_EQ(a.possible_zeros(), b.possible_zeros());
  ASSERT_EQ(a.counters().polynomials_solved, b.counters().polynomials_solved);
  ASSERT_EQ(a.counters().roots_made_exact, b.counters().roots_made_exact);
  ASSERT_EQ(a.counters().by_predicate[0].failures, b.counters().by_predicate[0].failures);
}

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }

// One group in both; then now becomes the failure time of one of its queries, at times. True: of the first.
bool compare_group(Run& alone, Run& together, const std::vector<Query>& group, double limit,
                   std::size_t chosen, Seen& seen) {
  std::vector<FailureTime> expected(group.size()), times(group.size());
  std::vector<Outlook> outlooks(group.size());
  Arithmetic::GroupAnswers answers;
  const auto grouped = together.arithmetic.begin_group(group, limit, answers);
  EXPECT_NE(grouped, Arithmetic::Grouped::kPrepared);
  ++(grouped == Arithmetic::Grouped::kAnswered ? seen.answered : seen.not_answered);
  bool advanced = false;
  for (std::size_t i = 0; i < group.size(); ++i) {
    outlooks[i] = alone.arithmetic.look_ahead(group[i], limit, expected[i]);
    if (grouped == Arithmetic::Grouped::kAnswered) {
      times[i] = answers.times[i];
    } else {
      answers.outlooks[i] = together.arithmetic.look_ahead(group[i], limit, times[i]);
    }
    EXPECT_EQ(answers.outlooks[i], outlooks[i]) << i;
    EXPECT_EQ(bits(times[i].lo), bits(expected[i].lo)) << i;
    EXPECT_EQ(bits(times[i].hi), bits(expected[i].hi)) << i;
    EXPECT_EQ(times[i].root == 0, expected[i].root == 0) << i;
    ++seen.outlooks[static_cast<std::size_t>(outlooks[i])];
  }
  expect_same_counters(alone.arithmetic, together.arithmetic);
  for (std::size_t i = 0; i < group.size(); ++i) {
    if (i == chosen && outlooks[i] == Outlook::kFails) {
      alone.arithmetic.advance(group[i], expected[i]);
      together.arithmetic.advance(group[i], times[i]);
      advanced = i == 0;
    } else {
      alone.arithmetic.release(expected[i]);
      together.arithmetic.release(times[i]);
    }
  }
  return advanced;
}

// In the order right after now, as in a list.
void sort(Run& alone, Run& together, std::array<ObjectId, 4>& row) {
  for (std::size_t end = row.size(); end > 1; --end) {
    for (std::size_t i = 0; i + 1 < end; ++i) {
      const Query query(alone.difference, {row[i], row[i + 1]});
      const Sign sign = alone.arithmetic.sign_after(query);
      EXPECT_EQ(together.arithmetic.sign_after(query), sign);
      if (sign == Sign::kNegative) std::swap(row[i], row[i + 1]);
    }
  }
}

// A motion that the model of the scene's numbers does not cover, with an anchor of its own.
void renew_motion(Run& alone, Run& together, const Scene& scene, std::mt19937_64& random) {
  const auto object = static_cast<ObjectId>(random() % scene.objects.size());
  Trajectory trajectory = scene.objects[object].motion.pieces[0].trajectory;
  for (Rational& c : trajectory.coordinates[0]) c += draw(random, Numbers::kWide) / Rational(Integer::power_of_two(40));
  for (Run* run : {&alone, &together}) run->arithmetic.set_motion(object, trajectory, std::nullopt);
}

// Groups as a list asks for them, z a b y -> z b a y, and others.
void compare_runs(const Scene& scene, bool anchored, Vectors vectors, std::uint64_t seed, Seen& seen) {
  Run alone(scene, anchored), together(scene, anchored);
  together.arithmetic.set_vectors(vectors);
  std::mt19937_64 random(seed);
  std::array<ObjectId, 4> row{0, 1, 2, 3};
  bool exchanged = false;
  for (int step = 0; step < 24; ++step) {
    if (exchanged) {
      std::swap(row[1], row[2]);
    } else {
      row = {0, 1, 2, 3};
      for (ObjectId& object : row) std::swap(object, row[random() % 4]);
      for (ObjectId& object : row) {
        object = (object + static_cast<ObjectId>(step)) % static_cast<ObjectId>(scene.objects.size());
      }
      if (random() % 4 != 0) sort(alone, together, row);
    }
    std::vector<Query> group;
    for (const std::size_t i : {1, 0, 2}) {
      group.emplace_back(together.difference, std::initializer_list<ObjectId>{row[i], row[i + 1]});
    }
    if (random() % 4 == 0) group.pop_back();
    if (random() % 8 == 0) {
      group.emplace_back(together.difference, std::initializer_list<ObjectId>{row[3], row[0]});
    }
    if (random() % 8 == 0) std::swap(group.front(), group.back());
    const double ahead = std::ldexp(1.0, static_cast<int>(random() % 12) - 8);
    const double limit = random() % 2 == 0 ? kInfinity : alone.arithmetic.now_approximate() + ahead;
    if (random() % 32 == 0) renew_motion(alone, together, scene, random);
    const int answered = seen.answered;
    const bool repairs = exchanged;
    exchanged = compare_group(alone, together, group, limit, random() % 4, seen);
    exchanged = exchanged && group[0] == Query(together.difference, {row[1], row[2]});
    if (repairs) seen.exchanges += seen.answered - answered;
    if (::testing::Test::HasFailure()) return;
  }
}

class ExactDifferenceGroup : public ::testing::TestWithParam<int> {};

TEST_P(ExactDifferenceGroup, IsOneByOne) {
  std::mt19937_64 random(static_cast<std::uint64_t>(GetParam()));
  Seen seen;
  for (int round = 0; round < test::fewer(700); ++round) {
    const auto numbers = static_cast<Numbers>(round % kNumbers);
    const Scene scene = draw_scene(random, numbers, GetParam());
    const std::uint64_t seed = random();
    for (const Vectors vectors : {Vectors::kBase, Vectors::kAvx2}) {
      if (vectors == Vectors::kAvx2 && best_vectors() != Vectors::kAvx2) continue;
      compare_runs(scene, round % 5 == 4, vectors, seed, seen);
      if (HasFailure()) FAIL() << "round " << round;
    }
  }
  for (const Outlook outlook : {Outlook::kNever, Outlook::kFails, Outlook::kFailsNow, Outlook::kIdenticallyZero}) {
    EXPECT_GT(seen.outlooks[static_cast<std::size_t>(outlook)], test::seen_in_fewer(200));
  }
  // Failure times of degree 1 take no windows.
  if (GetParam() > 1) {
    EXPECT_GT(seen.outlooks[static_cast<std::size_t>(Outlook::kLater)], test::seen_in_fewer(200));
  }
  EXPECT_GT(seen.answered, test::seen_in_fewer(3000));
  EXPECT_GT(seen.not_answered, test::seen_in_fewer(1000));
  EXPECT_GT(seen.exchanges, test::seen_in_fewer(100));
}

INSTANTIATE_TEST_SUITE_P(All, ExactDifferenceGroup, ::testing::Values(1, 2, 3),
                         ::testing::PrintToStringParamName());

}  // namespace exact_difference_group_test
}  // namespace kinex
