// SPDX-License-Identifier: GPL-3.0-or-later
// The vertical decomposition of moving lines: counts by hand, walls that pass, ties, many lines in a
// point, lines that are parallel for an instant or identically, flight plans.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "structures/arrangement/trapezoids_2.h"
#include "tests/sanitized.h"
#include "tests/structures/arrangement/line_scenes.h"
#include "tests/structures/arrangement/replayed_run.h"
#include "tests/structures/proximity/fresh_runs.h"

namespace kinex::test {
namespace trapezoids_test {

using Ids = std::vector<ObjectId>;
using Log = std::vector<std::string>;

const std::string kName = "trapezoids_2";

std::vector<Request> trapezoids() { return {ask(kName)}; }

Scene lines(const std::vector<Trajectory>& paths, const Rational& start, const Rational& end) {
  return lined(scene_of(paths, start, end), LineUse::kAlone);
}

// The events of a run, without the structure's name.
Log events(const Scene& scene) {
  const TwinRun run(scene, trapezoids());
  Log result;
  for (const std::string& line : run.sink.log.lines) {
    if (line.starts_with(kName + " ")) result.push_back(line.substr(kName.size() + 1));
  }
  return result;
}
Log external(const Scene& scene) {
  Log result = events(scene);
  std::erase_if(result, [](const std::string& line) { return !line.ends_with(" !"); });
  for (std::string& line : result) line.resize(line.size() - 2);
  return result;
}
Ids at_start(const Scene& scene) { return TwinRun(scene, trapezoids()).begins_with; }

std::size_t count_of(const TwinRun& run) {
  return dynamic_cast<const Trapezoids2&>(run.simulator.structure(run.ids[0])).trapezoids();
}

// y = -x and y = x, and a horizontal line that rises through their crossing at t = 1.
TEST(Trapezoids, ATriangleTurnsOver) {
  const Scene scene = lines({path({{-1}, {0}}), path({{0}, {-1, 1}}), path({{1}, {0}})}, 0, 2);
  // From the crossing of 0 and 2 a wall goes down to 1; those at the ends of 1 go on and on.
  EXPECT_EQ(at_start(scene), (Ids{0, 1, 2, 0, 0, 2, 0, 1, 1, 2, 0, 1}));
  const TwinRun run(scene, trapezoids());
  EXPECT_EQ(run.attribute(), (Ids{0, 1, 0, 2, 0, 2, 1, 0, 1, 2, 1, 0}));
  EXPECT_EQ(external(scene), (Log{"wall_up 0 1 2 0", "wall_down 0 1 0 2", "wall_up 0 2 0 1",
                                  "wall_down 0 2 1 0", "wall_up 1 2 0 1", "wall_down 1 2 1 0"}));
  EXPECT_EQ(run.ledger().failures, 0u);  // they are those of line_arrangement_2
}

// Above y = |x| - 1 and below y = 20 - 2 |x - t|: the two corners pass each other at t = 0.
TEST(Trapezoids, WallsPassEachOther) {
  const Scene scene = lines({path({{1}, {-1}}), path({{-1}, {-1}}), path({{-2}, {20, 2}}),
                             path({{2}, {20, -2}})},
                            -1, 1);
  // 0 and 1 cross at (0, -1), below 2 and 3, which cross at (t, 20).
  EXPECT_EQ(events(scene), (Log{"wall_pass 2 3 0 1", "wall_up 0 1 2 3 !", "wall_down 2 3 1 0 !"}));
  const TwinRun run(scene, trapezoids());
  EXPECT_EQ(run.ledger().failures, 1u);
  EXPECT_EQ(run.ledger().simultaneous_groups, 0u);
}

// A line turns over, and passes the slope of another one at t = 1: their crossing comes from the right.
TEST(Trapezoids, TwoLinesAreParallelForAnInstant) {
  const Scene scene = lines({path({{0}, {0}}), path({{-1, 1}, {1}}), path({{5}, {-3}})}, 0, 2);
  EXPECT_EQ(at_start(scene), (Ids{0, 1, 2, 0, 0, 2, 1, 0, 1, 2, 1, 0}));
  EXPECT_EQ(TwinRun(scene, trapezoids()).attribute(), (Ids{0, 1, 0, 2, 0, 2, 1, 0, 1, 2, 1, 0}));
  EXPECT_EQ(external(scene), (Log{"wall_up 0 1 2 0", "wall_down 0 1 0 2"}));
}

// Lines 0 and 1 pass through each other above a crossing of others, with no claim about it.
TEST(Trapezoids, ParallelLinesPassAboveACrossing) {
  const Scene scene = lines({path({{0}, {10, 1}}), path({{0}, {10}}), path({{1}, {0}}),
                             path({{-1}, {0}})},
                            -1, 1);
  const Log log = external(scene);
  EXPECT_NE(std::find(log.begin(), log.end(), "wall_up 2 3 0 1"), log.end());
  EXPECT_EQ(TwinRun(scene, trapezoids()).attribute().size(), 4u * 5u);
}

// 3 C(n,2) + n + 1 if no two lines are parallel; a pair of parallels has none of three.
TEST(Trapezoids, Counts) {
  for (const std::size_t n : {1, 2, 3, 4, 6, 9, 12}) {
    if (test::kSanitized && n > 9) break;
    SCOPED_TRACE(n);
    Random random(7 + n);
    std::vector<Trajectory> paths;
    for (std::size_t i = 0; i < n; ++i) paths.push_back(random.small_path(2, 1, 3000));
    EXPECT_EQ(count_of(TwinRun(lines(paths, 0, 1), trapezoids())),
              3 * n * (n - 1) / 2 + n + 1);
  }
  for (const int k : {1, 2, 3}) {
    SCOPED_TRACE(k);
    const auto crossings = static_cast<std::size_t>(3 * k * k), n = static_cast<std::size_t>(3 * k);
    EXPECT_EQ(count_of(TwinRun(three_bundles(k), trapezoids())), 3 * crossings + n + 1);
  }
}

// k lines through one point at t = 0, which all turn over: y = i x + i^2 t.
TEST(Trapezoids, ManyLinesInAPoint) {
  for (const int k : {3, 4, 5, 7}) {
    SCOPED_TRACE(k);
    std::vector<Trajectory> paths;
    for (int i = 0; i < k; ++i) paths.push_back(path({{i}, {0, i * i}}));
    const ReplayedRun run(lines(paths, -1, 1), kName);
    EXPECT_GT(run.ledger().external, 0u);
    EXPECT_EQ(run.simulator.ledger().instants, 1u);
  }
}

// All slopes are equal at t = 0: y = i t x + i^2.
TEST(Trapezoids, AllLinesAreParallelForAnInstant) {
  for (const int n : {2, 3, 6}) {
    SCOPED_TRACE(n);
    std::vector<Trajectory> paths;
    for (int i = 0; i < n; ++i) paths.push_back(path({{0, i}, {i * i}}));
    const ReplayedRun run(lines(paths, -1, 1), kName);
  }
}

// All lines coincide at t = 0: y = i t x + i^2 t. No crossing moves, but above is below.
TEST(Trapezoids, AllLinesCoincideForAnInstant) {
  std::vector<Trajectory> paths;
  for (int i = 0; i < 6; ++i) paths.push_back(path({{0, i}, {0, i * i}}));
  const ReplayedRun run(lines(paths, -1, 1), kName);
  EXPECT_GT(run.ledger().external, 0u);
}

// The crossing of 2 and 3 is above that of 0 and 1 identically. If 0 is raised the latter goes to the left
// if 0 is the steeper line, else to the right; the wall from above ends on 0.
TEST(Trapezoids, IdenticalX) {
  for (const bool steep : {false, true}) {
    SCOPED_TRACE(steep);
    const int s = steep ? 1 : -1;
    const Scene scene = lines({path({{s}, {-1}}), path({{-s}, {-1}}), path({{-2}, {20, 1}}),
                               path({{2}, {20, 1}})},
                              0, 1);
    EXPECT_EQ(events(scene), Log{});
    EXPECT_EQ(at_start(scene)[2], steep ? 3u : 2u);
    EXPECT_EQ(at_start(scene)[23], 0u);
  }
}

// Crossings that come above each other with a new motion, and stay: the tie-break may turn them round.
TEST(Trapezoids, ATieComesWithANewMotion) {
  for (const int from : {-1, 1}) {
    SCOPED_TRACE(from);
    Scene scene;
    scene.name = "plans";
    scene.dimension = 2;
    scene.start = 0;
    scene.end = 3;
    for (const Trajectory& still : {path({{1}, {-1}}), path({{-1}, {-1}})}) {
      scene.objects.push_back(moving(name_of(scene.objects.size()), still));
    }
    // They cross at x = from (1 - t) until t = 1, and at x = 0 from then on.
    for (const int slope : {-2, 2}) {
      scene.objects.push_back(moving(name_of(scene.objects.size()),
                                     path({{slope}, {20 - slope * from, slope * from}})));
      auto& pieces = scene.objects.back().motion.pieces;
      pieces[0].to = Rational(1);
      pieces.push_back({Rational(1), std::nullopt, path({{slope}, {20}})});
    }
    const ReplayedRun run(lined(scene, LineUse::kAlone), kName);
    // Identically the crossing of 0 and 1, raised by 0, is the left one.
    EXPECT_EQ(run.ledger().external, from == -1 ? 2u : 0u);
  }
}

// Parallel identically from t = 1 on, or until then.
TEST(Trapezoids, LinesBecomeParallel) {
  const Trajectory still = path({{1}, {0}}), third = path({{-1}, {4}}), fourth = path({{3}, {-7}});
  for (const bool later : {false, true}) {
    SCOPED_TRACE(later);
    const Trajectory turning = later ? path({{0, 1}, {2}}) : path({{1}, {2}});
    const Trajectory then = later ? path({{1}, {2}}) : path({{0, 1}, {2}});
    Scene scene = lines({still, turning, third, fourth}, 0, 2);
    auto& pieces = scene.objects[1].motion.pieces;
    pieces[0].to = Rational(1);
    pieces.push_back({Rational(1), std::nullopt, then});
    ReplayedRun run(scene, kName);
    EXPECT_EQ(run.count("settled"), 2u);  // one of each structure
    EXPECT_EQ(TwinRun(scene, trapezoids()).attribute().size(), later ? 20u : 24u);
  }
}

struct Counted {
  int n;
  std::uint64_t seed;
  std::uint64_t external;
};

// Lines above and below crossings that are others on both sides of an instant, of all instants in
// 0 < t < 10 at which any polynomial of two, three or four lines is zero, found by another program.
TEST(Trapezoids, ReferenceCounts) {
  for (const Counted& one : {Counted{6, 1, 182}, {8, 1, 414}, {10, 2, 830}}) {
    if (test::kSanitized && one.n > 6) break;
    SCOPED_TRACE(one.n);
    const Scene scene = line_reference(one.n, one.seed, LineUse::kAlone);
    const TwinRun run(scene, trapezoids()), twin(scene, trapezoids(), "sturm");
    EXPECT_EQ(run.ledger().external, one.external);
    EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
    const ReplayedRun again(scene, kName);
  }
}

void on_lattices(std::uint64_t seeds) {
  std::uint64_t changes = 0, passes = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(seeds); ++seed) {
    SCOPED_TRACE(seed);
    const int n = 5 + static_cast<int>(seed % 5);
    const Scene scene = lined(lattice_scene(seed, n, 2), LineUse::kAlone);
    ReplayedRun run(scene, kName, seed % 4 == 0 ? seed : 0);
    changes += run.ledger().external;
    passes += run.count("wall_pass");
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(changes, 10 * test::seen_in_fewer(seeds));
  EXPECT_GT(passes, test::seen_in_fewer(seeds));
}

TEST(Trapezoids, TinyLattices) { on_lattices(80); }

TEST(SlowTrapezoids, TinyLattices) { on_lattices(600); }

// Lines come, go and change their motions; exact and sturm agree line by line.
TEST(Trapezoids, RandomFlights) {
  std::uint64_t externals = 0, updates = 0;
  for (const int degree : {1, 2, 3, 4}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(degree == 1 ? 12u : 3u); ++seed) {
      SCOPED_TRACE("degree " + std::to_string(degree) + ", seed " + std::to_string(seed));
      const Scene scene = lined(random_flights(seed, 6, 2, degree, seed % 2 == 0), LineUse::kAlone);
      const TwinRun run(scene, trapezoids()), twin(scene, trapezoids(), "sturm");
      EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
      const ReplayedRun replayed(scene, kName);
      externals += run.ledger().external;
      updates += run.ledger().motion_updates;
    }
  }
  EXPECT_GT(externals, test::seen_in_fewer(100u));
  EXPECT_GT(updates, test::seen_in_fewer(60u));
}

// From any rational instant on, a run goes on as a fresh one does whose scene begins there.
TEST(Trapezoids, AFreshRunFromTheMiddle) {
  FreshRuns runs;
  for (std::uint64_t seed = 1; seed <= test::fewer(6u); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene =
        lined(random_flights(seed, 7, 2, 2, true, plan_instants(seed)), LineUse::kAlone);
    runs.expect_to_go_on(scene, trapezoids(), seed);
  }
  runs.expect_changes();
}

// All triples turn over twice and all slopes are equal once.
TEST(Trapezoids, TheMostTriples) {
  for (const int n : {3, 4, 7}) {
    SCOPED_TRACE(n);
    const ReplayedRun run(most_crossings(n), kName);
  }
}

// Runs in inexact arithmetics end. In double the walls are those of the exact run then, although the lists
// of the lines pass through states in which faces do not close.
TEST(Trapezoids, InexactRunsEnd) {
  for (const char* const arithmetic : {"double", "gsl", "mpfr:4", "mpfr:53"}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(12u); ++seed) {
      SCOPED_TRACE(std::string(arithmetic) + ", seed " + std::to_string(seed));
      const Scene given = seed % 3 == 0 ? random_flights(seed, 7, 2, 2, true) : lattice_scene(seed, 7, 2);
      const Scene scene = lined(given, LineUse::kAlone);
      TwinRun run(scene, trapezoids(), arithmetic);
      EXPECT_EQ(run.simulator.run_until(std::nullopt), RunStatus::kDone);
      if (arithmetic != std::string("double")) continue;
      EXPECT_FALSE(run.ledger().corrupt);
      EXPECT_EQ(run.attribute(), TwinRun(scene, trapezoids()).attribute());
    }
  }
}

