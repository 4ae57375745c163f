// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay3 of points that are all in one plane: its triangulation there, compared with delaunay_2 and audited
// after every event.
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "structures/triangulation/delaunay_2.h"
#include "tests/sanitized.h"
#include "tests/structures/planes_in_space.h"
#include "tests/structures/triangulation/delaunay_3_support.h"

namespace kinex::delaunay_3_test {
namespace delaunay_3_plane_test {

using namespace test;

std::uint64_t plane_changes(const World& world) {
  return world.count("plane_flip") + world.count("plane_enter") + world.count("plane_leave");
}

std::vector<std::array<ObjectId, 2>> pairs_of(const std::vector<ObjectId>& ids) {
  std::vector<std::array<ObjectId, 2>> pairs;
  for (std::size_t i = 0; i < ids.size(); i += 2) pairs.push_back({ids[i], ids[i + 1]});
  return pairs;
}

// At many times the edges are those of delaunay_2 in the plane. Fewer than four vertices have all pairs.
void expect_those_of_the_plane(const Scene& flat, const Turn& turn) {
  const Scene scene = in_space(flat, turn);
  World world(scene);
  Simulator simulator(flat, make_arithmetic("exact", flat), {});
  const StructureId id = simulator.reserve();
  auto made = std::make_unique<Delaunay2>(simulator.kernel(), id, flat);
  const Delaunay2& plane = *made;
  simulator.add(id, std::move(made), "delaunay_2");
  simulator.start();
  for (Rational t = flat.start; t < *flat.end; t += Rational(Integer(3), Integer(17))) {
    world.run_until(t);
    simulator.run_until(t);
    ASSERT_TRUE(world.structure().flat());
    if (!world.structure().planar()) continue;
    ASSERT_EQ(world.structure().edges(), pairs_of(plane.attribute().ids)) << t.to_string();
    for (ObjectId v = 0; v < flat.objects.size(); ++v) {
      if (plane.representative(v) != v) continue;
      ASSERT_EQ(world.structure().neighbours(v), plane.neighbours(v)) << t.to_string();
    }
  }
  world.run().expect_clean();
}

// 0 and 1 at (-2, 0) and (2, 0), 2 at (0, -1), 3 comes down along x = 0: at y = 4 all are on one circle, at
// y = 0 it sinks below the edge of 0 and 1.
TEST(Delaunay3Plane, CountedByHand) {
  const Scene flat =
      scene_of({path({{-2}, {0}}), path({{2}, {0}}), path({{0}, {-1}}), path({{0}, {5, -1}})}, 0,
               *Rational::parse("11/2"));
  for (const Turn& turn : {kFlat, kUpright, kSideways, kOblique}) {
    World world(in_space(flat, turn));
    world.run().expect_clean();
    EXPECT_EQ(world.lines(), (std::vector<std::string>{"plane_flip 0 1 2 3", "plane_leave 3 0 1"}));
    EXPECT_EQ(world.ledger().external, 0u);
    EXPECT_EQ(world.ledger().live, 9u);
    using Edges = std::vector<std::array<ObjectId, 2>>;
    EXPECT_EQ(world.structure().edges(), (Edges{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}));
  }
}

TEST(Delaunay3Plane, TheSameAsInThePlane) {
  for (const auto& [n, seed] : {std::pair(6, 1), {8, 1}, {10, 2}}) {
    SCOPED_TRACE(n);
    const Scene flat = reference_scene(n, 2, static_cast<std::uint64_t>(seed));
    expect_those_of_the_plane(flat, n == 6 ? kUpright : n == 8 ? kOblique : kSideways);
    World world(in_space(flat, kFlat)), sturm(in_space(flat, kFlat), "sturm", AuditLevel::kNone);
    world.run().expect_clean();
    sturm.run();
    EXPECT_EQ(world.lines(), sturm.lines());
    EXPECT_EQ(plane_changes(world), n == 6 ? 18u : n == 8 ? 25u : 46u);
    EXPECT_EQ(world.count("plane_retile") + world.count("plane_blocked"), 0u);
  }
  World stretched(in_space(reference_scene(6, 2, 1), kStretched));
  stretched.run().expect_clean();
  EXPECT_GT(plane_changes(stretched), 0u);
}

// It is built anew where it stands upright on x and y, and changes where the others do.
TEST(Delaunay3Plane, ThePlaneTurns) {
  for (const std::uint64_t seed : {1u, 2u}) {
    Scene flat = reference_scene(6, 2, seed);
    flat.start = -4;
    flat.end = Rational(5);
    expect_those_of_the_plane(flat, kTurning);
    World world(in_space(flat, kTurning), "exact", AuditLevel::kNone);
    World still(in_space(flat, kFlat), "exact", AuditLevel::kNone);
    world.run();
    still.run();
    EXPECT_EQ(world.ledger().rebuilds, 2u);
    EXPECT_EQ(world.ledger().rebuild_reasons.count(
                  "in projection all points of the plane are on one line"),
              1u);
    EXPECT_EQ(plane_changes(world), plane_changes(still));
  }
  // It touches: (t^2, 0, 1), and (0, 1, 0) times the length of that would be a root.
  Turn touching = kFlat;
  touching[0] = {{{0, 0, 1}, {}, {1}}};
  Scene flat = reference_scene(6, 2, 1);
  flat.start = -2;
  flat.end = Rational(3);
  World world(in_space(flat, touching));
  world.run().expect_clean();
  EXPECT_EQ(world.ledger().rebuilds, 1u);
}

// At t = 0 all points are on a line, and the plane turns over.
TEST(Delaunay3Plane, AllMeetOnALine) {
  std::vector<Trajectory> motions;
  for (const auto& [x, slope] : {std::pair(0, 1), {3, -2}, {7, 4}, {12, -1}, {20, 3}}) {
    motions.push_back(path({{x}, {0, slope}}));
  }
  for (const Turn& turn : {kFlat, kOblique}) {
    expect_those_of_the_plane(scene_of(motions, -5, Rational(6)), turn);
    World world(in_space(scene_of(motions, -5, Rational(6)), turn), "exact", AuditLevel::kNone);
    world.run();
    EXPECT_EQ(world.ledger().rebuilds, 1u);
  }
}

// Points of {0, 1, 2}^2 with velocities in {-1, 0, 1}^2: most instants are degenerate.
void tiny_lattices(std::uint64_t first, std::uint64_t last) {
  for (std::uint64_t seed = first; seed < first + test::fewer(last - first); ++seed) {
    SCOPED_TRACE(seed);
    const Scene flat = lattice_scene(seed, 5 + static_cast<int>(seed % 5), 2);
    expect_those_of_the_plane(flat, seed % 3 == 0 ? kFlat : seed % 3 == 1 ? kOblique : kUpright);
    if (testing::Test::HasFailure()) return;
  }
}
TEST(Delaunay3Plane, TinyLattices) { tiny_lattices(0, 16); }
TEST(SlowDelaunay3Plane, TinyLattices) { tiny_lattices(16, 600); }
TEST(SlowDelaunay3Plane, TurningLattices) {
  for (std::uint64_t seed = 0; seed < test::fewer(60u); ++seed) {
    SCOPED_TRACE(seed);
    expect_those_of_the_plane(lattice_scene(seed, 5 + static_cast<int>(seed % 3), 2), kTurning);
    if (testing::Test::HasFailure()) return;
  }
}

// Seeds and sizes in which points that meet on the hull turn triangles over without a change of sign
// (delaunay_2_hull_sides_test.cpp).
TEST(Delaunay3Plane, LatticesWhosePointsMeetOnTheHull) {
  for (const auto& [seed, n] :
       {std::pair(1127u, 9), {3477u, 8}, {10941u, 8}, {14096u, 7}, {20621u, 7}}) {
    SCOPED_TRACE(seed);
    expect_those_of_the_plane(lattice_scene(seed, n, 2), kOblique);
  }
}

TEST(Delaunay3Plane, ReferenceArithmeticAgreesOnLattices) {
  for (std::uint64_t seed = 1; seed <= test::fewer(6u); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = in_space(lattice_scene(seed, 7, 2), seed % 2 == 0 ? kFlat : kTurning);
    World world(scene, "exact", AuditLevel::kNone), sturm(scene, "sturm", AuditLevel::kNone);
    world.run();
    sturm.run();
    EXPECT_EQ(world.lines(), sturm.lines());
  }
}

// Points of one line: 0, 1, 2 and 3 at x = 0, 2, 5, 9; 3 passes 2 at t = 4 and 1 at t = 7.
TEST(Delaunay3Plane, OneLine) {
  const Scene flat =
      scene_of({path({{0}, {0}}), path({{2}, {4}}), path({{5}, {10}}), path({{9, -1}, {18, -2}})},
               0, Rational(8));
  for (const Turn& turn : {kFlat, kUpright, kOblique}) {
    expect_those_of_the_plane(flat, turn);
    World world(in_space(flat, turn));
    world.run().expect_clean();
    EXPECT_EQ(world.lines(), (std::vector<std::string>{"line_pass 2 3", "line_pass 1 3"}));
    EXPECT_EQ(world.ledger().live, 3u);
  }
  // Along x in the plane; at t = -1 and 1 the line is at right angles to the axis of its order.
  Scene turning = flat;
  for (SceneObject& object : turning.objects) {
    object.motion.pieces[0].trajectory.coordinates[1] = {Rational(0)};
  }
  turning.start = -2;
  expect_those_of_the_plane(turning, kTurning);
  World world(in_space(turning, kTurning));
  world.run().expect_clean();
  EXPECT_EQ(world.ledger().rebuilds, 2u);
  EXPECT_EQ(world.count("line_pass"), 2u);
  // All pass through one place; new motions; one leaves the line.
  std::vector<Trajectory> pencil;
  for (int i = 0; i < 6; ++i) pencil.push_back(path({{0, i * i - 7}, {0}}));
  Scene scene = scene_of(pencil, -1, Rational(4));
  for (ObjectId id = 0; id < 3; ++id) {
    auto& pieces = scene.objects[id].motion.pieces;
    pieces[0].to = Rational(Integer(3), Integer(2));
    Trajectory next = path({{0, 3 - 5 * static_cast<int>(id)}, {0}});
    next = continued(pieces[0].trajectory, next, *pieces[0].to);
    pieces.push_back({pieces[0].to, std::nullopt, next});
  }
  auto& pieces = scene.objects[5].motion.pieces;
  pieces[0].to = Rational(3);
  pieces.push_back({Rational(3), std::nullopt, path({{54}, {-3, 1}})});
  World changing(in_space(scene, kUpright)), sturm(in_space(scene, kUpright), "sturm");
  changing.run().expect_clean();
  sturm.run().expect_clean();
  EXPECT_EQ(changing.lines(), sturm.lines());
  EXPECT_GT(changing.count("line_pass"), 0u);
  EXPECT_EQ(changing.ledger().live, 15u);
}

// Flight plans change in the plane; points come and go, and some fly together.
TEST(Delaunay3Plane, RandomFlights) {
  std::uint64_t updates = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(6u); ++seed) {
    SCOPED_TRACE(seed);
    const Scene flat = random_flights(seed, 8, 2, 1 + static_cast<int>(seed % 2), seed % 2 == 0);
    const Scene scene = in_space(flat, seed % 4 < 2 ? kFlat : kOblique);
    World world(scene), sturm(scene, "sturm", AuditLevel::kEnd);
    world.run().expect_clean();
    sturm.run().expect_clean();
    EXPECT_EQ(world.lines(), sturm.lines());
    updates += world.ledger().motion_updates;
  }
  EXPECT_GT(updates, test::seen_in_fewer(10u));
}

// A point comes that is outside of the plane, and goes; another one leaves the plane by a new motion.
TEST(Delaunay3Plane, APointOutside) {
  Scene scene = in_space(reference_scene(7, 2, 3), kOblique);
  SceneObject outside = test::moving("outside", path({{50, 1}, {50}, {900, -2}}));
  outside.motion.pieces[0].from = Rational(2);
  outside.motion.pieces[0].to = Rational(4);
  scene.objects.push_back(outside);
  auto& pieces = scene.objects[2].motion.pieces;
  pieces[0].to = Rational(6);
  Trajectory away = pieces[0].trajectory;
  away.coordinates[0].resize(2);
  away.coordinates[0][0] -= Rational(6);
  away.coordinates[0][1] += Rational(1);
  pieces.push_back({Rational(6), std::nullopt, path(away.coordinates)});
  World world(scene), sturm(scene, "sturm");
  world.run_until(1);
  EXPECT_TRUE(world.structure().planar());
  EXPECT_EQ(world.ledger().live, 18u);
  world.run_until(3);
  EXPECT_FALSE(world.structure().flat());
  EXPECT_FALSE(world.cells().empty());
  world.run_until(5);
  EXPECT_TRUE(world.structure().planar());
  EXPECT_EQ(world.ledger().live, 18u);
  world.run().expect_clean();
  EXPECT_FALSE(world.structure().flat());
  sturm.run().expect_clean();
  EXPECT_EQ(world.lines(), sturm.lines());
}

TEST(Delaunay3Plane, InexactArithmeticsNeverFallOver) {
  for (const char* arithmetic : {"double", "gsl", "mpfr:4", "mpfr:12", "mpfr:60"}) {
    for (std::uint64_t seed = 0; seed < test::fewer(3u); ++seed) {
      const Scene flat = lattice_scene(seed, 5 + static_cast<int>(seed % 5), 2);
      for (const Turn& turn : {kFlat, kTurning}) {
        World world(in_space(flat, turn), arithmetic, AuditLevel::kNone);
        world.run();
        EXPECT_EQ(world.status, RunStatus::kDone) << arithmetic;
      }
    }
  }
}

}  // namespace delaunay_3_plane_test
}  // namespace kinex::delaunay_3_test
