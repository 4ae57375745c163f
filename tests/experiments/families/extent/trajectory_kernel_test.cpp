// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/extent/trajectory_kernel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/structures/test_scenes.h"

namespace kinex::families {
namespace trajectory_kernel_test {

using test::path;
using test::Random;
using test::scene_of;

Rational squared_diameter(const Scene& scene, const std::vector<ObjectId>& objects,
                          const Rational& t) {
  Rational best;
  for (const ObjectId a : objects) {
    for (const ObjectId b : objects) {
      Rational sum;
      for (int axis = 0; axis < 2; ++axis) {
        const Rational d = scene.objects[b].motion.pieces[0].trajectory.position(axis, t) -
                           scene.objects[a].motion.pieces[0].trajectory.position(axis, t);
        sum += d * d;
      }
      best = std::max(best, sum);
    }
  }
  return best;
}

std::vector<ObjectId> all_of(const Scene& scene) {
  std::vector<ObjectId> all;
  for (ObjectId id = 0; id < scene.objects.size(); ++id) all.push_back(id);
  return all;
}

// At times near and far, before and after the start.
void expect_guarantee(const Scene& scene, const Rational& error, std::size_t most) {
  ASSERT_EQ(kernel_refusal(scene), "");
  const TrajectoryKernel kernel = trajectory_kernel(scene, error);
  EXPECT_LE(kernel.objects.size(), most);
  EXPECT_TRUE(std::is_sorted(kernel.objects.begin(), kernel.objects.end()));
  const Rational least = (Rational(1) - error) * (Rational(1) - error);
  for (int i = -40; i <= 40; i += 5) {
    const Rational t = Rational(i * i * i) / Rational(i % 2 == 0 ? 640 : 641);
    const Rational all = squared_diameter(scene, all_of(scene), t);
    EXPECT_GE(squared_diameter(scene, kernel.objects, t), least * all) << t.to_string();
  }
}

Scene random_lines(std::uint64_t seed, int n, int size) {
  Random random(seed);
  std::vector<Trajectory> t;
  for (int i = 0; i < n; ++i) t.push_back(random.small_path(2, 1, size));
  return scene_of(t, 0, Rational(9));
}

TEST(TrajectoryKernel, HasTheDiameterAtAllTimes) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    for (const char* error : {"1/2", "1/10", "1/50", "9/10"}) {
      SCOPED_TRACE(std::string(error) + ", seed " + std::to_string(seed));
      expect_guarantee(random_lines(seed, 30, 1000), *Rational::parse(error), 30);
      expect_guarantee(random_lines(seed, 12, 2), *Rational::parse(error), 12);
    }
  }
}

// On a circle all are needed for the exact diameter, in every direction of motion, too.
TEST(TrajectoryKernel, LeavesFewPointsOfACircle) {
  std::vector<Trajectory> t;
  for (int i = 0; i < 100; ++i) {
    const Rational q = Rational(i - 50) / Rational(25);
    const Rational all = Rational(1) + q * q;
    const Rational x = (Rational(1) - q * q) / all, y = Rational(2) * q / all;
    t.push_back(path({{x, y}, {y, x}}));
  }
  const Scene scene = scene_of(t, 0, Rational(1));
  expect_guarantee(scene, Rational(1) / Rational(2), 30);
  expect_guarantee(scene, Rational(1) / Rational(10), 80);
  EXPECT_LT(trajectory_kernel(scene, Rational(1) / Rational(2)).objects.size(),
            trajectory_kernel(scene, Rational(1) / Rational(50)).objects.size());
}

TEST(TrajectoryKernel, DegenerateScenes) {
  const Rational error = Rational(1) / Rational(10);
  // No point, one, all equal, all at rest, identically on a line, all through one point.
  Scene none = scene_of({}, 0, Rational(1));
  none.dimension = 2;
  EXPECT_EQ(trajectory_kernel(none, error).objects.size(), 0u);
  expect_guarantee(scene_of({path({{3, 1}, {0}})}, 0, Rational(1)), error, 1);
  expect_guarantee(scene_of(std::vector<Trajectory>(6, path({{3, 1}, {2}})), 0, Rational(1)), error,
                   1);
  std::vector<Trajectory> rest, line, pencil;
  for (int i = 0; i < 9; ++i) {
    rest.push_back(path({{(i * 4) % 9}, {(i * 7) % 9}}));
    line.push_back(path({{i, i}, {2 * i, 2 * i}}));
    pencil.push_back(path({{0, i - 4}, {0, (i * 5) % 9 - 4}}));
  }
  expect_guarantee(scene_of(rest, 0, Rational(1)), error, 9);
  expect_guarantee(scene_of(line, 0, Rational(1)), error, 2);
  expect_guarantee(scene_of(pencil, 0, Rational(1)), error, 9);
}

TEST(TrajectoryKernel, RefusesOtherScenes) {
  EXPECT_NE(kernel_refusal(scene_of({path({{0}})}, 0, Rational(1))), "");
  EXPECT_NE(kernel_refusal(scene_of({path({{0, 1, 1}, {0}})}, 0, Rational(1))), "");
  EXPECT_NE(kernel_refusal(test::random_flights(1, 9, 2, 1, true)), "");
}

TEST(TrajectoryKernel, KeepsWhatKeysReferTo) {
  Scene scene = random_lines(3, 20, 9);
  Key key;
  key.kind = Key::Kind::kSquaredDistance;
  key.object = 7;
  scene.maintain = {{"maximum_tournament", "far", key}};
  const Scene thin = only_objects(scene, {2, 11, 12});
  ASSERT_EQ(thin.objects.size(), 4u);
  EXPECT_EQ(thin.objects[1].id, scene.objects[7].id);
  EXPECT_EQ(thin.maintain[0].key.object, 1u);
}

}  // namespace trajectory_kernel_test
}  // namespace kinex::families
