// SPDX-License-Identifier: GPL-3.0-or-later
// The floors of the benchmark `speed` handle the events of an exact run, no more and no fewer.
#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>
#include <string_view>

#include "experiments/families/order/floor.h"
#include "experiments/families/points/bench_rows.h"
#include "experiments/families/triangulation/floor.h"
#include "experiments/lab/bench_row.h"
#include "experiments/lab/bench_run.h"

namespace kinex {
namespace floor_test {

using families::run_delaunay_floor;
using families::run_list_floor;

Scene random_scene(const char* structure, int degree, int n, std::uint64_t seed) {
  lab::BenchRow row = families::plane_row("speed", structure, degree, n, 1);
  row.parameters.seed = seed;
  return lab::scene_of(row);
}

TEST(BenchFloor, HandlesTheEventsOfAnExactRun) {
  std::uint64_t all = 0;
  for (const char* structure : {"sorted_list", "delaunay_2"}) {
    const auto floor =
        structure == std::string_view("sorted_list") ? run_list_floor : run_delaunay_floor;
    for (int degree = 1; degree <= 3; ++degree) {
      for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const Scene scene = random_scene(structure, degree, 60, seed);
        const std::uint64_t events = lab::run_once(scene, {}).events;
        EXPECT_EQ(floor(scene, 0).events, events)
            << structure << ", degree " << degree << ", seed " << seed;
        all += events;
      }
    }
  }
  EXPECT_GT(all, 10000u);
}

TEST(BenchFloor, StopsWhereItIsAskedTo) {
  EXPECT_EQ(run_delaunay_floor(random_scene("delaunay_2", 1, 60, 1), 100).events, 100u);
}

TEST(BenchFloor, IsThereForPlainMotionsOnly) {
  EXPECT_THROW(run_list_floor(random_scene("sorted_list", 4, 10, 1), 0), std::invalid_argument);
  EXPECT_THROW(run_list_floor(random_scene("sorted_list", 1, 2, 1), 0), std::invalid_argument);
  const Scene plans = lab::scene_of(families::plans_row("sorted_list", 8, 10));
  EXPECT_THROW(run_list_floor(plans, 0), std::invalid_argument);
  lab::BenchRow space = families::random_row("delaunay_3", 1, 10);
  EXPECT_THROW(run_delaunay_floor(lab::scene_of(space), 0), std::invalid_argument);
}

// The rows of `speed` have one exactly where it is possible and there are no ties.
TEST(BenchFloor, BelongsToRowsInRandomMotion) {
  int floors = 0;
  for (const lab::BenchRow& row : lab::bench_rows("speed", {})) {
    const bool has_one = row.structure == "sorted_list" || row.structure == "delaunay_2";
    EXPECT_EQ(row.floor != nullptr, has_one && row.workload == "uniform-square") << row.text();
    floors += row.floor != nullptr ? 1 : 0;
  }
  EXPECT_GT(floors, 20);
}

}  // namespace floor_test
}  // namespace kinex
