// SPDX-License-Identifier: GPL-3.0-or-later
// The arrangement of moving lines: counts by hand and by brute force, ties, many lines in a point,
// lines that are parallel for an instant or identically, flight plans.
#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tests/sanitized.h"
#include "tests/structures/arrangement/line_scenes.h"
#include "tests/structures/arrangement/replayed_run.h"
#include "tests/structures/proximity/fresh_runs.h"

namespace kinex::test {
namespace line_arrangement_test {

using Ids = std::vector<ObjectId>;
using Log = std::vector<std::string>;

std::vector<Request> arrangement() { return {ask("line_arrangement_2")}; }

Scene lines(const std::vector<Trajectory>& paths, const Rational& start, const Rational& end) {
  return lined(scene_of(paths, start, end), LineUse::kAlone);
}

ReplayedRun replayed(const Scene& scene, std::uint64_t rebuild_seed = 0) {
  return ReplayedRun(scene, "line_arrangement_2", rebuild_seed);
}

// The events of a run, without the structure's name.
Log events(const Scene& scene) {
  const TwinRun run(scene, arrangement());
  Log result;
  for (const std::string& line : run.sink.log.lines) result.push_back(line.substr(19));
  return result;
}
Log external(const Scene& scene) {
  Log result = events(scene);
  std::erase_if(result, [](const std::string& line) { return !line.ends_with(" !"); });
  for (std::string& line : result) line.resize(line.size() - 2);
  return result;
}
Ids at_start(const Scene& scene) { return TwinRun(scene, arrangement()).begins_with; }

// y = -x and y = x, and a horizontal line that rises through their crossing at t = 1.
TEST(LineArrangement, ATriangleTurnsOver) {
  const Scene scene = lines({path({{-1}, {0}}), path({{0}, {-1, 1}}), path({{1}, {0}})}, 0, 2);
  EXPECT_EQ(at_start(scene), (Ids{0, 1, 2, 0, 2, 1, 1, 2, 0, 2, 1, 0}));
  EXPECT_EQ(external(scene), (Log{"triple 0 1 2"}));
  const TwinRun run(scene, arrangement());
  EXPECT_EQ(run.attribute(), (Ids{0, 1, 2, 0, 1, 2, 1, 0, 2, 2, 0, 1}));
  EXPECT_EQ(run.ledger().failures, 3u);  // one on each line
  EXPECT_EQ(run.ledger().max_live, 5u);  // n^2 - n - 1
}

// A line turns over, and passes the slope of another one at t = 1.
TEST(LineArrangement, TwoLinesAreParallelForAnInstant) {
  const Scene scene = lines({path({{0}, {0}}), path({{-1, 1}, {1}}), path({{5}, {-3}})}, 0, 2);
  EXPECT_EQ(at_start(scene), (Ids{1, 0, 2, 0, 2, 1, 1, 2, 0, 2, 0, 1}));
  EXPECT_EQ(events(scene), (Log{"parallel 0 1 !"}));
  EXPECT_EQ(TwinRun(scene, arrangement()).attribute(), (Ids{0, 1, 2, 0, 1, 2, 1, 0, 2, 2, 0, 1}));
}

// Two lines pass through each other at t = 1, and a third one crosses both.
TEST(LineArrangement, ParallelLinesPassThroughEachOther) {
  const Scene scene = lines({path({{2}, {0, 1}}), path({{2}, {1}}), path({{0}, {0}})}, 0, 2);
  EXPECT_EQ(at_start(scene), (Ids{2, 1, 0, 1, 0, 2, 0, 1, 2, 2, 1, 0}));
  EXPECT_EQ(external(scene), (Log{"triple 0 1 2", "equal 0 1"}));
  EXPECT_EQ(TwinRun(scene, arrangement()).attribute(), (Ids{2, 0, 1, 1, 0, 2, 0, 1, 2, 2, 0, 1}));
}

// A line turns past two that are parallel identically, at t = 1: on it they change places.
TEST(LineArrangement, ALineTurnsPastParallels) {
  const Scene scene =
      lines({path({{0, 1}, {0}}), path({{1}, {2}}), path({{1}, {1}}), path({{-1}, {0}})}, 0, 2);
  const Log expected{"triple 0 1 2", "parallel 0 1", "parallel 0 2"};
  EXPECT_EQ(external(scene), expected);
  ReplayedRun run = replayed(scene);
  EXPECT_EQ(run.count("triple") + run.count("parallel"), 3u);
}

// k lines through one point at t = 0, which all turn over: y = i x + i^2 t.
TEST(LineArrangement, ManyLinesInAPoint) {
  for (const int k : {3, 4, 5, 7}) {
    SCOPED_TRACE(k);
    std::vector<Trajectory> paths;
    for (int i = 0; i < k; ++i) paths.push_back(path({{i}, {0, i * i}}));
    ReplayedRun run = replayed(lines(paths, -1, 1));
    const auto triples = static_cast<std::uint64_t>(k * (k - 1) * (k - 2) / 6);
    EXPECT_EQ(run.count("triple"), triples);
    EXPECT_EQ(run.ledger().external, triples);
    EXPECT_EQ(run.ledger().failures, 3 * triples);
    EXPECT_EQ(run.ledger().simultaneous_groups, 1u);
  }
}

// All slopes are equal at t = 0: y = i t x + i^2. All lists are turned round.
TEST(LineArrangement, AllLinesAreParallelForAnInstant) {
  for (const int n : {2, 3, 6}) {
    SCOPED_TRACE(n);
    std::vector<Trajectory> paths;
    for (int i = 0; i < n; ++i) paths.push_back(path({{0, i}, {i * i}}));
    ReplayedRun run = replayed(lines(paths, -1, 1));
    EXPECT_EQ(run.count("parallel"), static_cast<std::uint64_t>(n * (n - 1) / 2));
    // The triangle with the slopes i t and heights i^2 has t times a constant as orientation.
    EXPECT_EQ(run.count("triple"), static_cast<std::uint64_t>(n * (n - 1) * (n - 2) / 6));
  }
}

// All lines coincide at t = 0: y = i t x + i^2 t. No crossing moves.
TEST(LineArrangement, AllLinesCoincideForAnInstant) {
  std::vector<Trajectory> paths;
  for (int i = 0; i < 6; ++i) paths.push_back(path({{0, i}, {0, i * i}}));
  ReplayedRun run = replayed(lines(paths, -1, 1));
  EXPECT_EQ(run.count("parallel"), 15u);
  EXPECT_EQ(run.count("triple"), 0u);
  EXPECT_EQ(run.count("settled"), 0u);
}

// Three lines meet identically; the smallest id is the highest. Line 0 turns past the others.
TEST(LineArrangement, IdenticalTriples) {
  const Scene still = lines({path({{0}, {0}}), path({{-1}, {0}}), path({{1}, {0}})}, 0, 1);
  // Raised, the horizontal line crosses y = -x to the left of the origin, and y = x to the right.
  EXPECT_EQ(at_start(still), (Ids{1, 0, 2, 0, 1, 2, 1, 0, 2, 2, 1, 0}));
  EXPECT_EQ(external(still), Log{});
  // From slope 0 to slope 2, above the slope of line 2 at t = 1/2: then it meets it below line 1.
  const Scene turning = lines({path({{0, 2}, {0}}), path({{-1}, {0}}), path({{1}, {0}})}, 0, 1);
  EXPECT_EQ(external(turning), (Log{"parallel 0 2"}));
  EXPECT_EQ(replayed(turning).count("parallel"), 1u);
}

struct Plan {  // two pieces that meet at t = 1
  Trajectory first, second;
};

Scene planned(const std::vector<Plan>& plans, const Rational& end) {
  Scene scene;
  scene.name = "plans";
  scene.dimension = 2;
  scene.start = 0;
  scene.end = end;
  for (const Plan& plan : plans) {
    scene.objects.push_back(moving(name_of(scene.objects.size()), plan.first));
    scene.objects.back().motion.pieces[0].to = Rational(1);
    scene.objects.back().motion.pieces.push_back({Rational(1), std::nullopt, plan.second});
  }
  return lined(std::move(scene), LineUse::kAlone);
}

// Parallel identically from t = 1 on.
TEST(LineArrangement, LinesBecomeParallel) {
  const Trajectory still = path({{1}, {0}}), third = path({{-1}, {4}});
  const Scene scene = planned({{still, still}, {path({{0, 1}, {2}}), path({{1}, {2}})}, {third, third}}, 2);
  EXPECT_EQ(external(scene), (Log{"settled"}));
  const TwinRun run(scene, arrangement());
  EXPECT_EQ(run.attribute(), (Ids{2, 1, 0, 1, 0, 2, 0, 1, 2, 2, 1, 0}));
  EXPECT_EQ(run.ledger().live, 1u + 2u);  // slopes, and two crossings of line 2
  EXPECT_EQ(replayed(scene).count("settled"), 1u);
}

TEST(LineArrangement, ParallelLinesCross) {
  const Trajectory still = path({{1}, {0}}), third = path({{-1}, {4}});
  const Scene scene = planned({{still, still}, {path({{1}, {2}}), path({{0, 1}, {2}})}, {third, third}}, 2);
  EXPECT_EQ(external(scene), (Log{"settled"}));
  EXPECT_EQ(replayed(scene).count("settled"), 1u);
}

// Two that coincide identically move apart: the one that was behind becomes the higher one.
TEST(LineArrangement, EqualLinesPart) {
  const Trajectory both = path({{1}, {0, 1}}), third = path({{-1}, {4}});
  const Scene scene =
      planned({{both, path({{1}, {2, -1}})}, {both, both}, {third, third}}, 2);
  EXPECT_EQ(at_start(scene), (Ids{2, 0, 1, 1, 0, 2, 0, 1, 2, 2, 0, 1}));
  EXPECT_EQ(external(scene), (Log{"triple 0 1 2", "equal 0 1"}));
  ReplayedRun run = replayed(scene);
  EXPECT_EQ(run.count("equal"), 1u);
}

struct Counted {
  int n;
  std::uint64_t seed;
  std::uint64_t triples, parallels;
};

// Sign changes in 0 < t < 10 of the orientations of all triples and of the slopes of all pairs, found
// by another program.
TEST(LineArrangement, ReferenceCounts) {
  for (const Counted& one :
       {Counted{6, 1, 21, 8}, {8, 1, 42, 14}, {10, 2, 86, 20}, {12, 3, 113, 12}}) {
    if (test::kSanitized && one.n > 8) break;
    SCOPED_TRACE(one.n);
    const Scene scene = line_reference(one.n, one.seed, LineUse::kAlone);
    const TwinRun run(scene, arrangement()), twin(scene, arrangement(), "sturm");
    ReplayedRun again = replayed(scene);
    EXPECT_EQ(again.count("triple"), one.triples);
    EXPECT_EQ(again.count("parallel"), one.parallels);
    EXPECT_EQ(run.ledger().external, one.triples + one.parallels);
    EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
  }
}

void on_lattices(std::uint64_t seeds) {
  std::uint64_t triples = 0, parallels = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(seeds); ++seed) {
    SCOPED_TRACE(seed);
    const int n = 5 + static_cast<int>(seed % 5);
    const Scene scene = lined(lattice_scene(seed, n, 2), LineUse::kAlone);
    ReplayedRun run = replayed(scene, seed % 4 == 0 ? seed : 0);
    triples += run.count("triple");
    parallels += run.count("parallel");
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(triples, test::seen_in_fewer(seeds));
  EXPECT_GT(parallels, test::seen_in_fewer(seeds));
}

TEST(LineArrangement, TinyLattices) { on_lattices(90); }

TEST(SlowLineArrangement, TinyLattices) { on_lattices(1500); }

// Lines come, go and change their motions; exact and sturm agree line by line.
TEST(LineArrangement, RandomFlights) {
  std::uint64_t externals = 0, updates = 0;
  for (const int degree : {1, 2, 3, 4}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(degree == 1 ? 12u : 3u); ++seed) {
      SCOPED_TRACE("degree " + std::to_string(degree) + ", seed " + std::to_string(seed));
      const Scene scene = lined(random_flights(seed, 6, 2, degree, seed % 2 == 0), LineUse::kAlone);
      const TwinRun run(scene, arrangement()), twin(scene, arrangement(), "sturm");
      EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
      replayed(scene);
      externals += run.ledger().external;
      updates += run.ledger().motion_updates;
    }
  }
  EXPECT_GT(externals, test::seen_in_fewer(100u));
  EXPECT_GT(updates, test::seen_in_fewer(60u));
}

// From any rational instant on, a run goes on as a fresh one does whose scene begins there.
TEST(LineArrangement, AFreshRunFromTheMiddle) {
  FreshRuns runs;
  for (std::uint64_t seed = 1; seed <= test::fewer(6u); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene =
        lined(random_flights(seed, 7, 2, 2, true, plan_instants(seed)), LineUse::kAlone);
    runs.expect_to_go_on(scene, arrangement(), seed);
  }
  runs.expect_changes();
}

// Each of the k^3 triples of a line of each kind turns over once, at a time of its own.
TEST(LineArrangement, EveryTripleOfThreeKindsOfLines) {
  for (const int k : {2, 3}) {
    SCOPED_TRACE(k);
    ReplayedRun run = replayed(three_bundles(k));
    const auto triples = static_cast<std::uint64_t>(k * k * k);
    EXPECT_EQ(run.count("triple"), triples);
    EXPECT_EQ(run.ledger().external, triples);
    EXPECT_EQ(run.ledger().failures, 3 * triples);
    EXPECT_EQ(run.ledger().simultaneous_groups, triples);
  }
}

// Both hard bounds: every triple turns over twice, every two slopes are equal once.
TEST(LineArrangement, TheMostEvents) {
  for (const int n : {3, 4, 7}) {
    SCOPED_TRACE(n);
    const Scene scene = most_crossings(n);
    ReplayedRun run = replayed(scene);
    for (const BoundCheck& bound : run.bounds()) {
      if (bound.id.ends_with("locality")) continue;
      EXPECT_EQ(bound.observed, bound.bound) << bound.id;
    }
    EXPECT_EQ(run.count("triple"), static_cast<std::uint64_t>(n * (n - 1) * (n - 2) / 3));
    EXPECT_EQ(run.count("parallel"), static_cast<std::uint64_t>(n * (n - 1) / 2));
    if (n > 4) continue;
    EXPECT_EQ(TwinRun(scene, arrangement()).sink.log.lines,
              TwinRun(scene, arrangement(), "sturm").sink.log.lines);
  }
}

TEST(LineArrangement, NoneToThree) {
  Scene scene = lines({path({{-1}, {0}}), path({{0}, {-1, 1}}), path({{1}, {0}})}, 0, 2);
  scene.objects.pop_back();
  EXPECT_EQ(at_start(scene), (Ids{0, 1, 0, 1, 1, 0}));
  EXPECT_EQ(external(scene), Log{});
  scene.objects.pop_back();
  EXPECT_EQ(at_start(scene), (Ids{0, 0}));
  scene.objects.clear();
  EXPECT_EQ(at_start(scene), Ids{});
}

}  // namespace line_arrangement_test
}  // namespace kinex::test
