// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of benchmarks, their scenes, and the best of interleaved rounds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/lab/bench_aims.h"
#include "experiments/lab/bench_changes.h"
#include "experiments/lab/bench_row.h"
#include "experiments/lab/bench_run.h"
#include "experiments/lab/family.h"
#include "experiments/lab/temporary_folder.h"

namespace kinex::lab {
namespace bench_test {

using ::testing::HasSubstr;
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

TEST(BenchRun, EventsOfStructuresThatAreReadAreComparedToo) {
  StructureLedger read, asked;
  read.failures = 2, read.external = 1;
  asked.failures = 3, asked.external = 3;
  const BenchRun one{.events = 5, .asked = asked, .structures = {read, asked}};
  EXPECT_EQ(one.external(), 4u);
  BenchRun other = one;
  EXPECT_TRUE(same_events(one, other));
  other.structures[0].external = 2;
  EXPECT_FALSE(same_events(one, other));
  other = one;
  other.structures[0].failures = 3;  // the totals and the structure in question are as before
  other.structures[1].failures = 2;
  EXPECT_FALSE(same_events(one, other));
  other = one;
  other.structures[0].corrupt = true;
  EXPECT_FALSE(same_events(one, other));
  other = one;
  other.structures.pop_back();
  EXPECT_FALSE(same_events(one, other));
}

// Where three lines meet three certificates fail, in doubles at instants of their own: other changes are
// reported, though as many certificates fail.
TEST(BenchRun, ChangesOfTwoArithmeticsCanBeCompared) {
  const auto digest_of = [](const BenchRow& row, const char* arithmetic, BenchRun& run) {
    ChangesDigest digest;
    BenchWay way{.arithmetic = arithmetic};
    way.prepare = [&digest](Simulator& simulator) { simulator.set_sink(&digest, false); };
    run = run_once(scene_of(row), way);
    return digest.value();
  };
  BenchRun exact, other;
  const BenchRow points = speed_row("closest_pair_delaunay", "uniform-square", 1, 20);
  const std::uint64_t changes = digest_of(points, "exact", exact);
  EXPECT_NE(changes, 0u);
  EXPECT_EQ(digest_of(points, "sturm", other), changes);
  EXPECT_TRUE(same_events(exact, other));
  EXPECT_NE(digest_of(speed_row("closest_pair_delaunay", "uniform-square", 1, 21), "exact", other),
            changes);
  const BenchRow lines = speed_row("line_arrangement_2", "random-lines", 1, 20);
  const std::uint64_t triples = digest_of(lines, "exact", exact);
  EXPECT_NE(digest_of(lines, "double", other), triples);
  EXPECT_FALSE(same_events(exact, other));
  EXPECT_EQ(other.events, exact.events);
}

TEST(ChangesDigest, DependsOnExternalEventsAndNotOnTheirOrder) {
  const std::unique_ptr<Arithmetic> numbers = make_arithmetic("double", Scene{});
  Event one;
  one.structure = 1;
  one.kind = 2;
  one.count = 2;
  one.external = true;
  one.ids = {3, 4};
  Event two = one;
  two.ids = {4, 3};
  const auto digest_of = [&](const std::vector<Event>& events) {
    ChangesDigest digest;
    for (const Event& event : events) digest.event(event, *numbers);
    return digest.value();
  };
  EXPECT_EQ(digest_of({one, two}), digest_of({two, one}));
  EXPECT_NE(digest_of({one}), digest_of({two}));
  EXPECT_NE(digest_of({one, one}), digest_of({one}));
  Event internal = two;
  internal.external = false;
  EXPECT_EQ(digest_of({one, internal}), digest_of({one}));
  const std::vector<ObjectId> left{7};
  two = one;
  two.gone = left;
  EXPECT_NE(digest_of({one}), digest_of({two}));
  two.gone = {};
  two.came = left;
  EXPECT_NE(digest_of({one}), digest_of({two}));
}

TEST(BenchAims, ReasonStandsInThePlaceOfTheAnswer) {
  const TemporaryFolder folder;
  BenchOptions options;
  options.markdown = folder.path() / "aims.md";
  report_aims("some_aims", {{"a", 2, 1.5, true}, {"b", 2, 2.5, true}, {"c", 2, 2.5, false}},
              options);
  report_aims("no_aims", {}, options);
  report_aims("other_aims", {{"d", 2, 0, true, "doubles become corrupt"}}, options);
  std::ifstream file(options.markdown);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_THAT(text, HasSubstr("\nAims.\n"));
  EXPECT_THAT(text, HasSubstr("| a | 2.00 | 1.50 | yes |\n"));
  EXPECT_THAT(text, HasSubstr("| b | 2.00 | 2.50 | no |\n"));
  EXPECT_THAT(text, HasSubstr("| c | 2.00 | 2.50 | yes |\n"));
  EXPECT_THAT(text, HasSubstr("| d | 2.00 | 0.00 | doubles become corrupt |\n"));
  EXPECT_THAT(text, HasSubstr("nothing could be measured"));
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
