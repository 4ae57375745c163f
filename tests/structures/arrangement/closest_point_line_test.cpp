// SPDX-License-Identifier: GPL-3.0-or-later
// The line and the point that are closest to each other: counts by hand and by brute force, ties, flight
// plans. Every run is audited against all pairs.
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
namespace closest_point_line_test {

using Ids = std::vector<ObjectId>;

constexpr const char* kEuclidean = "closest_point_line";
constexpr const char* kVertical = "closest_point_line_vertical";

// All lines have one slope at a time, so both distances have one order. Every pair is the closest in turn,
// twice: while t^2 is nearest to j + i / (n + 1).
TEST(ClosestPointLine, EveryPairInTurn) {
  for (const auto& [n, m] : {std::pair(2, 2), {3, 4}, {1, 5}, {5, 1}}) {
    SCOPED_TRACE(std::to_string(n) + " points, " + std::to_string(m) + " lines");
    const Scene scene = points_through_lines(n, m);
    const std::vector<Request> both{ask(kEuclidean), ask(kVertical)};
    const TwinRun run(scene, both), twin(scene, both, "sturm");
    EXPECT_EQ(run.ledger().external, static_cast<std::uint64_t>(2 * (n * m - 1)));
    EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
  }
}

struct Counted {
  int n;
  std::uint64_t seed, euclidean, vertical;
};

// The closest pairs between all roots of the polynomials of two pairs, by another program.
TEST(ClosestPointLine, ReferenceCounts) {
  for (const Counted& one :
       {Counted{6, 1, 7, 10}, {8, 1, 16, 17}, {10, 2, 24, 23}, {12, 3, 36, 42}}) {
    SCOPED_TRACE(one.n);
    const Scene scene = line_reference(one.n, one.seed, LineUse::kWithPoints);
    const TwinRun run(scene, {ask(kEuclidean)}), vertical(scene, {ask(kVertical)});
    EXPECT_EQ(run.ledger().external, one.euclidean);
    EXPECT_EQ(vertical.ledger().external, one.vertical);
    if (one.n <= 8) {
      const TwinRun twin(scene, {ask(kEuclidean)}, "sturm");
      EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
    }
  }
}

void on_lattices(std::uint64_t seeds) {
  std::uint64_t external = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(seeds); ++seed) {
    SCOPED_TRACE(seed);
    const int n = 5 + static_cast<int>(seed % 5);
    const Scene scene = lined(lattice_scene(seed, n, 2), LineUse::kWithPoints);
    for (const char* const name : {kEuclidean, kVertical}) {
      ReplayedRun run(scene, name, seed % 4 == 0 ? seed : 0);
      external += run.ledger().external;
    }
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(external, test::seen_in_fewer(seeds));
}

TEST(ClosestPointLine, TinyLattices) { on_lattices(30); }

TEST(SlowClosestPointLine, TinyLattices) { on_lattices(1000); }

// Lines and points come, go and change their motions.
TEST(ClosestPointLine, RandomFlights) {
  std::uint64_t external = 0, updates = 0;
  for (const int degree : {1, 2, 3}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(degree == 1 ? 8u : 2u); ++seed) {
      SCOPED_TRACE("degree " + std::to_string(degree) + ", seed " + std::to_string(seed));
      const Scene scene =
          lined(random_flights(seed, 7, 2, degree, seed % 2 == 0), LineUse::kWithPoints);
      for (const char* const name : {kEuclidean, kVertical}) {
        const TwinRun run(scene, {ask(name)}), twin(scene, {ask(name)}, "sturm");
        EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
        external += run.ledger().external;
        updates += run.ledger().motion_updates;
      }
    }
  }
  EXPECT_GT(external, test::seen_in_fewer(60u));
  EXPECT_GT(updates, test::seen_in_fewer(40u));
}

// From any rational instant on, a run goes on as a fresh one does whose scene begins there.
TEST(ClosestPointLine, AFreshRunFromTheMiddle) {
  FreshRuns runs;
  for (std::uint64_t seed = 2; seed <= 1 + test::fewer(4u); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene =
        lined(random_flights(seed, 7, 2, 1, true, plan_instants(seed)), LineUse::kWithPoints);
    runs.expect_to_go_on(scene, {ask(kEuclidean)}, seed);
  }
  runs.expect_changes();
}

