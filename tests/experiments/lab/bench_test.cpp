// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of benchmarks, their scenes, and the best of interleaved rounds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/lab/bench_row.h"
#include "experiments/lab/bench_run.h"
#include "experiments/lab/family.h"

namespace kinex::lab {
namespace bench_test {

using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(BenchRow, ChoosesByBenchmarkAndByItsText) {
  const std::vector<BenchRow> all = bench_rows("speed", {}), none = bench_rows("no benchmark", {});
  EXPECT_THAT(none, IsEmpty());
  for (const BenchRow& row : all) EXPECT_EQ(row.benchmark, "speed");
  BenchOptions options;
  options.rows = "delaunay_2 uniform-square 2 1000";
  const std::vector<BenchRow> one = bench_rows("speed", options);
  ASSERT_THAT(one, SizeIs(1));
  EXPECT_EQ(one[0].text(), "delaunay_2 uniform-square 2 1000");
  EXPECT_EQ(one[0].rounds, 3);
  options.smoke = true;
  options.rows = "delaunay_2 uniform-square 2 10";
  const std::vector<BenchRow> small = bench_rows("speed", options);
  ASSERT_THAT(small, SizeIs(1));
  EXPECT_EQ(small[0].parameters.n, 10);
  EXPECT_EQ(small[0].rounds, 1);
}

TEST(BenchRow, SceneHasTheAxesOfItsStructure) {
  EXPECT_EQ(scene_of(speed_row("sorted_list", "uniform-square", 1, 5)).dimension, 1);
  EXPECT_EQ(scene_of(speed_row("delaunay_2", "uniform-square", 1, 5)).dimension, 2);
  EXPECT_EQ(scene_of(speed_row("delaunay_3", "uniform-square", 1, 5)).dimension, 3);
  BenchRow row = speed_row("sorted_list", "uniform-square", 2, 5);
  row.parameters.dimension = 2;
  EXPECT_EQ(scene_of(row).dimension, 2);
  EXPECT_EQ(scene_of(row).degree(), 2);
  EXPECT_EQ(scene_of(row).maintain.at(0).structure, "sorted_list");
  row.maintain = {{"delaunay_2", "a", {}}, {"sorted_list", "b", {}}};
  EXPECT_EQ(scene_of(row).maintain.at(0).structure, "delaunay_2");
  EXPECT_THROW(scene_of(speed_row("sorted_list", "no-workload", 1, 5)), std::invalid_argument);
}

TEST(BenchRow, SmallScenesOfAllRowsCanBeRun) {
  for (const FamilyExperiments& family : experiment_families()) {
    if (family.bench_rows == nullptr) continue;
    for (const BenchRow& row : family.bench_rows(1000)) {
      const Scene scene = scene_of(row);
      BenchWay way;
      way.events = 20;
      ASSERT_NO_THROW(run_once(scene, way)) << row.benchmark << " " << row.text();
    }
  }
}

TEST(BenchRun, CountsWhatTheRunDid) {
  const Scene scene = scene_of(speed_row("closest_pair_delaunay", "uniform-square", 1, 20));
  int prepared = 0, finished = 0;
  BenchWay way;
  way.prepare = [&](Simulator&) { ++prepared; };
  way.finish = [&](RunStatus status) { finished += status == RunStatus::kDone ? 1 : 0; };
  std::uint64_t events = 0;
  way.inspect = [&](const Simulator& simulator) { events = simulator.ledger(0).failures; };
  const BenchRun run = run_once(scene, way);
  EXPECT_EQ(prepared, 1);
  EXPECT_EQ(finished, 1);
  ASSERT_THAT(run.structures, SizeIs(2));  // the triangulation comes first
  EXPECT_GT(events, 0u);
  EXPECT_EQ(run.structures[0].failures, events);
  EXPECT_EQ(run.events, events + run.structures[1].failures);
  EXPECT_EQ(run.asked.external, run.structures[1].external);
  EXPECT_GE(total(run.signs()), run.signs_at_start);
  EXPECT_GT(total(run.failures()), run.events);
  EXPECT_GT(run.seconds, 0);
  EXPECT_GT(run.build, 0);
  way.events = 10;
  EXPECT_GE(run_once(scene, way).events, 10u);
  EXPECT_LT(run_once(scene, way).events, run.events);
}

TEST(BenchRun, EventsAreTheSameIfNothingIsCorrupt) {
  BenchRun one{.events = 3}, other{.events = 3};
  EXPECT_TRUE(same_events(one, other));
  other.asked.external = 1;
  EXPECT_FALSE(same_events(one, other));
  one.asked.external = 1;
  EXPECT_TRUE(same_events(one, other));
  one.events = 4;
  EXPECT_FALSE(same_events(one, other));
  one.events = 3;
  other.asked.corrupt = true;
  EXPECT_FALSE(same_events(one, other));
}

TEST(BenchRun, WaysTakeTurnsAndTheBestOfEachCounts) {
  std::string order;
  std::vector<double> a{3, 1, 2}, b{5, 6, 4};
  std::size_t next_a = 0, next_b = 0;
  const std::vector<std::function<BenchRun()>> ways{
      [&] {
        order += 'a';
        return BenchRun{.seconds = a[next_a], .events = 10 + next_a++};
      },
      [&] {
        order += 'b';
        return BenchRun{.seconds = b[next_b], .events = 20 + next_b++};
      }};
  const std::vector<BenchRun> best = best_of_rounds(ways, {.count = 3});
  EXPECT_EQ(order, "ababab");
  EXPECT_EQ(best[0].seconds, 1);
  EXPECT_EQ(best[0].events, 11u);
  EXPECT_EQ(best[1].seconds, 4);
  EXPECT_EQ(best[1].events, 22u);
}

TEST(BenchRun, ShortRunsAreRepeatedWithinARound) {
  std::string order;
  const auto way = [&](char name, double seconds) {
    return [&order, name, seconds] {
      order += name;
      return BenchRun{.seconds = seconds};
    };
  };
  best_of_rounds({way('a', 1), way('b', 3)}, {.count = 2, .least_seconds = 2.5});
  EXPECT_EQ(order, "aaabaaab");
}

}  // namespace bench_test
}  // namespace kinex::lab