TEST(Trapezoids, NoneToTwo) {
  Scene scene = lines({path({{-1}, {0}}), path({{0}, {-1, 1}})}, 0, 2);
  EXPECT_EQ(at_start(scene), (Ids{0, 1, 0, 0}));
  EXPECT_EQ(external(scene), Log{});
  scene.objects.pop_back();
  EXPECT_EQ(at_start(scene), Ids{});
  scene.objects.clear();
  EXPECT_EQ(at_start(scene), Ids{});
}

// Tables are as large as the lines ask for, however many points there are, and lines outside a sample.
TEST(Trapezoids, PointsAndOtherLinesCostNothing) {
  const auto bytes = [](const std::string& name, int lines, int points) {
    std::vector<Trajectory> t;
    for (int i = 0; i < lines; ++i) t.push_back(path({{i, 1}, {i * i}}));
    for (int i = 0; i < points; ++i) t.push_back(path({{i}, {-i}}));
    Scene scene = scene_of(t, 0, Rational(1));
    for (int i = 0; i < lines; ++i) scene.objects[static_cast<std::size_t>(i)].line = true;
    scene.maintain = {{name, name, {}}};
    if (name == "incidences_cutting") scene.maintain[0].parameters = {{"r", Rational(2)}};
    Simulator simulator(scene, planned_arithmetic("exact", scene),
                        Trial::options(AuditLevel::kNone));
    add_structures(simulator, scene);
    simulator.start();
    simulator.run_until(std::nullopt);
    return simulator.ledger().peak_bytes;
  };
  // About a kilobyte for each object, and no table of all pairs, which would have 160 MB.
  EXPECT_LT(bytes("trapezoids_2", 3, 2000), 8u << 20);
  EXPECT_LT(bytes("points_in_arrangement", 3, 2000), 16u << 20);
  EXPECT_LT(bytes("incidences_cutting", 600, 3), 16u << 20);
}

}  // namespace trapezoids_test
}  // namespace kinex::test
