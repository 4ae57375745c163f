// SPDX-License-Identifier: GPL-3.0-or-later
// How much work the exact runs of two benchmarks do: counters, which are the same on every machine.
#include <gtest/gtest.h>

#include <cstddef>

#include "experiments/lab/bench_row.h"
#include "experiments/lab/bench_run.h"

namespace kinex {
namespace stages_test {

lab::BenchRun exact_run(const lab::BenchRow& row) {
  return lab::run_once(lab::scene_of(row), {.arithmetic = "exact"});
}

// Terms of squared distances cancel near the closest pairs: the slope of a claim near now is far below the sum
// of the bounds of its coefficients. With that sum for a slope a tenth of the failure times is found in
// integers.
TEST(StagesOfProximity, DistancesFromLinesAreDecidedInDoubles) {
  const lab::BenchRun run =
      exact_run(lab::speed_row("closest_point_line", "random-lines-and-points", 1, 32));
  const auto exact = static_cast<std::size_t>(Stage::kExact);
  EXPECT_GT(lab::total(run.failures()), 1000u);
  EXPECT_LE(100 * run.failures()[exact], lab::total(run.failures()));
  EXPECT_LE(100 * run.signs()[exact], lab::total(run.signs()));
}

// Facets of the hull around one flip fail together, some at touches, too, and some not: no degenerate instant,
// at which everything around them would be looked at.
TEST(StagesOfProximity, FlipsOfTheHullInSpaceAreNoDegenerateInstants) {
  lab::BenchRow row = lab::speed_row("delaunay_3", "uniform-square", 1, 60);
  row.parameters.dimension = 3;
  const lab::BenchRun run = exact_run(row);
  EXPECT_GT(run.events, 500u);
  EXPECT_LE(lab::total(run.signs()) - run.signs_at_start, 5 * run.events);
}

}  // namespace stages_test
}  // namespace kinex
