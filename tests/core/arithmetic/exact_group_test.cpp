// SPDX-License-Identifier: GPL-3.0-or-later
// Groups of queries: the same answers, enclosures and counters as one by one, bit for bit, whatever
// vectors the machine has.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "core/arithmetic/exact_arithmetic.h"
#include "tests/core/arithmetic/certificate_fixture.h"
#include "tests/sanitized.h"

namespace kinex {
namespace exact_group_test {

using namespace test;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct GroupedInCircle : InCircle {
  static constexpr bool kInGroups = true;
};

std::vector<Vectors> all_vectors() {
  std::vector<Vectors> all{Vectors::kBase};
  if (best_vectors() == Vectors::kAvx2) all.push_back(Vectors::kAvx2);
  return all;
}

enum class Numbers { kRandom, kDegenerate, kExtreme, kWide };

Scene draw_scene(std::mt19937_64& random, Numbers numbers, int degree, int objects, bool plans) {
  std::vector<std::vector<Coefficients>> coordinates;
  const auto draw = [&]() -> Rational {
    const auto bits = [&](int n) {
      return Rational(Integer(static_cast<std::int64_t>(random() >> (64 - n)) -
                              (std::int64_t{1} << (n - 1))));
    };
    switch (numbers) {
      case Numbers::kRandom: return bits(20);
      case Numbers::kDegenerate: return bits(2);
      case Numbers::kExtreme: return bits(random() % 3 == 0 ? 50 : 12);
      default: return bits(60);
    }
  };
  for (int i = 0; i < objects; ++i) {
    std::vector<Coefficients> axes(2);
    for (Coefficients& axis : axes) {
      for (int k = 0; k <= degree; ++k) axis.push_back(draw());
    }
    coordinates.push_back(axes);
  }
  Scene scene = make_scene(coordinates, Rational(static_cast<int>(random() % 3) - 1));
  scene.end = Rational(4);
  if (plans) {
    for (SceneObject& object : scene.objects) {
      if (random() % 2 == 0) object.motion.pieces[0].to = Rational(2);
    }
  }
  return scene;
}

struct Run {
  explicit Run(const Scene& scene) : arithmetic(scene, needs_of_objects(scene)) {
    circle = arithmetic.bind(make_predicate<GroupedInCircle>());
    turn = arithmetic.bind(make_predicate<Orientation>());
    set_motions(scene, arithmetic);
  }
  ExactArithmetic arithmetic;
  PredicateId circle = 0, turn = 0;
};

void expect_same(const ArithmeticCounters& a, const ArithmeticCounters& b) {
  ASSERT_EQ(a.polynomials_solved, b.polynomials_solved);
  ASSERT_EQ(a.comparisons, b.comparisons);
  ASSERT_EQ(a.roots_made_exact, b.roots_made_exact);
  ASSERT_EQ(a.refinements, b.refinements);
  ASSERT_EQ(a.gcds, b.gcds);
  ASSERT_EQ(a.max_bits, b.max_bits);
  for (std::size_t p = 0; p < a.by_predicate.size(); ++p) {
    ASSERT_EQ(a.by_predicate[p].failures, b.by_predicate[p].failures);
    ASSERT_EQ(a.by_predicate[p].signs, b.by_predicate[p].signs);
    ASSERT_EQ(a.by_predicate[p].looks, b.by_predicate[p].looks);
  }
}

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }

// One group in both; then now becomes the failure time of one of its queries, at times.
void compare_group(Run& alone, Run& together, const std::vector<Query>& group, double limit,
                   std::uint64_t advance, std::array<int, 5>& outlooks) {
  std::vector<FailureTime> expected(group.size()), times(group.size());
  std::vector<Outlook> found(group.size());
  for (std::size_t i = 0; i < group.size(); ++i) {
    found[i] = limit < kInfinity ? alone.arithmetic.look_ahead(group[i], limit, expected[i])
                                 : alone.arithmetic.failure(group[i], expected[i]);
  }
  Arithmetic::GroupAnswers answers;
  ASSERT_NE(together.arithmetic.begin_group(group, limit, answers), Arithmetic::Grouped::kAnswered);
  for (std::size_t i = 0; i < group.size(); ++i) {
    const Outlook outlook = together.arithmetic.look_ahead_in_group(i, group[i], limit, times[i]);
    ASSERT_EQ(outlook, found[i]);
    ASSERT_EQ(bits(times[i].lo), bits(expected[i].lo));
    ASSERT_EQ(bits(times[i].hi), bits(expected[i].hi));
    ASSERT_EQ(times[i].root == 0, expected[i].root == 0);
    ++outlooks[static_cast<std::size_t>(outlook)];
  }
  ASSERT_EQ(alone.arithmetic.possible_zeros(), together.arithmetic.possible_zeros());
  ASSERT_NO_FATAL_FAILURE(
      expect_same(alone.arithmetic.counters(), together.arithmetic.counters()));
  const std::size_t chosen = advance % (2 * group.size());
  for (std::size_t i = 0; i < group.size(); ++i) {
    if (i == chosen && found[i] == Outlook::kFails) {
      alone.arithmetic.advance(group[i], expected[i]);
      together.arithmetic.advance(group[i], times[i]);
    } else {
      alone.arithmetic.release(expected[i]);
      together.arithmetic.release(times[i]);
    }
  }
}

void run_scenes(Numbers numbers, int degree, std::array<int, 5>& outlooks) {
  std::mt19937_64 random(static_cast<std::uint64_t>(degree) + 10 * static_cast<std::uint64_t>(numbers));
  for (int round = 0; round < test::fewer(12); ++round) {
    const Scene scene = draw_scene(random, numbers, degree, 9, round % 3 == 2);
    for (const Vectors vectors : all_vectors()) {
      Run alone(scene), together(scene);
      together.arithmetic.set_vectors(vectors);
      std::mt19937_64 draw(static_cast<std::uint64_t>(round));
      for (int i = 0; i < 60; ++i) {
        const auto object = [&] { return static_cast<ObjectId>(draw() % 9); };
        std::vector<Query> group;
        for (std::size_t size = 1 + draw() % 4; group.size() < size;) {
          const bool hull = draw() % 16 == 0;  // groups of two predicates
          std::array<ObjectId, 4> ids{};
          for (ObjectId& id : ids) id = object();
          if (hull) {
            group.push_back(Query(alone.turn, {ids[0], ids[1], ids[2]}));
          } else {
            group.push_back(Query(alone.circle, {ids[0], ids[1], ids[2], ids[3]}));
          }
        }
        const double now = alone.arithmetic.now_approximate();
        const double window = std::ldexp(1.0, static_cast<int>(draw() % 12) - 9);
        const double limit = draw() % 4 == 0 ? kInfinity : now + window;
        compare_group(alone, together, group, limit, draw(), outlooks);
        if (testing::Test::HasFatalFailure()) return;
        if (i % 8 == 7) {
          const Rational t(static_cast<int>(draw() % 5) - 1);
          alone.arithmetic.set_now(t);
          together.arithmetic.set_now(t);
        }
        if (i == 40) {  // a motion that the scene does not cover
          Trajectory motion = scene.objects[0].motion.pieces[0].trajectory;
          motion.coordinates[0][0] = Rational(Integer(1), Integer(3));
          alone.arithmetic.set_motion(0, motion, std::nullopt);
          together.arithmetic.set_motion(0, motion, std::nullopt);
        }
      }
    }
  }
}

TEST(ExactGroups, AreTheSameAsOneByOne) {
  std::array<int, 5> outlooks{};
  for (const Numbers numbers :
       {Numbers::kRandom, Numbers::kDegenerate, Numbers::kExtreme, Numbers::kWide}) {
    for (int degree = 1; degree <= 3; ++degree) {
      run_scenes(numbers, degree, outlooks);
      if (HasFatalFailure()) FAIL() << static_cast<int>(numbers) << ", degree " << degree;
    }
  }
  // All outlooks have occurred.
  for (const int count : outlooks) EXPECT_GT(count, test::seen_in_fewer(20));
}

TEST(ExactGroups, PolynomialsAreThoseOfOneQuery) {
  std::mt19937_64 random(3);
  const auto predicate = make_predicate<GroupedInCircle>();
  for (int round = 0; round < 3000; ++round) {
    const int degree = 1 + static_cast<int>(random() % 3);
    const std::size_t numbers = 2 * static_cast<std::size_t>(degree + 1);
    std::array<std::array<double, 8>, 4 * kLanes> motions;
    std::array<MotionView<double>, 4 * kLanes> points;
    for (std::size_t i = 0; i < motions.size(); ++i) {
      for (std::size_t k = 0; k < numbers; ++k) {
        const double whole = static_cast<double>(random() >> 44) - 0x1p19;
        motions[i][k] = random() % 8 == 0 ? 0 : whole;
      }
      points[i] = motions[i].data();
    }
    const double shift = random() % 4 == 0 ? 0 : static_cast<double>(random() % 4096) / 1024;
    for (const Vectors vectors : all_vectors()) {
      Lanes out[13], reach[4];
      ASSERT_TRUE(predicate->plain_lanes(degree, points.data(), shift, vectors, out, reach));
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        std::array<MotionView<double>, 5> one{};
        for (std::size_t i = 0; i < 4; ++i) one[i] = points[i * kLanes + lane];
        double c[13], r[4];
        predicate->plain_with_reach(degree, one.data(), shift, c, r);
        for (std::size_t k = 0; k < 4 * static_cast<std::size_t>(degree) + 1; ++k) {
          ASSERT_EQ(bits(c[k]), bits(out[k][lane]));
        }
        for (std::size_t k = 0; k <= static_cast<std::size_t>(degree); ++k) {
          ASSERT_EQ(bits(r[k]), bits(reach[k][lane]));
        }
      }
    }
  }
  // Formulas that do not ask for it have no such form.
  const auto other = make_predicate<InCircle>();
  EXPECT_FALSE(other->plain_lanes(1, nullptr, 0, Vectors::kBase, nullptr, nullptr));
}

}  // namespace exact_group_test
}  // namespace kinex
