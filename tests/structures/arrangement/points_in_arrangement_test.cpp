// SPDX-License-Identifier: GPL-3.0-or-later
// The lines next to moving points: counts by hand, ties, crossings that pass, flight plans.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tests/sanitized.h"
#include "tests/structures/arrangement/line_scenes.h"
#include "tests/structures/arrangement/replayed_run.h"
#include "tests/structures/proximity/fresh_runs.h"

namespace kinex::test {
namespace points_in_arrangement_test {

using Ids = std::vector<ObjectId>;
using Log = std::vector<std::string>;

const std::string kName = "points_in_arrangement";

// The first objects are lines, the last one is a point.
Scene one_point(const std::vector<Trajectory>& paths, const Rational& start, const Rational& end) {
  Scene scene = scene_of(paths, start, end);
  for (std::size_t i = 0; i + 1 < paths.size(); ++i) scene.objects[i].line = true;
  return scene;
}

Log external(const Scene& scene) {
  const TwinRun run(scene, {ask(kName)});
  Log result;
  for (const std::string& line : run.sink.log.lines) {
    if (!line.starts_with(kName + " ") || !line.ends_with(" !")) continue;
    result.push_back(line.substr(kName.size() + 1, line.size() - kName.size() - 3));
  }
  return result;
}
Ids at_start(const Scene& scene) { return TwinRun(scene, {ask(kName)}).begins_with; }

// Up through two horizontal lines.
TEST(PointsInArrangement, APointPassesLines) {
  const Scene scene = one_point({path({{0}, {1}}), path({{0}, {2}}), path({{5}, {0, 1}})}, 0, 3);
  EXPECT_EQ(at_start(scene), (Ids{2, 0, 2}));
  EXPECT_EQ(external(scene), (Log{"above 2 0 1", "below 2 2 0", "above 2 1 2", "below 2 0 1"}));
}

// Along y = 0 under the crossing of y = 2 - x and y = 2 + x.
TEST(PointsInArrangement, ACrossingPassesAPoint) {
  const Scene scene = one_point({path({{-1}, {2}}), path({{1}, {2}}), path({{0, 1}, {0}})}, -1, 1);
  EXPECT_EQ(at_start(scene), (Ids{2, 1, 2}));
  EXPECT_EQ(external(scene), (Log{"above 2 1 0"}));
}

// Up through the crossing of three lines, at t = 0.
TEST(PointsInArrangement, APointPassesACrossing) {
  const Scene scene =
      one_point({path({{-1}, {0}}), path({{1}, {0}}), path({{0}, {0}}), path({{0, 3}, {0, 1}})}, -1, 1);
  EXPECT_EQ(at_start(scene), (Ids{3, 2, 1}));
  EXPECT_EQ(external(scene), (Log{"above 3 2 1", "below 3 1 2"}));
}

// The lines above it pass through each other at t = 0, with no claim about the point.
TEST(PointsInArrangement, ParallelLinesPassAboveAPoint) {
  const Scene scene =
      one_point({path({{1}, {3, 1}}), path({{1}, {3}}), path({{0}, {0}})}, -1, 1);
  EXPECT_EQ(at_start(scene), (Ids{2, 0, 2}));
  EXPECT_EQ(external(scene), (Log{"above 2 0 1"}));
}

// The point is identically on a line, and below it; of two equal lines the larger id is next to it.
TEST(PointsInArrangement, IdenticalIncidences) {
  const Scene scene =
      one_point({path({{0}, {1}}), path({{0}, {1}}), path({{0, 1}, {1}})}, 0, 3);
  EXPECT_EQ(at_start(scene), (Ids{2, 1, 2}));
  EXPECT_EQ(external(scene), Log{});
  Scene rising = one_point({path({{0}, {0}}), path({{0}, {1}}), path({{0}, {2, -1}})}, 0, 3);
  auto& pieces = rising.objects[2].motion.pieces;
  pieces[0].to = Rational(1);  // down to the line y = 1
  pieces.push_back({Rational(1), Rational(2), path({{-1, 1}, {1}})});  // along it
  pieces.push_back({Rational(2), std::nullopt, path({{1}, {-1, 1}})});  // up again
  EXPECT_EQ(external(rising), (Log{"above 2 2 1", "below 2 1 0", "above 2 1 2", "below 2 0 1"}));
}

// Each passage changes both lines next to the point.
TEST(PointsInArrangement, EveryPointIsOnEveryLineTwice) {
  for (const auto& [n, m] : {std::pair(2, 2), {3, 4}, {1, 5}}) {
    SCOPED_TRACE(std::to_string(n) + " points, " + std::to_string(m) + " lines");
    const ReplayedRun run(points_through_lines(n, m), kName);
    EXPECT_EQ(run.ledger().external, static_cast<std::uint64_t>(4 * n * m));
  }
}

// Each line exists for a while only.
TEST(PointsInArrangement, LinesComeAndGo) {
  Scene scene = one_point({path({{0}, {1}}), path({{0}, {2}}), path({{0}, {0}})}, 0, 4);
  scene.objects[0].motion.pieces[0].to = Rational(2);
  scene.objects[1].motion.pieces[0].from = Rational(1);
  const TwinRun run(scene, {ask(kName)});
  EXPECT_EQ(run.begins_with, (Ids{2, 0, 2}));
  EXPECT_EQ(run.attribute(), (Ids{2, 1, 2}));
  EXPECT_EQ(run.ledger().external, 0u);
}

TEST(PointsInArrangement, NoneToThree) {
  Scene scene = one_point({path({{0}, {1}}), path({{0}, {0}})}, 0, 1);
  scene.objects.pop_back();
  EXPECT_EQ(at_start(scene), Ids{});
  scene.objects.clear();
  EXPECT_EQ(at_start(scene), Ids{});
}

void on_lattices(std::uint64_t seeds) {
  std::uint64_t changes = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(seeds); ++seed) {
    SCOPED_TRACE(seed);
    const int n = 4 + static_cast<int>(seed % 6);
    const Scene scene = lined(lattice_scene(seed, n, 2), LineUse::kWithPoints);
    const ReplayedRun run(scene, kName, seed % 4 == 0 ? seed : 0);
    changes += run.ledger().external;
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(changes, test::seen_in_fewer(seeds));
}

TEST(PointsInArrangement, TinyLattices) { on_lattices(200); }

TEST(SlowPointsInArrangement, TinyLattices) { on_lattices(1500); }

// Lines and points come, go and change their motions; exact and sturm agree line by line.
TEST(PointsInArrangement, RandomFlights) {
  std::uint64_t changes = 0;
  for (const int degree : {1, 2, 3}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(degree == 1 ? 12u : 3u); ++seed) {
      SCOPED_TRACE("degree " + std::to_string(degree) + ", seed " + std::to_string(seed));
      const Scene scene = lined(random_flights(seed, 8, 2, degree, seed % 2 == 0), LineUse::kWithPoints);
      const TwinRun run(scene, {ask(kName)}), twin(scene, {ask(kName)}, "sturm");
      EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
      const ReplayedRun replayed(scene, kName);
      changes += run.ledger().external;
    }
  }
  EXPECT_GT(changes, test::seen_in_fewer(60u));
}

// From any rational instant on, a run goes on as a fresh one does whose scene begins there.
TEST(PointsInArrangement, AFreshRunFromTheMiddle) {
  FreshRuns runs;
  for (std::uint64_t seed = 1; seed <= test::fewer(6u); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene =
        lined(random_flights(seed, 9, 2, 2, true, plan_instants(seed)), LineUse::kWithPoints);
    runs.expect_to_go_on(scene, {ask(kName)}, seed);
  }
  runs.expect_changes();
}

}  // namespace points_in_arrangement_test
}  // namespace kinex::test
