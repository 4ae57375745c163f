// SPDX-License-Identifier: GPL-3.0-or-later
// Convex hulls where points meet, lie on lines, or move together: all methods agree, CGAL agrees
// between all events, and so does `sturm`.
#include <gtest/gtest.h>

#include "tests/sanitized.h"
#include "tests/structures/hull/hull_support.h"

namespace kinex::test {
namespace convex_hull_2_degenerate_test {

TEST(ConvexHull2Degenerate, SmallIntegers) {
  for (std::uint64_t seed = 0; seed < test::fewer(40u); ++seed) {
    const int n = 2 + static_cast<int>(seed % 9), degree = 1 + static_cast<int>(seed % 2);
    SCOPED_TRACE(seed);
    expect_one_story(small_plane(n, seed, degree, 1 + static_cast<int>(seed % 4)));
  }
}

TEST(ConvexHull2Degenerate, TwinsInSturm) {
  for (std::uint64_t seed = 0; seed < test::fewer(12u); ++seed) {
    for (const char* structure :
         {"convex_hull_2", "convex_hull_2_naive", "convex_hull_2_brute_force"}) {
      HullRun run(small_plane(10, seed, 1 + static_cast<int>(seed % 2), 2), structure);
      run.trial.to_end();
      EXPECT_EQ(run.trial.simulator.violations(), std::vector<std::string>{});
    }
  }
}

// All points pass through one point.
TEST(ConvexHull2Degenerate, Pencil) {
  for (const int n : {3, 6, 11}) {
    std::vector<Trajectory> motions;
    for (int i = 0; i < n; ++i)
      motions.push_back(path({{0, (5 * i) % 7 - 3}, {0, (3 * i) % 8 - 4}}));
    expect_one_story(scene_of(motions, -1, Rational(1)));
  }
}

// All points identically on one line: slanted, vertical, horizontal, and all at one place.
TEST(ConvexHull2Degenerate, OneLineForEver) {
  Random random(3);
  std::vector<Trajectory> slanted, vertical, horizontal, together;
  for (int i = 0; i < 7; ++i) {
    const int s = random.between(-5, 5), v = random.between(-3, 3);
    slanted.push_back(path({{s, v}, {2 * s + 1, 2 * v}}));
    vertical.push_back(path({{3}, {s, v}}));
    horizontal.push_back(path({{s, v}, {-1, 1}}));
    together.push_back(path({{1, 2}, {-1, 1}}));
  }
  for (const auto& motions : {slanted, vertical, horizontal, together}) {
    expect_one_story(scene_of(motions, -2, Rational(2)));
  }
}

// Three points that are always on one line change places where no triple turns: bounds that count turns
// of triples do not speak of them.
TEST(ConvexHull2Degenerate, ThreeOnOneLineForEver) {
  for (const int slope : {0, 2}) {
    expect_one_story(scene_of({path({{0}, {0}}), path({{1, 1}, {slope, slope}}),
                               path({{3, -2}, {3 * slope, -2 * slope}})},
                              -10, Rational(10)));
    expect_one_story(scene_of({path({{3, 3, 4}, {3 * slope, 3 * slope, 4 * slope}}),
                               path({{3, 2, -4}, {3 * slope, 2 * slope, -4 * slope}}),
                               path({{1, -3, 3}, {slope, -3 * slope, 3 * slope}})},
                              -20, Rational(20)));
  }
}

// Points that slide along hull edges and reach their ends.
TEST(ConvexHull2Degenerate, AlongAnEdge) {
  const std::vector<Trajectory> square{path({{0}, {0}}), path({{4}, {0}}), path({{4}, {4}}),
                                       path({{0}, {4}})};
  std::vector<Trajectory> motions = square;
  motions.push_back(path({{1, 1}, {0}}));   // leaves the lower edge at t = 3
  motions.push_back(path({{4}, {3, -1}}));  // down the right edge
  motions.push_back(path({{0}, {2}}));      // stays on the left edge
  motions.push_back(path({{-1, 1}, {4}}));  // comes onto the upper edge at t = 1
  expect_one_story(scene_of(motions, 0, Rational(5)));
}

// A lattice that is reached, and left, by all points at once.
TEST(ConvexHull2Degenerate, Lattice) {
  for (std::uint64_t seed = 0; seed < test::fewer(4u); ++seed) {
    Random random(seed);
    std::vector<Trajectory> motions;
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        const int v = random.between(-3, 3), w = random.between(-3, 3);
        motions.push_back(path({{i - v, v}, {j - w, w}}));
      }
    }
    expect_one_story(scene_of(motions, 0, Rational(2)));
  }
}

TEST(ConvexHull2Degenerate, FlightPlans) {
  for (std::uint64_t seed = 1; seed <= test::fewer(25u); ++seed) {
    SCOPED_TRACE(seed);
    expect_one_story(random_flights(seed, 3 + static_cast<int>(seed % 6), 2,
                                    1 + static_cast<int>(seed % 2), false));
  }
}

// At t = 1 a point enters the hull of four points, and leaves it at t = 3; at t = 1 a structure of two other
// points has a failure that comes with a new flight plan, too.
TEST(ConvexHull2Degenerate, AnotherStructureFailsAtTheInstant) {
  Scene scene = scene_of({path({{0}, {0}}), path({{4}, {0}}), path({{2}, {3}}),
                          path({{2}, {9, -12, 3}}), path({{9}, {0}}), path({{9}, {1}})},
                         Rational(Integer(4), Integer(5)), Rational(Integer(16), Integer(5)));
  scene.objects[4].motion.pieces = {{std::nullopt, Rational(1), path({{9}, {0}})},
                                    {Rational(1), std::nullopt, path({{8, 1}, {0}})}};
  Request list;
  list.structure = list.label = "sorted_list";
  list.of = {Subset::Kind::kObjects, {4, 5}, {}};
  for (const char* hull : {"convex_hull_2", "convex_hull_2_naive", "convex_hull_2_brute_force",
                           "convex_hull_2_delaunay"}) {
    SCOPED_TRACE(hull);
    Request request;
    request.structure = request.label = hull;
    request.of = {Subset::Kind::kObjects, {0, 1, 2, 3}, {}};
    scene.maintain = {request, list};
    for (const char* arithmetic : {"exact", "sturm"}) {
      SimulatorOptions options;
      options.audit = AuditLevel::kEvents;
      Simulator simulator(scene, planned_arithmetic(arithmetic, scene), options);
      add_structures(simulator, scene);
      simulator.start();
      simulator.run_until(std::nullopt);
      EXPECT_EQ(simulator.violations(), std::vector<std::string>{}) << arithmetic;
      std::uint64_t external = 0;
      for (StructureId id = 0; id < simulator.structures(); ++id) {
        if (simulator.label(id) == hull) external = simulator.ledger(id).external;
      }
      EXPECT_EQ(external, 2u) << arithmetic;
    }
  }
}

TEST(ConvexHull2Degenerate, PointsComeAndGo) {
  for (std::uint64_t seed = 1; seed <= test::fewer(25u); ++seed) {
    SCOPED_TRACE(seed);
    expect_one_story(random_flights(seed, 3 + static_cast<int>(seed % 8), 2,
                                    1 + static_cast<int>(seed % 2), true));
  }
}

}  // namespace convex_hull_2_degenerate_test
}  // namespace kinex::test
