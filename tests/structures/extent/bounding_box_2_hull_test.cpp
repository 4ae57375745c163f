// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/bounding_box_2_hull.h"

#include <string>
#include <vector>

#include "tests/sanitized.h"
#include "tests/structures/extent/circle_support.h"

namespace kinex::test {
namespace bounding_box_2_hull_test {

// The box changes at the same instants as bounding_box. Its extreme points are the same unless some
// are identically level, or the smallest of them is no vertex.
void expect_agreement(const Scene& scene, bool same_points) {
  const LayeredRun box(scene, "bounding_box");
  for (const std::string& hull : kAllHulls) {  // a hull of directions has the axes among them
    SCOPED_TRACE(hull);
    const LayeredRun other(scene, "bounding_box_2_hull", hull);
    if (!same_points) continue;
    EXPECT_EQ(other.sink.history, box.sink.history);
    EXPECT_EQ(other.external(), box.external());
  }
}

TEST(BoundingBox2Hull, EveryPointOfACircleOfLinesIsOnTheBoxOnce) {
  for (const int n : {3, 4, 5, 8, 12}) {
    if (kSanitized && n > 8) break;
    std::vector<Trajectory> t;
    for (int i = 0; i < n; ++i) {
      std::vector<std::vector<Rational>> axes;
      for (int axis = 0; axis < 2; ++axis) {
        const Rational a =
            Rational(Integer(6 - axis), Integer(n)) *
            (Rational(Integer(2 * i - n + 1), Integer(2)) +
             Rational(Integer(1), Integer(7 - 2 * axis)));
        const Rational all = Rational(1) + a * a;
        const Rational x = (Rational(1) - a * a) / all, y = Rational(2) * a / all;
        axes.push_back(axis == 0 ? std::vector<Rational>{x, y} : std::vector<Rational>{y, x});
      }
      t.push_back(path(std::move(axes)));
    }
    const Scene scene = scene_of(t, -1000000, Rational(1000000));
    SCOPED_TRACE(n);
    expect_agreement(scene, true);
    EXPECT_EQ(LayeredRun(scene, "bounding_box_2_hull").external(),
              static_cast<std::uint64_t>(2 * n));
  }
}

TEST(BoundingBox2Hull, ReferenceCounts) {
  const std::vector<std::pair<int, std::uint64_t>> rows{{4, 1}, {6, 2}, {8, 2}, {10, 2}};
  for (const auto& [n, changes] : rows) {
    expect_agreement(remainders(n), true);
    for (const std::string& hull : kAllHulls) {
      EXPECT_EQ(LayeredRun(remainders(n), "bounding_box_2_hull", hull).external(), changes) << n;
    }
  }
  // All points at one place for an instant: the four sides change at once.
  expect_agreement(through_origin(8, Rational(-1)), true);
  EXPECT_EQ(LayeredRun(through_origin(8, Rational(-1)), "bounding_box_2_hull").external(), 1u);
}

TEST(BoundingBox2Hull, FewPoints) {
  for (int n = 0; n <= 3; ++n) {
    std::vector<Trajectory> t;
    for (int i = 0; i < n; ++i) t.push_back(path({{4 * i, i == 1 ? -3 : 0}, {i * i, 1 - i}}));
    Scene scene = scene_of(t, 0, Rational(3));
    scene.dimension = 2;
    SCOPED_TRACE(n);
    expect_agreement(scene, true);
  }
  expect_agreement(scene_of(std::vector<Trajectory>(4, path({{1, 1}, {2}})), 0, Rational(2)), true);
}

TEST(BoundingBox2Hull, TiesGoToTheSmallestVertex) {
  // 0 is between 1 and 2 on the left side, identically: bounding_box names it, the hull does not.
  const Scene scene = scene_of({path({{0}, {1}}), path({{0}, {3}}), path({{0}, {0}}),
                                path({{4}, {2}})},
                               0, Rational(1));
  EXPECT_EQ(LayeredRun(scene, "bounding_box_2_hull").values(),
            (std::vector<std::vector<ObjectId>>{{1, 3, 2, 1}}));
  EXPECT_EQ(LayeredRun(scene, "bounding_box").values(),
            (std::vector<std::vector<ObjectId>>{{0, 3, 2, 1}}));
}

// External events of `linear` lattices of linear motion, and of a third as many of degree 2 and of degree 3;
// beside each a scene of flight plans.
std::uint64_t run_scenes(std::uint64_t linear) {
  std::uint64_t external = 0;
  for (const int degree : {1, 2, 3}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(degree == 1 ? linear : linear / 3); ++seed) {
      SCOPED_TRACE("degree " + std::to_string(degree) + ", seed " + std::to_string(seed));
      const Scene plain = circle_lattice(77 + seed, degree);
      expect_agreement(plain, false);
      expect_agreement(random_flights(seed, 8, 2, degree, seed % 4 != 0), false);
      external += LayeredRun(plain, "bounding_box_2_hull").external();
      if (::testing::Test::HasFailure()) return external;
    }
  }
  return external;
}

TEST(BoundingBox2Hull, RandomScenes) { EXPECT_GT(run_scenes(36), test::seen_in_fewer(60u)); }

TEST(SlowBoundingBox2Hull, RandomScenes) { EXPECT_GT(run_scenes(30), 60u); }

}  // namespace bounding_box_2_hull_test
}  // namespace kinex::test
