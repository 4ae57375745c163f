// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/extent_directions.h"

#include <string>
#include <vector>

#include "tests/sanitized.h"
#include "tests/structures/extent/directions_support.h"
#include "tests/structures/special_scenes.h"

namespace kinex::test {
namespace extent_directions_test {

using Ids = std::vector<ObjectId>;

std::uint64_t run_all(const Scene& scene, int k) {
  SCOPED_TRACE("k = " + std::to_string(k));
  const DirectionsRun diameter(scene, "diameter_directions", k);
  const DirectionsRun width(scene, "width_directions", k);
  const DirectionsRun area(scene, "min_area_rectangle_directions", k);
  const DirectionsRun perimeter(scene, "min_perimeter_rectangle_directions", k);
  return diameter.ledger().external + width.ledger().external + area.ledger().external +
         perimeter.ledger().external;
}

TEST(ExtentDirections, RandomLattices) {
  std::uint64_t external = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(150u); ++seed) {
    SCOPED_TRACE(seed);
    external += run_all(direction_lattice(seed, 1), static_cast<int>(seed % 4) + 1);
  }
  EXPECT_GT(external, test::seen_in_fewer(2000u));
}

TEST(ExtentDirections, RandomLatticesOfHigherDegree) {
  std::uint64_t external = 0;
  for (const int degree : {2, 3}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(30u); ++seed) {
      SCOPED_TRACE("degree " + std::to_string(degree) + ", seed " + std::to_string(seed));
      external += run_all(direction_lattice(seed, degree), static_cast<int>(seed % 3) + 1);
    }
  }
  EXPECT_GT(external, test::seen_in_fewer(600u));
}

TEST(ExtentDirections, RandomFlights) {
  std::uint64_t external = 0;
  for (const int degree : {1, 2, 3}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(8u); ++seed) {
      SCOPED_TRACE("degree " + std::to_string(degree) + ", seed " + std::to_string(seed));
      external += run_all(random_flights(seed, 9, 2, degree, seed % 2 == 0), 2);
    }
  }
  EXPECT_GT(external, test::seen_in_fewer(200u));
}

TEST(ExtentDirections, ReferenceScenes) {
  for (const int n : {4, 6, 8, 10}) {
    SCOPED_TRACE(n);
    for (const int k : {1, 2, 7}) run_all(remainders(n), k);
  }
}

TEST(ExtentDirections, NoPointToThree) {
  for (int n = 0; n <= 3; ++n) {
    SCOPED_TRACE(n);
    std::vector<Trajectory> t;
    for (int i = 0; i < n; ++i) t.push_back(path({{4 * i, i == 1 ? -3 : 0}, {i * i, 1 - i}}));
    Scene scene = scene_of(t, 0, Rational(3));
    scene.dimension = 2;
    run_all(scene, 1);
    run_all(scene, 3);
    for (const char* structure : {"diameter_directions", "width_directions"}) {
      EXPECT_EQ(DirectionsRun(scene, structure, 3).begins_with.size(), n < 2 ? 0u : 2u);
    }
  }
}

// Two points on a rotating line: the extents of both axes are equal at 1, where the direction of
// the diameter changes, and the pair does not.
TEST(ExtentDirections, AnotherDirectionOfTheSamePairIsNoChange) {
  const Scene scene = scene_of({path({{0}, {0}}), path({{1}, {0, 1}})}, 0, Rational(2));
  const DirectionsRun run(scene, "diameter_directions", 1);
  EXPECT_EQ(run.begins_with, (Ids{0, 1}));
  EXPECT_EQ(run.ledger().failures, 1u);
  EXPECT_EQ(run.ledger().external, 0u);
}

// 2 and 3 part along x, past the distance of 0 and 1 along y at t = 2.
TEST(ExtentDirections, ASingleFailureIsTheChange) {
  const Scene scene = scene_of(
      {path({{0}, {0}}), path({{0}, {4}}), path({{0, 1}, {1}}), path({{0, -1}, {3}})}, 1, 3);
  const DirectionsRun run(scene, "diameter_directions", 1);
  EXPECT_EQ(run.begins_with, (Ids{0, 1}));
  EXPECT_EQ(run.changes(), std::vector<std::string>{"overtake 1 0 2 3 !"});
  const DirectionsRun width(scene, "width_directions", 1);
  EXPECT_EQ(width.changes(), std::vector<std::string>{"overtake 2 3 1 0 !"});
}

TEST(ExtentDirections, WithoutExtent) {
  // All are one point.
  const Scene one = scene_of(std::vector<Trajectory>(4, path({{1, 1}, {2, -3}})), 0, Rational(4));
  EXPECT_EQ(DirectionsRun(one, "diameter_directions", 4).ids(), Ids{});
  EXPECT_EQ(DirectionsRun(one, "width_directions", 4).ids(), Ids{});
  // All on one line, across a direction or not.
  const Scene line = scene_of({path({{2}, {0}}), path({{2}, {0, 1}}), path({{2}, {5}})}, 0, 9);
  EXPECT_EQ(DirectionsRun(line, "diameter_directions", 2).begins_with, (Ids{0, 2}));
  EXPECT_EQ(DirectionsRun(line, "diameter_directions", 2).ids(), (Ids{0, 1}));
  EXPECT_EQ(DirectionsRun(line, "width_directions", 2).ids(), Ids{});
  const Scene slanted =
      scene_of({path({{0}, {0}}), path({{0, 7}, {0, 1}}), path({{35}, {5}})}, 0, 9);
  EXPECT_EQ(DirectionsRun(slanted, "width_directions", 2).ids(), (Ids{0, 1}));
  // Through one point at one instant, and from there on.
  std::vector<Trajectory> t;
  for (int i = 0; i < 9; ++i) t.push_back(path({{0, i - 4}, {0, (i * 5) % 9 - 4}}));
  for (const int k : {1, 2, 5}) {
    run_all(scene_of(t, -1, 1), k);
    run_all(scene_of(t, 0, 1), k);
  }
}

TEST(ExtentDirections, Jumps) {
  const Scene scene = one_jumps(2, 2);
  run_all(scene, 2);
  const DirectionsRun run(scene, "diameter_directions", 2);
  EXPECT_EQ(run.begins_with, (Ids{0, 2}));
  EXPECT_EQ(run.ids(), (Ids{0, 3}));
  EXPECT_EQ(run.ledger().external, 0u);
}

TEST(ExtentDirections, ExtremeNumbers) {
  for (const char* size : kExtremeUnits) {
    SCOPED_TRACE(size);
    run_all(in_units_of(size), 3);
  }
}

TEST(ExtentDirections, EndsInInexactArithmetics) {
  for (const char* arithmetic : {"double", "gsl", "mpfr:4", "mpfr:53"}) {
    for (const int degree : {1, 2}) {
      for (std::uint64_t seed = 1; seed <= test::fewer(6u); ++seed) {
        for (const char* structure : {"diameter_directions", "width_directions"}) {
          const DirectionsRun run(random_flights(seed, 9, 2, degree, seed % 2 == 0), structure, 2,
                                  arithmetic);
          EXPECT_TRUE(run.ledger().corrupt || run.ids().size() <= 2) << arithmetic;
        }
      }
    }
  }
}

}  // namespace extent_directions_test
}  // namespace kinex::test
