// SPDX-License-Identifier: GPL-3.0-or-later
// The minimum spanning tree in the norm of a polygon, and the cones that it is read off: each is
// audited after every instant against all pairs, and the tree against the Euclidean one.
#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "structures/proximity/cone_tree.h"
#include "tests/sanitized.h"
#include "tests/structures/metamorphic.h"
#include "tests/structures/proximity/fresh_runs.h"
#include "tests/structures/proximity/reference_scenes.h"
#include "tests/structures/proximity/twin_run.h"
#include "tests/structures/special_scenes.h"

namespace kinex::test {
namespace polygon_tree_test {

using Ids = std::vector<ObjectId>;

Request over(const char* engine, int corners) {
  Request request = ask(engine);
  Request cones = ask("cones_local");
  if (corners != 12) cones.parameters = {{"corners", Rational(corners)}};
  request.over = {cones};
  return request;
}

// Both engines, over one structure of cones.
std::vector<Request> trees(int corners) {
  return {over("mst_polygon_list", corners), over("mst_polygon_cycles", corners)};
}

// The woods of a polygon have three linear functions whose sum, suitably scaled, is zero; the norm is
// theirs in each cone, at least the Euclidean one and at most the root of the ratio times it.
TEST(PolygonTree, Frames) {
  for (const int corners : {12, 20}) {
    const ConeFrame& frame = polygon_frame(corners);
    EXPECT_EQ(frame.corners, corners);
    EXPECT_EQ(frame.counted(), static_cast<std::size_t>(corners / 2));
    EXPECT_EQ(frame.axes.size(), static_cast<std::size_t>(corners));
    EXPECT_EQ(frame.units.size(), frame.counted());
    for (const ConeFrame::Vector& axis : frame.axes) EXPECT_GT(2 * axis[0] + axis[1], 0);
    for (const auto& wood : frame.woods) {
      std::int64_t v[3][2];
      for (std::size_t i = 0; i < 3; ++i) {
        const ConeFrame::Vector& axis = frame.axes[wood[i].axis];
        for (std::size_t j = 0; j < 2; ++j) v[i][j] = wood[i].reversed ? -axis[j] : axis[j];
      }
      // Zero is inside the triangle of the three: all turns from one to the next have one sign.
      std::set<bool> turns;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto* a = v[i];
        const auto* b = v[(i + 1) % 3];
        EXPECT_NE(a[0] * b[1], a[1] * b[0]);
        turns.insert(a[0] * b[1] > a[1] * b[0]);
      }
      EXPECT_EQ(turns.size(), 1u);
    }
  }
  EXPECT_EQ(polygon_frame(12).ratio[0] * 9, polygon_frame(12).ratio[1] * 10);
  EXPECT_EQ(polygon_frame(20).ratio[0] * 25, polygon_frame(20).ratio[1] * 26);
}

// As many as another program counts, by brute force over exact positions between critical times.
TEST(PolygonTree, ReferenceCounts) {
  struct Counted {
    int n;
    std::uint64_t swaps[2], instants[2];  // 12 corners, 20 corners
  };
  for (const Counted& one : {Counted{6, {7, 7}, {7, 7}}, {8, {13, 14}, {13, 14}}}) {
    const Scene scene = reference_scene(one.n, 2, 1);
    for (const std::size_t i : {0, 1}) {
      SCOPED_TRACE(std::to_string(one.n) + " points, " + std::to_string(i));
      const std::vector<Request> requests = trees(i == 0 ? 12 : 20);
      const TwinRun run(scene, requests);
      EXPECT_EQ(run.ledger(0).external, one.swaps[i]);
      EXPECT_EQ(run.ledger(1).external, one.swaps[i]);
      std::set<std::string> instants;
      for (const std::string& line : run.changes(0)) instants.insert(line.substr(0, line.find(' ')));
      EXPECT_EQ(instants.size(), one.instants[i]);
      if (one.n > 6 || i > 0) continue;
      EXPECT_EQ(run.sink.log.lines, TwinRun(scene, requests, "sturm").sink.log.lines);
    }
  }
}

void on_lattices(std::uint64_t seeds, int corners) {
  std::uint64_t external = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(seeds); ++seed) {
    SCOPED_TRACE(seed);
    const int n = 5 + static_cast<int>(seed % 5);
    external += TwinRun(lattice_scene(seed, n, 2), trees(corners)).ledger().external;
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(external, 2 * test::seen_in_fewer(seeds));
}

TEST(PolygonTree, TinyLattices) {
  on_lattices(8, 12);
  on_lattices(3, 20);
}

TEST(SlowPolygonTree, TinyLattices) {
  on_lattices(200, 12);
  on_lattices(50, 20);
}

TEST(PolygonTree, RandomFlights) {
  std::uint64_t external = 0, updates = 0;
  for (const int degree : {1, 2, 3}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(degree == 1 ? 2u : 1u); ++seed) {
      SCOPED_TRACE("degree " + std::to_string(degree) + ", seed " + std::to_string(seed));
      const Scene scene = random_flights(seed, 6, 2, degree, seed % 2 == 0);
      const std::vector<Request> requests = trees(seed % 2 == 0 ? 20 : 12);
      const TwinRun run(scene, requests), twin(scene, requests, "sturm");
      EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
      external += run.ledger().external;
      updates += run.ledger().motion_updates;
    }
  }
  EXPECT_GT(external, test::seen_in_fewer(10u));
  EXPECT_GT(updates, test::seen_in_fewer(5u));
}

