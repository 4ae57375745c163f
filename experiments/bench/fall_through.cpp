// SPDX-License-Identifier: GPL-3.0-or-later
// Question: the cost of a query that falls through the floating-point filter and 128-bit integers,
//   relative to one that they resolve. (Queries: signs, failure times, further looks, comparisons
//   of instants.)
// Workload: grid (many events at one instant) and near-one-point (instants within 2^-60 of each
//   other), against uniform-square.
// Ordinary: time of the uniform run over its queries, everything included (the structure, the
//   queue). Fall-through: the time of the other run less that of its ordinary queries, over the
//   queries answered with integers of any size. The best of several rounds; thread CPU time.
// Output: see result_table.h; options: see options.h.
#include <cstdio>

#include "core/engine/simulator.h"
#include "experiments/bench/options.h"
#include "experiments/bench/result_table.h"
#include "experiments/lab/cpu_clock.h"
#include "experiments/lab/workload.h"
#include "structures/plan.h"

namespace {

using namespace kinex;

struct Result {
  double seconds = 0;
  double ordinary = 0;      // queries
  double fall_through = 0;  // queries
};

Result run_once(const Scene& scene) {
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  Simulator simulator(scene, planned_arithmetic("exact", scene), options);
  add_structures(simulator, scene);
  const double begin = lab::cpu_seconds();
  simulator.start();
  simulator.run_until(scene.end);
  Result result;
  result.seconds = lab::cpu_seconds() - begin;
  for (const PredicateCounters& p : simulator.arithmetic().counters().by_predicate) {
    for (const StageCounts* counts : {&p.signs, &p.failures, &p.looks, &p.comparisons}) {
      for (int s = 0; s < kStages; ++s) {
        const bool exact = s == static_cast<int>(Stage::kExact);
        (exact ? result.fall_through : result.ordinary) +=
            static_cast<double>((*counts)[static_cast<std::size_t>(s)]);
      }
    }
  }
  return result;
}

Result best_of(const char* workload, const char* structure, int degree, int n, int rounds) {
  lab::WorkloadParameters parameters;
  parameters.n = n;
  parameters.degree = degree;
  Scene scene = lab::generate_scene(*lab::find_workload(workload), parameters);
  scene.maintain = {{structure, structure, {}}};
  Result best = run_once(scene);
  for (int round = 1; round < rounds; ++round) {
    const Result r = run_once(scene);
    if (r.seconds < best.seconds) best = r;
  }
  return best;
}

}  // namespace

int main(int argc, char** argv) {
  const auto options = bench_options(argc, argv);
  if (!options) return 2;
  const bool smoke = options->smoke;
  ResultTable table(*options, "fall_through",
                    "What a question costs that doubles cannot answer, in ordinary ones.",
                    {{"structure", ResultTable::kText, 12},
                     {"workload", ResultTable::kText, 15},
                     {"n", 0, 5},
                     {"ordinary", 0, 10},
                     {"fall_through", 0},
                     {"ns_ordinary", 1},
                     {"ns_fall_through", 1},
                     {"ratio", 1}});
  const int rounds = smoke ? 1 : 5;
  for (const char* structure : {"sorted_list", "delaunay_2"}) {
    const Result usual = best_of("uniform-square", structure, 1, smoke ? 20 : 500, rounds);
    const double ordinary = usual.seconds / usual.ordinary;
    for (const auto& [workload, n] : {std::pair{"grid", 400}, std::pair{"near-one-point", 60}}) {
      const Result r = best_of(workload, structure, 1, smoke ? 9 : n, rounds);
      const double each =
          r.fall_through > 0 ? (r.seconds - r.ordinary * ordinary) / r.fall_through : 0;
      table.row({structure, workload, smoke ? 9 : n, r.ordinary, r.fall_through, ordinary * 1e9,
                 each * 1e9, each / ordinary});
    }
  }
  return 0;
}
