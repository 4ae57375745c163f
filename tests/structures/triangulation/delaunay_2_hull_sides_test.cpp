// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay2 where the turn at a hull vertex is identically zero, and on lattices where that is common.
#include <cstdlib>
#include <string>

#include "tests/sanitized.h"
#include "tests/structures/proximity/reference_scenes.h"
#include "tests/structures/triangulation/delaunay_2_support.h"

namespace kinex::delaunay_2_test {

// o1, o4 and o5 meet at t = 1; o4 and o5 have slid to the corner along two sides of the hull, identically on
// a line with it. All certificates of circles and turns only touch zero there: what fails is that o4 and o5
// are between their neighbours on the hull.
TEST(Delaunay2HullSides, ThreeThatMeetAtACornerOfTheHull) {
  const std::vector<Trajectory> motions{
      integers(2, -1, 2, -1), integers(1, 1, 0, 0), integers(0, 1, 0, 0), integers(0, -1, 0, 1),
      integers(2, 0, 0, 0), integers(2, 0, 1, -1), integers(2, 0, 2, -1)};
  World world(scene_of(motions, -3, 3));
  world.run().expect_clean();
}

// Seeds and sizes in which points that meet on the hull turned triangles over without a failure.
TEST(Delaunay2HullSides, LatticesWhosePointsMeetOnTheHull) {
  const std::vector<std::pair<std::uint64_t, int>> scenes{
      {1127, 9}, {3128, 9},  {3477, 8},  {8219, 8},  {8411, 9},
      {9655, 9}, {10941, 8}, {10941, 9}, {14096, 7}, {20621, 7}};
  for (const auto& [seed, n] : scenes) {
    SCOPED_TRACE(seed);
    World world(kinex::test::lattice_scene(seed, n, 2));
    world.run().expect_clean();
  }
}

// KINEX_LATTICE_SEEDS: how many seeds, of five scenes each.
TEST(SlowDelaunay2HullSides, TinyLattices) {
  const char* wanted = std::getenv("KINEX_LATTICE_SEEDS");
  const std::uint64_t seeds = wanted == nullptr ? 200 : std::strtoull(wanted, nullptr, 10);
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    for (int n = 5; n <= 9; ++n) {
      SCOPED_TRACE(std::to_string(seed) + ", n = " + std::to_string(n));
      World world(kinex::test::lattice_scene(seed, n, 2));
      world.run().expect_clean();
    }
    if (testing::Test::HasFailure()) return;
  }
}

// Points that slide along one side of the hull and pass each other, with others above: o0 .. o5 are
// identically on the line y = 0, until a new motion lifts one of them for a while. Degrees 1 to 3.
TEST(Delaunay2HullSides, ASideOfTheHullThatIsStraightForAWhile) {
  for (std::uint64_t seed = 0; seed < test::fewer(24u); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const int degree = 1 + static_cast<int>(seed % 3);
    const auto any = [&](std::int64_t most) {
      Coefficients c;
      for (int k = 0; k <= degree; ++k) c.push_back(Rational(random.between(-most, most)));
      return c;
    };
    Scene scene;
    scene.name = "test";
    scene.dimension = 2;
    scene.start = Rational(-3);
    scene.end = Rational(3);
    for (int i = 0; i < 9; ++i) {
      const Coefficients x = any(2);
      SceneObject object;
      object.id = std::to_string(i);
      if (i >= 6) {  // y = 1 + (t - c)^2 or a constant above the line
        const std::int64_t c = random.between(-2, 2);
        const bool falls = degree > 1;
        object.motion.pieces.push_back(
            {std::nullopt, std::nullopt,
             falls ? moving(x, {Rational(1 + c * c), Rational(-2 * c), Rational(1)})
                   : moving(x, {Rational(random.between(1, 3))})});
      } else if (i == static_cast<int>(seed % 6)) {
        // Up by 1 a unit of time from -1 to 0, stays until 1, and goes back on the line at 2.
        const Trajectory on = moving(x, {Rational(0)});
        const Trajectory up = moving(x, {Rational(1), Rational(1)});
        const Trajectory stays = moving(x, {Rational(1)});
        const Trajectory down = moving(x, {Rational(2), Rational(-1)});
        object.motion.pieces = {{std::nullopt, Rational(-1), on},
                                {Rational(-1), Rational(0), up},
                                {Rational(0), Rational(1), stays},
                                {Rational(1), Rational(2), down},
                                {Rational(2), std::nullopt, on}};
      } else {
        object.motion.pieces.push_back({std::nullopt, std::nullopt, moving(x, {Rational(0)})});
      }
      scene.objects.push_back(std::move(object));
    }
    World world(scene);
    world.run().expect_clean();
    World inexact(scene, "double", AuditLevel::kNone);
    inexact.run();
    EXPECT_EQ(inexact.status, RunStatus::kDone);
  }
}

}  // namespace kinex::delaunay_2_test
