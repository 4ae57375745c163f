// SPDX-License-Identifier: GPL-3.0-or-later
// Differences of coordinates have a path of their own to failure times: its answers are those of the same
// formula that is not known as a difference, for random, degenerate, extreme and wide motions.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include "core/arithmetic/exact_arithmetic.h"
#include "tests/core/arithmetic/difference_fixture.h"

namespace kinex {
namespace exact_difference_test {

using namespace test;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A failure beyond the horizon may be told, or not.
Outlook up_to(double horizon, Outlook outlook, const FailureTime& time) {
  return outlook == Outlook::kFails && time.lo > horizon ? Outlook::kNever : outlook;
}

struct Seen {
  std::array<int, 5> outlooks{};
  int instants = 0;
};

// Both formulas of random pairs, now and after instants of either.
void compare_paths(std::mt19937_64& random, const Scene& scene, Seen& seen) {
  ExactArithmetic arithmetic(scene, needs_of_objects(scene));
  const PredicateId known = arithmetic.bind(std::make_shared<KnownDifference>());
  const PredicateId plain = arithmetic.bind(make_predicate<Order>());
  set_motions(scene, arithmetic);
  for (int step = 0; step < 24; ++step) {
    const auto a = static_cast<ObjectId>(random() % scene.objects.size());
    const auto b = static_cast<ObjectId>((a + 1 + random() % (scene.objects.size() - 1)) % scene.objects.size());
    const double ahead = arithmetic.now_approximate() + std::ldexp(1.0, static_cast<int>(random() % 12) - 8);
    const double limit = random() % 2 == 0 ? kInfinity : ahead;
    const Query fast(known, {a, b}), slow(plain, {a, b});
    const bool ends = (a == 4 || b == 4) && scene.objects[4].motion.pieces[0].to;
    const double horizon = ends ? 2 : 6;
    FailureTime at, other;
    const Outlook outlook = arithmetic.look_ahead(fast, limit, at);
    const Outlook expected = arithmetic.look_ahead(slow, limit, other);
    // A failure beyond the limit may be told, or not.
    const bool either = limit < kInfinity && (outlook == Outlook::kLater || expected == Outlook::kLater);
    if (!either) {
      ASSERT_EQ(up_to(horizon, outlook, at), up_to(horizon, expected, other)) << "step " << step;
    }
    ++seen.outlooks[static_cast<std::size_t>(outlook)];
    if (outlook == Outlook::kFails && expected == Outlook::kFails) {
      ASSERT_EQ(arithmetic.compare(fast, at, slow, other), 0) << "step " << step;
      ++seen.instants;
      if (random() % 4 == 0) {
        arithmetic.advance(slow, other);
      } else if (random() % 2 == 0) {
        arithmetic.advance(fast, at);
      }
    }
    arithmetic.release(at);
    arithmetic.release(other);
  }
}

class ExactDifference : public ::testing::TestWithParam<int> {};

TEST_P(ExactDifference, IsTheFormula) {
  std::mt19937_64 random(static_cast<std::uint64_t>(GetParam()));
  Seen seen;
  for (int round = 0; round < 420; ++round) {
    const auto numbers = static_cast<Numbers>(round % kNumbers);
    const Scene scene = draw_scene(random, numbers, GetParam());
    compare_paths(random, scene, seen);
    if (HasFatalFailure()) FAIL() << "round " << round;
  }
  for (const Outlook outlook : {Outlook::kNever, Outlook::kFails, Outlook::kFailsNow, Outlook::kIdenticallyZero}) {
    EXPECT_GT(seen.outlooks[static_cast<std::size_t>(outlook)], 20);
  }
  // Failure times of degree 1 take no windows.
  if (GetParam() > 1) {
    EXPECT_GT(seen.outlooks[static_cast<std::size_t>(Outlook::kLater)], 20);
  }
  EXPECT_GT(seen.instants, 300);
}

INSTANTIATE_TEST_SUITE_P(All, ExactDifference, ::testing::Values(1, 2, 3), ::testing::PrintToStringParamName());

}  // namespace exact_difference_test
}  // namespace kinex