Scene lines_first(std::vector<Trajectory> paths, std::size_t lines, int end = 4) {
  Scene scene = scene_of(std::move(paths), 0, Rational(end));
  scene.dimension = 2;
  for (std::size_t i = 0; i < lines; ++i) scene.objects[i].line = true;
  return scene;
}

// y = 7 x and y = 0: (0, 3) is 3 above both, but 3 / sqrt(50) from the first; (9, 1) is 1 above the second.
TEST(ClosestPointLine, SteepLinesAreNear) {
  const Scene scene =
      lines_first({path({{7}, {0}}), path({{0}, {0}}), path({{0}, {3}}), path({{9}, {1}})}, 2);
  EXPECT_EQ(TwinRun(scene, {ask(kEuclidean)}).attribute(), (Ids{0, 2}));
  EXPECT_EQ(TwinRun(scene, {ask(kVertical)}).attribute(), (Ids{1, 3}));
}

TEST(ClosestPointLine, WithoutLinesOrPoints) {
  EXPECT_EQ(TwinRun(lines_first({}, 0), {ask(kEuclidean)}).attribute(), Ids{});
  EXPECT_EQ(
      TwinRun(lines_first({path({{1}, {1}}), path({{2}, {1}})}, 2), {ask(kEuclidean)}).attribute(),
      Ids{});
  EXPECT_EQ(TwinRun(lines_first({path({{1}, {1, 1}}), path({{2}, {1}})}, 1), {ask(kEuclidean)})
                .attribute(),
            (Ids{0, 1}));
}

// A point that passes a line is at distance 0 for an instant: no event, if the pair was the closest.
TEST(ClosestPointLine, APassageIsNoChange) {
  const Scene scene =
      lines_first({path({{0}, {0}}), path({{0, 1}, {-2, 1}}), path({{50}, {9}})}, 1);
  const TwinRun run(scene, {ask(kEuclidean)});
  EXPECT_EQ(run.attribute(), (Ids{0, 1}));
  EXPECT_EQ(run.ledger().failures, 0u);
}

// Points that are identically on lines, and points at identically equal distances: the smallest pair. New
// flight plans make and end ties.
TEST(ClosestPointLine, Ties) {
  for (const char* const name : {kEuclidean, kVertical}) {
    SCOPED_TRACE(name);
    // y = x and y = x + 2 with points on them, a point between them, and one that comes down to y = x.
    Scene scene = lines_first({path({{1}, {0}}), path({{1}, {2}}), path({{0, 1}, {2, 1}}),
                               path({{3, 1}, {4, 1}}), path({{0}, {8, -4}})},
                              2, 8);
    EXPECT_EQ(TwinRun(scene, {ask(name)}).begins_with, (Ids{1, 2}));
    auto& pieces = scene.objects[4].motion.pieces;
    pieces[0].to = Rational(2);
    pieces.push_back({Rational(2), Rational(4), path({{-2, 1}, {-2, 1}})});
    pieces.push_back({Rational(4), std::nullopt, path({{2}, {-2, 1}})});
    const TwinRun run(scene, {ask(name)});
    std::vector<std::string> changes = run.changes(0);
    for (std::string& line : changes) line.erase(0, line.find(' ') + 1);  // the instant
    EXPECT_EQ(changes, (std::vector<std::string>{"-1 -2 +0 +4", "-0 -4 +1 +2"}));
    // Without the points on lines: 3 is as far from 0 as from 1.
    const Scene between = lines_first(
        {path({{1}, {0}}), path({{1}, {2}}), path({{0, 1}, {9, 1}}), path({{3, 1}, {4, 1}})}, 2);
    EXPECT_EQ(TwinRun(between, {ask(name)}).attribute(), (Ids{0, 3}));
  }
}

TEST(ClosestPointLine, InexactRunsEnd) {
  for (const char* const arithmetic : {"double", "gsl", "mpfr:4", "mpfr:53"}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(4u); ++seed) {
      const Scene scene = lined(lattice_scene(seed, 8, 2), LineUse::kWithPoints);
      const TwinRun run(scene, {ask(kEuclidean)}, arithmetic);
      EXPECT_TRUE(run.ledger().corrupt || run.attribute().size() == 2) << arithmetic;
    }
  }
}

}  // namespace closest_point_line_test
}  // namespace kinex::test
