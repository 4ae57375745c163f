// SPDX-License-Identifier: GPL-3.0-or-later
// Question: the cost of a query that falls through the floating-point filter and 128-bit integers,
//   relative to one that they resolve. (Queries: signs, failure times, further looks, comparisons
//   of instants.)
// Workload: scenes with many events at one instant, or instants very near each other, against
//   random motion: the first row of each structure.
// Ordinary: time of the random run over its queries, everything included (the structure, the
//   queue). Fall-through: the time of the other run less that of its ordinary queries, over the
//   queries answered with integers of any size. The best of several rounds; thread CPU time.
// Output: see result_table.h; options: see bench_options.h.
#include <string>
#include <string_view>
#include <vector>

#include "experiments/lab/bench_row.h"
#include "experiments/lab/bench_run.h"
#include "experiments/lab/result_table.h"

namespace {

using namespace kinex;

struct Cost {
  double seconds = 0;
  double ordinary = 0;      // queries
  double fall_through = 0;  // queries
};

Cost cost_of(const lab::BenchRow& row) {
  const Scene scene = lab::scene_of(row);
  const auto whole = [&scene] {
    lab::BenchRun run = lab::run_once(scene, {});
    run.seconds += run.build;
    return run;
  };
  const lab::BenchRun run = lab::best_of_rounds({whole}, {.count = row.rounds})[0];
  Cost cost{.seconds = run.seconds};
  for (const StageCounts& counts : {run.signs(), run.failures(), run.looks(), run.comparisons()}) {
    const std::uint64_t exact = counts[static_cast<std::size_t>(Stage::kExact)];
    cost.fall_through += static_cast<double>(exact);
    cost.ordinary += static_cast<double>(lab::total(counts) - exact);
  }
  return cost;
}

void fall_through(const lab::BenchOptions& options) {
  lab::ResultTable table(options, "fall_through",
                         "What a question costs that doubles cannot answer, in ordinary ones.",
                         {{"structure", lab::ResultTable::kText, 12},
                          {"workload", lab::ResultTable::kText, 15},
                          {"n", 0, 5},
                          {"ordinary", 0, 10},
                          {"fall_through", 0},
                          {"ns_ordinary", 1},
                          {"ns_fall_through", 1},
                          {"ratio", 1}});
  std::string_view structure;
  double ordinary = 0;  // seconds of a query
  lab::BenchOptions all = options;
  all.rows.clear();
  for (const lab::BenchRow& row : lab::bench_rows("fall_through", all)) {
    const Cost cost = cost_of(row);
    if (row.structure != structure) {
      structure = row.structure;
      ordinary = cost.seconds / cost.ordinary;
      continue;
    }
    const double each =
        cost.fall_through > 0 ? (cost.seconds - cost.ordinary * ordinary) / cost.fall_through : 0;
    table.row({structure, row.workload, row.parameters.n, cost.ordinary, cost.fall_through,
               ordinary * 1e9, each * 1e9, each / ordinary});
  }
}

}  // namespace

int main(int argc, char** argv) { return kinex::lab::bench_main(argc, argv, fall_through); }