// From any rational instant on, a run goes on as a fresh one does whose scene begins there.
TEST(PolygonTree, AFreshRunFromTheMiddle) {
  FreshRuns runs;
  for (std::uint64_t seed = 1; seed <= test::fewer(2u); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = random_flights(seed, 7, 2, 2, true, plan_instants(seed));
    runs.expect_to_go_on(scene, trees(12), seed);
  }
  runs.expect_changes();
}

TEST(PolygonTree, NoPointToThree) {
  for (int n = 0; n <= 3; ++n) {
    SCOPED_TRACE(n);
    std::vector<Trajectory> t;
    for (int i = 0; i < n; ++i) t.push_back(path({{4 * i, i == 1 ? -3 : 0}, {i * i, 1 - i}}));
    Scene scene = scene_of(t, 0, Rational(3));
    scene.dimension = 2;
    const TwinRun run(scene, trees(20));
    EXPECT_EQ(run.attribute().size(), n < 2 ? 0u : 2u * static_cast<std::size_t>(n - 1));
  }
}

TEST(PolygonTree, FromNothingToNothing) {
  const TwinRun run(from_nothing_to_nothing(), trees(12));
  EXPECT_EQ(run.begins_with, Ids{});
  EXPECT_EQ(run.attribute(), Ids{});
  EXPECT_EQ(run.ledger().insertions, 7u);
}

TEST(PolygonTree, Ties) {
  std::vector<Trajectory> t;
  for (int i = 0; i < 9; ++i) t.push_back(path({{i % 3, 1}, {i / 3, 2}}));
  const TwinRun grid(scene_of(t, 0, Rational(5)), trees(12));
  EXPECT_EQ(grid.attribute().size(), 16u);
  EXPECT_EQ(grid.ledger(0).external, 0u);
  const TwinRun all(scene_of(std::vector<Trajectory>(4, path({{1, 1}, {2}})), 0, Rational(2)),
                    trees(20));
  EXPECT_EQ(all.attribute(), (Ids{0, 1, 1, 2, 2, 3}));
}

TEST(PolygonTree, PointsMeetAndJump) {
  Scene scene = scene_of({path({{0}, {0}}), path({{4}, {1}}), path({{9}, {3}}), path({{2}, {8}}),
                          path({{8, -1}, {2}}), path({{0, 1}, {2}})},
                         0, Rational(8));
  scene.jumps = true;
  jump(scene, 2, 1, path({{2}, {7}}));
  const TwinRun run(scene, trees(12));
  EXPECT_EQ(run.attribute().size(), 10u);
  // All points pass through one at t = 0.
  std::vector<Trajectory> t;
  for (int i = 0; i < 8; ++i) t.push_back(path({{0, (i * 7) % 12 - 6}, {0, (i * 5) % 12 - 5}}));
  const TwinRun meet(scene_of(t, -1, Rational(1)), trees(20));
  EXPECT_EQ(meet.attribute().size(), 14u);
}

TEST(PolygonTree, ExtremeNumbers) {
  for (const char* size : kExtremeUnits) {
    SCOPED_TRACE(size);
    const TwinRun run(in_units_of(size), trees(12));
    EXPECT_GT(run.ledger().external, 0u);
  }
}

TEST(PolygonTree, EndsInInexactArithmetics) {
  for (const char* arithmetic : {"double", "mpfr:4", "mpfr:53"}) {
    for (std::uint64_t seed = 2; seed <= 2; ++seed) {
      const TwinRun flights(random_flights(seed, 7, 2, 1, seed % 2 == 0), trees(12), arithmetic);
      const TwinRun lattice(lattice_scene(seed, 6, 2), trees(20), arithmetic);
      EXPECT_TRUE(flights.ledger().corrupt || flights.attribute().size() <= 14) << arithmetic;
    }
  }
}

// The norms differ: the edge from 0 to 1 is 316 long, 320 in the norm of 20 corners, and 333 in that of
// 12; the edge from 0 to 2 is 325 long in all of them.
TEST(PolygonTree, TheNormsDiffer) {
  Snapshot snapshot(Rational(0), 2, 2, 3);
  const int points[3][2] = {{0, 0}, {300, 100}, {325, 0}};
  for (ObjectId i = 0; i < 3; ++i) {
    for (int axis = 0; axis < 2; ++axis) snapshot.set(i, axis, Rational(points[i][axis]));
  }
  EXPECT_EQ(static_norm_tree(snapshot, 12), (Ids{0, 2, 1, 2}));
  EXPECT_EQ(static_norm_tree(snapshot, 20), (Ids{0, 1, 1, 2}));
  EXPECT_TRUE(within_ratio(snapshot, {0, 2}, {0, 1}, {11, 10}));
  EXPECT_FALSE(within_ratio(snapshot, {0, 2}, {0, 1}, {26, 25}));
  EXPECT_FALSE(within_ratio(snapshot, {0, 2}, {}, {26, 25}));
}

}  // namespace polygon_tree_test
}  // namespace kinex::test
