// SPDX-License-Identifier: GPL-3.0-or-later
// What doubles can answer about rigid bodies: nearly everything, also long after t = 0, where the
// polynomials of full turns in pieces have large coefficients that cancel.
#include <gtest/gtest.h>

#include "experiments/lab/scene_run.h"
#include "experiments/lab/workload.h"

namespace kinex {
namespace collision_filter_test {

struct Asked {
  std::uint64_t all = 0, exact = 0;  // signs and failure times
  std::uint64_t events = 0;
};

Asked ask(int turns) {
  lab::WorkloadParameters parameters;
  parameters.n = 24;
  parameters.m = 31;
  parameters.turns = turns;
  parameters.separation = Rational(Integer(1), Integer(1000));
  const Scene scene = lab::generate_scene(*lab::find_workload("polygon-spin-orbit"), parameters);
  const auto simulator = lab::make_simulator(scene, "exact", {});
  simulator->start();
  simulator->run_until(std::nullopt);
  Asked asked;
  asked.events = simulator->ledger().events;
  for (const PredicateCounters& predicate :
       simulator->arithmetic().counters().by_predicate) {
    for (int stage = 0; stage < kStages; ++stage) {
      const auto s = static_cast<std::size_t>(stage);
      const std::uint64_t both = predicate.signs[s] + predicate.failures[s];
      asked.all += both;
      if (stage == static_cast<int>(Stage::kExact)) asked.exact += both;
    }
  }
  return asked;
}

TEST(CollisionFilter, DoublesAnswerLongAfterTheStart) {
  for (const int turns : {1, 30}) {
    const Asked asked = ask(turns);
    EXPECT_GT(asked.events, 100u * static_cast<unsigned>(turns) / 2) << turns;
    EXPECT_LT(asked.exact * 10, asked.all) << asked.exact << " of " << asked.all << ", " << turns;
  }
}

}  // namespace collision_filter_test
}  // namespace kinex
