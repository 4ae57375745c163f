// SPDX-License-Identifier: GPL-3.0-or-later
// Powers of moving points with moving weights: exact against the reference arithmetic; discs against
// points whose weights are the squares of the radii.
#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/arithmetic/arithmetic.h"
#include "predicates/points/power_predicates.h"

namespace kinex {
namespace power_test {

constexpr ObjectId kPoints = 6;

// Numbers of a scene: small integers with ties, large ones, fractions without a common denominator,
// weights far larger than squares of distances.
enum class Numbers { kSmall, kLarge, kFractions, kHeavy };

Scene scene_of(std::uint64_t seed, Numbers numbers, int degree, int weight_degree, Extents extents) {
  std::mt19937_64 engine(seed);
  const auto number = [&](std::uint64_t most) {
    return Rational(static_cast<std::int64_t>(engine() % (2 * most + 1)) -
                    static_cast<std::int64_t>(most));
  };
  const auto coefficient = [&](bool weight) {
    switch (numbers) {
      case Numbers::kSmall: return number(2);
      case Numbers::kLarge: return number(weight ? 1 << 22 : 1 << 11);
      case Numbers::kFractions: return number(999) / Rational(1 + static_cast<int>(engine() % 9973));
      default: return number(weight ? 1 << 30 : 3);
    }
  };
  Scene scene;
  scene.dimension = 2;
  scene.extents = extents;
  scene.start = Rational(static_cast<int>(engine() % 3) - 1);
  for (ObjectId i = 0; i < kPoints; ++i) {
    Trajectory motion;
    for (int axis = 0; axis < 3; ++axis) {
      auto& c = motion.coordinates.emplace_back();
      for (int k = 0; k <= (axis == 2 ? weight_degree : degree); ++k) c.push_back(coefficient(axis == 2));
    }
    motion.normalise();
    scene.objects.push_back({std::to_string(i), {{{std::nullopt, std::nullopt, std::move(motion)}}}});
  }
  return scene;
}

std::unique_ptr<Arithmetic> arithmetic_of(const char* name, const Scene& scene) {
  NumberNeeds needs = needs_of_objects(scene);
  if (scene.extents == Extents::kWeight) needs.add_weights(scene);
  auto arithmetic = make_arithmetic(name, scene, needs);
  for (ObjectId i = 0; i < kPoints; ++i) {
    arithmetic->set_motion(i, scene.objects[i].motion.pieces[0].trajectory, {});
  }
  arithmetic->set_now(scene.start);
  return arithmetic;
}

TEST(Power, ExactAgreesWithTheReference) {
  int fails = 0, zero = 0;
  for (const Numbers numbers : {Numbers::kSmall, Numbers::kLarge, Numbers::kFractions, Numbers::kHeavy}) {
    for (const auto& [degree, weight_degree] : {std::pair(1, 0), {1, 1}, {1, 2}, {1, 4}, {2, 1}, {3, 3}}) {
      for (std::uint64_t seed = 0; seed < 4; ++seed) {
        const Scene scene = scene_of(seed, numbers, degree, weight_degree, Extents::kWeight);
        const auto exact = arithmetic_of("exact", scene), sturm = arithmetic_of("sturm", scene);
        const PredicateId here = exact->bind(make_power_2()), there = sturm->bind(make_power_2());
        for (ObjectId a = 0; a < 3; ++a) {
          const Query query(here, {a, a + 1, a + 2, a + 3}), other(there, {a, a + 1, a + 2, a + 3});
          ASSERT_EQ(exact->sign_after(query), sturm->sign_after(other));
          FailureTime time, wanted;
          const Outlook outlook = exact->failure(query, time);
          ASSERT_EQ(outlook, sturm->failure(other, wanted)) << seed << " " << degree << weight_degree;
          zero += outlook == Outlook::kIdenticallyZero ? 1 : 0;
          if (outlook != Outlook::kFails) continue;
          ++fails;
          ASSERT_LE(time.lo, wanted.hi);
          ASSERT_LE(wanted.lo, time.hi);
        }
      }
    }
  }
  EXPECT_GT(fails, 50);
  EXPECT_LT(zero, fails);
}

TEST(Power, DiscsHaveTheSquaresOfTheirRadii) {
  int fails = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Scene discs = scene_of(seed, Numbers::kSmall, 1, 1, Extents::kRadius);
    Scene points = discs;
    points.extents = Extents::kWeight;
    for (SceneObject& object : points.objects) {
      auto& c = object.motion.pieces[0].trajectory.coordinates[2];
      c.resize(2);
      c = {c[0] * c[0], Rational(2) * c[0] * c[1], c[1] * c[1]};
      object.motion.pieces[0].trajectory.normalise();
    }
    const auto one = arithmetic_of("exact", discs), two = arithmetic_of("exact", points);
    const PredicateId here = one->bind(make_disc_power_2()), there = two->bind(make_power_2());
    for (ObjectId a = 0; a < 3; ++a) {
      const Query query(here, {a, a + 1, a + 2, a + 3}), other(there, {a, a + 1, a + 2, a + 3});
      FailureTime time, same;
      const Outlook outlook = one->failure(query, time);
      ASSERT_EQ(one->sign_after(query), two->sign_after(other));
      ASSERT_EQ(outlook, two->failure(other, same));
      fails += outlook == Outlook::kFails ? 1 : 0;
    }
  }
  EXPECT_GT(fails, 10);
}

}  // namespace power_test
}  // namespace kinex
