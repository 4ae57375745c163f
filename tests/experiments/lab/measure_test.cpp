// SPDX-License-Identifier: GPL-3.0-or-later
// What is measured of a structure that reads another one: its own changes, and the costs of both.
#include <gtest/gtest.h>

#include <stdexcept>

#include "experiments/lab/measurement.h"
#include "experiments/lab/workload.h"

namespace kinex {
namespace measure_test {

Scene scene_for(const char* structure, const char* workload, int n, int dimension) {
  lab::WorkloadParameters parameters;
  parameters.n = n;
  parameters.dimension = dimension;
  Scene scene = lab::generate_scene(*lab::find_workload(workload), parameters);
  scene.maintain = {{structure, structure, {}}};
  return scene;
}

// Eight lines cross one another; each becomes the maximum in turn.
TEST(Measure, MaximumOfAList) {
  const lab::Measurement run = lab::measure(scene_for("maximum_sorted_list", "tournament-worst", 8, 0),
                                  "exact", SimulatorOptions{});
  EXPECT_TRUE(run.clean());
  EXPECT_EQ(run.attribute.shape, Attribute::Shape::kObject);
  EXPECT_EQ(run.ledger.external, 7u);
  EXPECT_EQ(run.ledger.max_live, 0u);  // it has no certificates of its own
  EXPECT_EQ(run.costs.max_live, 7u);
  EXPECT_EQ(run.costs.max_per_object, 2u);
  EXPECT_EQ(run.costs.created_per_event.events, 28u);
  EXPECT_EQ(run.costs.created_per_event.max, 3u);
  EXPECT_EQ(run.count_of("external"), 7u);
  EXPECT_EQ(run.count_of("processed"), 28u);
  EXPECT_EQ(run.count_of("internal"), 21u);
  EXPECT_EQ(run.count_of("kind.replace"), 7u);
  EXPECT_EQ(run.count_of("kind.swap"), 0u);
  EXPECT_EQ(run.count_of("external+internal"), 28u);
  EXPECT_THROW(run.count_of("changes"), std::invalid_argument);
}

TEST(Measure, HullOfATriangulation) {
  const lab::Measurement alone =
      lab::measure(scene_for("convex_hull_2", "hull-worst", 4, 0), "exact", SimulatorOptions{});
  const lab::Measurement read =
      lab::measure(scene_for("convex_hull_2_delaunay", "hull-worst", 4, 0), "exact", SimulatorOptions{});
  const lab::Measurement whole =
      lab::measure(scene_for("delaunay_2", "hull-worst", 4, 0), "exact", SimulatorOptions{});
  EXPECT_TRUE(read.clean());
  EXPECT_EQ(read.attribute, alone.attribute);
  EXPECT_EQ(read.count_of("external"), 31u);  // 2 n m - 1
  EXPECT_EQ(alone.count_of("external"), 31u);
  EXPECT_EQ(read.count_of("processed"), whole.count_of("processed"));
  EXPECT_EQ(read.costs.max_live, whole.costs.max_live);
  EXPECT_EQ(whole.costs.max_live, whole.ledger.max_live);
  EXPECT_EQ(whole.count_of("internal"), 0u);
  EXPECT_EQ(alone.count_of("processed"), alone.costs.external + alone.costs.internal);
}

}  // namespace measure_test
}  // namespace kinex
