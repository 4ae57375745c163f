// SPDX-License-Identifier: GPL-3.0-or-later
// Regular3: counts found by brute force, tiny lattices, ties, equal points, flight plans, arithmetics.
#include <algorithm>
#include <utility>

#include "tests/sanitized.h"
#include "tests/structures/triangulation/regular_support.h"

namespace kinex::regular_test {
namespace regular_3_test {

using World = RegularWorld<Regular3>;
using test::path;
using test::reference_scene;

// Events of four ids are those of the hull.
std::uint64_t at_hull(const World& world, const std::string& kind) {
  std::uint64_t count = 0;
  for (const std::string& line : world.lines()) {
    count += line.find(kind + " ") == 0 && std::count(line.begin(), line.end(), ' ') == 5;
  }
  return count;
}

void expect_same_in_sturm(const Scene& scene, const World& world) {
  World sturm(scene, "sturm");
  sturm.run().expect_clean();
  EXPECT_EQ(world.lines(), sturm.lines());
  EXPECT_EQ(world.cells(), sturm.cells());
}

TEST(Regular3, ReferenceCounts) {
  struct Row {
    int n;
    std::uint64_t seed, inner_2_3, hull_2_3, inner_3_2, hull_3_2, show, hide;
  };
  for (const Row& row : {Row{6, 1, 2, 1, 1, 2, 1, 1}, Row{7, 2, 2, 2, 2, 3, 0, 0}}) {
    SCOPED_TRACE(row.n);
    const Scene scene = weighted_reference(row.n, row.seed, true, 3);
    World world(scene), sturm(scene, "sturm");
    world.run().expect_clean();
    sturm.run().expect_clean();
    EXPECT_EQ(world.count("flip_2_3"), row.inner_2_3);
    EXPECT_EQ(world.count("flip_3_2"), row.inner_3_2);
    EXPECT_EQ(world.count("enter") + world.count("hull_2_3"), row.hull_2_3);
    EXPECT_EQ(world.count("leave") + world.count("hull_3_2"), row.hull_3_2);
    EXPECT_EQ(world.count("show"), row.show);
    EXPECT_EQ(world.count("hide"), row.hide);
    EXPECT_EQ(at_hull(world, "show"), row.show);
    EXPECT_EQ(at_hull(world, "hide"), row.hide);
    EXPECT_EQ(world.count("retile") + world.count("blocked"), 0u);
    EXPECT_EQ(world.lines(), sturm.lines());
  }
}

// Points of {0, 1, 2}^3 with weights in 0 .. 4 and velocities in {-1, 0, 1}: most instants are
// degenerate.
void tiny_lattices(std::uint64_t first, std::uint64_t last, bool moving) {
  for (std::uint64_t seed = first; seed < first + test::fewer(last - first); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = weighted_lattice(seed, 5 + static_cast<int>(seed % 5), moving, 3);
    World world(scene);
    world.run().expect_clean();
    EXPECT_EQ(world.cells(), static_cells<Regular3>(scene, *scene.end));
  }
}
TEST(Regular3, TinyLattices) { tiny_lattices(0, 20, false); }
TEST(Regular3, TinyLatticesOfMovingWeights) { tiny_lattices(0, 20, true); }
TEST(SlowRegular3, TinyLattices) { tiny_lattices(20, 220, false); }
TEST(SlowRegular3, TinyLatticesOfMovingWeights) { tiny_lattices(20, 220, true); }

// P5: the weight of a point in a cell crosses the value at which it shows k times.
TEST(Regular3, Breathing) {
  for (const int k : {1, 2, 5}) {
    SCOPED_TRACE(k);
    const Coefficients weight = crossing_weight(k, -18);  // the height 6 + 18 is that of the plane
    const Rational zero(0), six(6);
    const Scene scene = weighted_scene(
        {path({{zero}, {zero}, {zero}, {zero}}), path({{six}, {zero}, {zero}, {zero}}),
         path({{zero}, {six}, {zero}, {zero}}), path({{zero}, {zero}, {six}, {zero}}),
         path({{Rational(2)}, {Rational(1)}, {Rational(1)}, weight})},
        0, Rational(k + 1));
    World world(scene);
    world.run().expect_clean();
    expect_same_in_sturm(scene, world);
    ASSERT_EQ(world.lines().size(), static_cast<std::size_t>(k));
    for (int i = 0; i < k; ++i) {
      const char* const kind = (k - i) % 2 == 0 ? "hide 4 0 1 2 3 !" : "show 4 0 1 2 3 !";
      EXPECT_EQ(world.lines()[static_cast<std::size_t>(i)], kind);
    }
  }
}

// Equal weights give the flips of the Delaunay triangulation, counted by brute force; one polynomial
// added to all weights changes nothing.
TEST(Regular3, EqualWeightsAreNone) {
  struct Row {
    int n;
    std::uint64_t seed, inner_2_3, hull_2_3, inner_3_2, hull_3_2;
  };
  for (const Row& row : {Row{6, 1, 2, 4, 3, 4}, Row{7, 2, 9, 7, 8, 10}, Row{8, 1, 5, 9, 5, 9}}) {
    SCOPED_TRACE(row.n);
    Scene scene = reference_scene(row.n, 3, row.seed);
    World plain(scene);
    plain.run().expect_clean();
    scene.extents = Extents::kWeight;
    for (SceneObject& object : scene.objects) {
      object.motion.pieces[0].trajectory.coordinates.push_back({7, -5, 3});
    }
    World equal(scene);
    equal.run().expect_clean();
    EXPECT_EQ(equal.count("flip_2_3"), row.inner_2_3);
    EXPECT_EQ(equal.count("flip_3_2"), row.inner_3_2);
    EXPECT_EQ(equal.count("enter") + equal.count("hull_2_3"), row.hull_2_3);
    EXPECT_EQ(equal.count("leave") + equal.count("hull_3_2"), row.hull_3_2);
    EXPECT_EQ(equal.lines(), plain.lines());
  }
  for (const bool linear : {false, true}) {
    const Scene scene = weighted_reference(7, 2, linear, 3);
    Scene raised = scene;
    for (SceneObject& object : raised.objects) {
      Coefficients& weight = object.motion.pieces[0].trajectory.coordinates[3];
      weight.resize(3);
      for (const auto& [k, c] : {std::pair(0, -900), std::pair(1, 70), std::pair(2, 2)}) {
        weight[static_cast<std::size_t>(k)] += Rational(c);
      }
    }
    World before(scene), after(raised);
    before.run().expect_clean();
    after.run().expect_clean();
    EXPECT_GT(before.lines().size(), 8u);
    EXPECT_EQ(before.lines(), after.lines());
  }
}

// Degenerate at t = 0 alone, without weights: the unit cube is sheared once, and the square of an octahedron
// gets another diagonal.
TEST(Regular3, AShearedCubeAndAnOctahedron) {
  const Rational half = fraction(1, 2);
  std::vector<Trajectory> cube, octahedron;
  for (int i = 0; i < 8; ++i) cube.push_back(path({{i / 4, i / 2 % 2}, {i / 2 % 2}, {i % 2}}));
  for (const int x : {1, -1}) octahedron.push_back(path({{x}, {0}, {0}}));
  for (const int y : {1, -1}) octahedron.push_back(path({{0}, {y}, {0}}));
  octahedron.push_back(path({{0}, {0}, {1, 1}}));
  octahedron.push_back(path({{0}, {0}, {-1}}));
  const std::pair<Scene, std::size_t> scenes[]{{test::scene_of(cube, -2, Rational(2)), 6},
                                               {test::scene_of(octahedron, -half, half), 4}};
  for (const auto& [scene, cells] : scenes) {
    SCOPED_TRACE(cells);
    World world(scene);
    const std::vector<ObjectId> before = world.cells();
    world.run().expect_clean();
    EXPECT_EQ(before.size(), 4 * cells);
    EXPECT_EQ(world.cells().size(), 4 * cells);
    EXPECT_NE(world.cells(), before);
    EXPECT_EQ(world.simulator().ledger().instants, 1u);
    EXPECT_EQ(world.ledger().rebuilds, 0u);
    expect_same_in_sturm(scene, world);
  }
}

// Balls have the squares of their radii as weights.
TEST(Regular3, Balls) {
  Scene weights = weighted_reference(8, 1, false, 3), balls = weights;
  balls.extents = Extents::kRadius;
  for (std::size_t i = 0; i < weights.objects.size(); ++i) {
    const Rational radius(static_cast<std::int64_t>(20 * i % 31));
    weights.objects[i].motion.pieces[0].trajectory.coordinates[3] = {radius * radius};
    balls.objects[i].motion.pieces[0].trajectory.coordinates[3] = {radius};
  }
  World one(weights), other(balls);
  one.run().expect_clean();
  other.run().expect_clean();
  EXPECT_EQ(one.lines(), other.lines());
  EXPECT_GT(one.lines().size(), 10u);
}

// Points of random linear motion, identically lifted to one plane that moves: which points make a cell, and which are
// hidden, follows from ids and orientations alone.
TEST(Regular3, PointsInOneLiftedPlane) {
  std::uint64_t events = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(12u); ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    std::vector<Trajectory> motions;
    for (int i = 0; i < 6; ++i) {
      std::vector<Coefficients> axes;
      for (int axis = 0; axis < 3; ++axis) {
        axes.push_back({random.between(-2, 2), random.between(-1, 1)});
      }
      // x^2 + y^2 + z^2 - w = x - y + 2t, for some 1 more.
      Coefficients w(3);
      for (const Coefficients& c : axes) {
        for (std::size_t a = 0; a < 2; ++a) {
          for (std::size_t b = 0; b < 2; ++b) w[a + b] += c[a] * c[b];
        }
      }
      for (std::size_t k = 0; k < 2; ++k) w[k] -= axes[0][k] - axes[1][k];
      w[1] -= Rational(2);
      if (seed % 2 == 0 && i > 4) w[0] -= Rational(1);
      axes.push_back(w);
      motions.push_back(path(std::move(axes)));
    }
    const Scene scene = weighted_scene(motions, -3, Rational(3));
    World world(scene);
    world.run().expect_clean();
    EXPECT_EQ(world.cells(), static_cells<Regular3>(scene, *scene.end));
    events += world.ledger().external;
  }
  EXPECT_GT(events, test::seen_in_fewer(40u));
}

// In the plane z = 0 of the hull one point passes over the line through two others while the point behind
// that plane crosses it: the orientations touch zero only.
TEST(Regular3, PointsPassInAPlaneOfTheHull) {
  for (const int x : {-1, 0, 1, 3}) {
    SCOPED_TRACE(x);
    const Rational one(1), zero(0);
    const Scene scene = weighted_scene(
        {path({{Rational(-3)}, {Rational(-2)}, {zero}, {zero}}),
         path({{Rational(3)}, {Rational(-2)}, {zero}, {zero}}),
         path({{zero}, {Rational(2)}, {zero}, {zero}}), path({{zero, one}, {zero}, {zero}, {zero}}),
         path({{Rational(x)}, {zero}, {zero, Rational(-1)}, {zero}})},
        -1, Rational(1));
    World world(scene);
    world.run().expect_clean();
    EXPECT_EQ(world.cells(), static_cells<Regular3>(scene, *scene.end));
  }
}

// Points of a plane and one more beside it: its cells are those of the triangulation in the plane with the
// last point, which is all that happens there. All facets in the plane are identically flat, and the hull
// about the last point can come to wind around twice as that in the plane can (seed 81).
void cones(std::uint64_t first, std::uint64_t last) {
  for (std::uint64_t seed = first; seed < first + test::fewer(last - first); ++seed) {
    SCOPED_TRACE(seed);
    const Scene plane = weighted_lattice(seed, 5 + static_cast<int>(seed % 5), true);
    Scene cone = plane;
    cone.dimension = 3;
    const auto apex = static_cast<ObjectId>(plane.objects.size());
    cone.objects.push_back(cone.objects[0]);
    cone.objects.back().id = "apex";
    for (SceneObject& object : cone.objects) {
      auto& axes = object.motion.pieces[0].trajectory.coordinates;
      if (object.id == "apex") axes = {{1}, {1}, {2}};
      axes.insert(axes.begin() + 2, {Rational(object.id == "apex" ? 1 : 0)});
    }
    RegularWorld<Regular2> below(plane);
    World world(cone);
    for (int i = -11; i <= 12; ++i) {
      const Rational t = fraction(i, 4) - fraction(i == 12 ? 0 : 1, 9);
      below.run_until(t);
      world.run_until(t);
      std::vector<ObjectId> expected;
      for (std::size_t k = 0; k < below.cells().size(); k += 3) {
        const std::vector<ObjectId> ids = below.cells();
        expected.insert(expected.end(), ids.begin() + static_cast<std::ptrdiff_t>(k),
                        ids.begin() + static_cast<std::ptrdiff_t>(k + 3));
        expected.push_back(apex);
      }
      EXPECT_EQ(world.cells(), expected);
    }
    world.expect_clean();
  }
}
TEST(Regular3, ConesOverThePlane) { cones(70, 100); }
TEST(SlowRegular3, ConesOverThePlane) { cones(100, 300); }

TEST(Regular3, EqualPointsFewPointsAndOnePlane) {
  Scene scene = weighted_reference(6, 1, true, 3);
  for (int i = 0; i < 3; ++i) {  // the weight is smaller, equal, larger
    scene.objects.push_back(scene.objects[static_cast<std::size_t>(i)]);
    scene.objects.back().id = "twin " + std::to_string(i);
    scene.objects.back().motion.pieces[0].trajectory.coordinates[3][0] += Rational(i - 1);
  }
  World twins(scene);
  twins.run().expect_clean();
  EXPECT_FALSE(twins.structure().is_vertex(6));
  EXPECT_FALSE(twins.structure().is_vertex(7));
  EXPECT_FALSE(twins.structure().is_vertex(2));
  for (int n = 0; n <= 5; ++n) {
    Scene few = weighted_reference(5, 7, true, 3);
    few.objects.resize(static_cast<std::size_t>(n));
    World world(few);
    world.run().expect_clean();
    EXPECT_EQ(world.structure().flat(), n < 4);
  }
  Scene plane = weighted_reference(7, 3, true, 3);
  for (SceneObject& object : plane.objects) {
    auto& axes = object.motion.pieces[0].trajectory.coordinates;
    axes[2] = axes[0];
  }
  World world(plane);
  world.run().expect_clean();
  EXPECT_TRUE(world.structure().planar());
  EXPECT_FALSE(world.structure().has_all_pairs());
  EXPECT_TRUE(world.cells().empty());
}

void flights(std::uint64_t first, std::uint64_t last) {
  std::uint64_t updates = 0, comings = 0;
  for (std::uint64_t seed = first; seed < first + test::fewer(last - first); ++seed) {
    SCOPED_TRACE(seed);
    Scene scene = test::random_flights(seed, 6 + static_cast<int>(seed % 3), 4,
                                       1 + static_cast<int>(seed % 2), seed % 4 < 2);
    scene.dimension = 3;
    scene.extents = Extents::kWeight;
    World world(scene);
    world.run().expect_clean();
    updates += world.ledger().motion_updates;
    comings += world.ledger().insertions + world.ledger().erasures;
  }
  EXPECT_GT(updates, test::seen_in_fewer(last - first));
  EXPECT_GT(comings, test::seen_in_fewer(last - first) / 4);
}
TEST(Regular3, FlightPlans) { flights(1, 9); }
TEST(SlowRegular3, FlightPlans) { flights(9, 80); }

TEST(Regular3, ChangesFromOutside) {
  for (std::uint64_t seed = 1; seed <= test::fewer(6u); ++seed) {
    SCOPED_TRACE(seed);
    come_and_go<Regular3>(seed, 3);
  }
}

TEST(Regular3, ReferenceArithmeticAgreesOnLattices) {
  for (std::uint64_t seed = 1; seed <= test::fewer(6u); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = weighted_lattice(seed, 7, seed % 2 == 0, 3);
    World world(scene, "exact", AuditLevel::kNone), sturm(scene, "sturm", AuditLevel::kNone);
    world.run();
    sturm.run();
    EXPECT_EQ(world.lines(), sturm.lines());
  }
}

TEST(Regular3, TwinsInLargeScenes) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    SCOPED_TRACE(seed);
    World world(weighted_twins(20, seed, 3));
    world.run().expect_clean();
  }
}

TEST(Regular3, InexactArithmeticsEnd) {
  for (const char* arithmetic : {"double", "gsl", "mpfr:4", "mpfr:60"}) {
    for (std::uint64_t seed = 0; seed < test::fewer(6u); ++seed) {
      SCOPED_TRACE(std::string(arithmetic) + ", seed " + std::to_string(seed));
      World world(weighted_lattice(seed, 5 + static_cast<int>(seed % 5), seed % 2 == 0, 3),
                  arithmetic, AuditLevel::kNone);
      world.run();
      EXPECT_EQ(world.status, RunStatus::kDone);
    }
  }
}

}  // namespace regular_3_test
}  // namespace kinex::regular_test
