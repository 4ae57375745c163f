// SPDX-License-Identifier: GPL-3.0-or-later
// ConvexHull2: events by level, and large scenes.
#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

#include "tests/sanitized.h"
#include "tests/structures/hull/hull_support.h"

namespace kinex::test {
namespace convex_hull_2_large_test {

std::uint64_t sum(const std::vector<std::uint64_t>& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

BoundCheck bound_of(const Simulator& simulator, const std::string& id) {
  for (const BoundCheck& check : simulator.bounds(0)) {
    if (check.id == id) return check;
  }
  ADD_FAILURE() << "no bound " << id;
  return {};
}

// The two points of each node just above the points pass each other in x once, and no other
// certificate can fail there: the bound of the lowest level is reached.
TEST(ConvexHull2Levels, EachPairPassesOnce) {
  const int n = 32;
  std::vector<Trajectory> motions;
  for (int i = 0; i < n / 2; ++i) {
    motions.push_back(path({{10 * i, 2 + i}, {i * i % 7}}));
    motions.push_back(path({{10 * i + 1}, {i * i % 5, 1}}));
  }
  for (const char* structure : {"convex_hull_2", "convex_hull_2_naive"}) {
    HullRun run(scene_of(motions, 0, Rational(1)), structure);
    run.trial.to_end().expect_clean();
    const std::vector<std::uint64_t>& levels = run.hull().failures_by_level();
    ASSERT_GT(levels.size(), 1u);
    EXPECT_EQ(levels[1], static_cast<std::uint64_t>(n / 2)) << structure;
    EXPECT_EQ(sum(levels), run.trial.ledger().failures);
  }
}

// Small numbers, by hand: heights 1 and 2 of a tree over four points, with linear motion.
TEST(ConvexHull2Levels, Bounds) {
  HullRun run(random_plane(4, 7));
  run.trial.to_end().expect_clean();
  const BoundCheck low = bound_of(run.trial.simulator, "convex_hull_2.level_01");
  const BoundCheck high = bound_of(run.trial.simulator, "convex_hull_2.level_02");
  EXPECT_EQ(low.bound, Integer(2));                     // two pairs
  EXPECT_EQ(high.bound, Integer(4 + 4 * (2 + 2) + 4));  // four pairs, four triples, one four
  EXPECT_EQ(low.observed + high.observed, Integer(static_cast<int>(run.trial.ledger().processed)));
}

TEST(ConvexHull2Levels, EveryFailureIsCountedOnce) {
  HullRun run(random_plane(300, 3), "convex_hull_2", "exact", AuditLevel::kEnd);
  run.trial.to_end().expect_clean();
  Integer total;
  for (const BoundCheck& check : run.trial.simulator.bounds(0)) {
    if (check.id.find(".level_") != std::string::npos) total += check.observed;
  }
  EXPECT_EQ(total, Integer(static_cast<int>(run.trial.ledger().processed)));
  EXPECT_EQ(run.hull().failures_by_level()[0], 0u);
}

// The first events of a scene, then all certificates, all of the structure, and CGAL.
void run_for_a_while(Scene scene, std::uint64_t events, bool general_position) {
  scene.maintain = {{"convex_hull_2", "convex_hull_2", {}}};
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  options.max_events = events;
  Simulator simulator(scene, make_arithmetic("exact", scene), options);
  add_structures(simulator, scene);
  simulator.start();
  EXPECT_EQ(simulator.run_until(std::nullopt), RunStatus::kLimit);
  EXPECT_TRUE(simulator.audit());
  EXPECT_EQ(simulator.violations(), std::vector<std::string>{});
  const StructureLedger& ledger = simulator.ledger(0);
  EXPECT_GT(ledger.audit_checks, scene.objects.size());
  EXPECT_GE(ledger.processed, events);
  EXPECT_EQ(ledger.rebuilds, 0u);
  const auto& hull = dynamic_cast<const ConvexHull2&>(simulator.structure(0));
  EXPECT_EQ(sum(hull.failures_by_level()), ledger.processed);
  EXPECT_EQ(hull.failures_by_level().size(), 1u + (scene.objects.size() > 65536 ? 17 : 14));
  if (general_position) {
    EXPECT_EQ(hull.node_rebuilds(), 0u);
  }
  for (const BoundCheck& check : simulator.bounds(0)) EXPECT_TRUE(check.holds) << check.id;
}

constexpr std::uint64_t kEvents = kSanitized ? 5000 : 100000;

TEST(SlowConvexHull2, AHundredThousandPoints) {
  run_for_a_while(random_plane(kSanitized ? 10000 : 100000, 1), kEvents, true);
}

TEST(SlowConvexHull2, AHundredThousandPointsOnParabolas) {
  run_for_a_while(random_plane(kSanitized ? 10000 : 100000, 2, 2), kEvents, true);
}

// Positions on a grid and few velocities: many events at one instant, lines of points, equal
// points.
TEST(SlowConvexHull2, TenThousandPointsOnAGrid) {
  run_for_a_while(small_plane(10000, 3, 1, 300), kSanitized ? 1000 : 30000, false);
}

}  // namespace convex_hull_2_large_test
}  // namespace kinex::test
