// SPDX-License-Identifier: GPL-3.0-or-later
// The floor of the benchmark `speed` handles the events of an exact run, no more and no fewer.
#include <gtest/gtest.h>

#include <string>

#include "core/engine/simulator.h"
#include "experiments/bench/floor.h"
#include "experiments/lab/workload.h"
#include "structures/plan.h"

namespace kinex {
namespace {

Scene random_scene(const char* structure, int degree, int n, std::uint64_t seed) {
  lab::WorkloadParameters parameters;
  parameters.n = n;
  parameters.degree = degree;
  parameters.seed = seed;
  Scene scene = lab::generate_scene(*lab::find_workload("uniform-square"), parameters);
  scene.maintain = {{structure, structure, {}}};
  return scene;
}

std::uint64_t exact_events(const Scene& scene, std::uint64_t most) {
  SimulatorOptions options;
  options.max_events = most;
  Simulator simulator(scene, make_arithmetic("exact", scene), options);
  add_structures(simulator, scene);
  simulator.start();
  simulator.run_until(scene.end);
  return simulator.ledger().events;
}

TEST(BenchFloor, HandlesTheEventsOfAnExactRun) {
  std::uint64_t all = 0;
  for (const char* structure : {"sorted_list", "delaunay_2"}) {
    for (int degree = 1; degree <= 3; ++degree) {
      for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const Scene scene = random_scene(structure, degree, 60, seed);
        ASSERT_TRUE(has_floor(structure, scene));
        const std::uint64_t events = exact_events(scene, 0);
        EXPECT_EQ(run_floor(structure, scene, 0).events, events)
            << structure << ", degree " << degree << ", seed " << seed;
        all += events;
      }
    }
  }
  EXPECT_GT(all, 10000u);
}

TEST(BenchFloor, StopsWhereItIsAskedTo) {
  const Scene scene = random_scene("delaunay_2", 1, 60, 1);
  EXPECT_EQ(run_floor("delaunay_2", scene, 100).events, 100u);
}

TEST(BenchFloor, IsThereForPlainMotionsOnly) {
  EXPECT_FALSE(has_floor("convex_hull_2", random_scene("convex_hull_2", 1, 10, 1)));
  EXPECT_FALSE(has_floor("sorted_list", random_scene("sorted_list", 4, 10, 1)));
  EXPECT_FALSE(has_floor("sorted_list", random_scene("sorted_list", 1, 2, 1)));
}

}  // namespace
}  // namespace kinex
