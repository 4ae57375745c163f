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

#include "core/arithmetic/coordinate_difference.h"
#include "core/arithmetic/exact_arithmetic.h"
#include "tests/core/arithmetic/certificate_fixture.h"

namespace kinex {
namespace exact_difference_test {

using namespace test;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

class Difference final : public FormulaPredicate<Order>, public CoordinateDifference {
 public:
  int difference_axis() const override { return 0; }
};

enum class Numbers { kDegenerate, kRandom, kExtreme, kWide, kDoubles, kMixed };

// Of few bits, so that roots coincide, are double, or are now; of up to 60; or 53 at very different sizes.
Rational draw(std::mt19937_64& random, Numbers numbers) {
  const auto bits = [&](unsigned n) {
    return Rational(Integer(static_cast<std::int64_t>(random() >> (64 - n)) - (std::int64_t{1} << (n - 1))));
  };
  switch (numbers) {
    case Numbers::kDegenerate: return bits(3);
    case Numbers::kRandom: return bits(20);
    case Numbers::kExtreme: return bits(random() % 3 == 0 ? 44 : 8);
    case Numbers::kDoubles: {
      const Rational size(Integer::power_of_two(random() % 90));
      return bits(54) * size / Rational(Integer::power_of_two(80));
    }
    case Numbers::kMixed: return random() % 2 == 0 ? bits(60) : bits(3);
    default: return bits(60);
  }
}

Scene draw_scene(std::mt19937_64& random, Numbers numbers, int degree) {
  constexpr int kObjects = 6;
  std::vector<std::vector<Coefficients>> coordinates;
  for (int i = 0; i < kObjects; ++i) {
    Coefficients c;
    for (int k = 0; k <= degree; ++k) c.push_back(draw(random, numbers));
    coordinates.push_back({c});
  }
  if (random() % 2 == 0) coordinates[1][0][static_cast<std::size_t>(degree)] = coordinates[0][0].back();
  if (random() % 4 == 0) coordinates[3] = coordinates[2];
  // Differences below the rounding of their terms.
  if (random() % 2 == 0) {
    coordinates[5] = coordinates[2];
    for (Rational& c : coordinates[5][0]) c += Rational(static_cast<int>(random() % 3) - 1);
  }
  Scene scene = make_scene(coordinates, Rational(static_cast<int>(random() % 5) - 2) / Rational(3));
  scene.end = Rational(6);
  if (random() % 3 == 0) scene.objects[4].motion.pieces[0].to = Rational(2);
  return scene;
}

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
  const PredicateId known = arithmetic.bind(std::make_shared<Difference>());
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
  for (int round = 0; round < 360; ++round) {
    const auto numbers = static_cast<Numbers>(round % 6);
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
