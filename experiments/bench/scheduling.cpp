// SPDX-License-Identifier: GPL-3.0-or-later
// Question: where does lazy scheduling pay? (Guibas 1998, section 10: certificates are queued under
//   a horizon before which they are proved not to fail.)
// Workload: random motion. For each structure, degree and arithmetic runs with and without,
//   alternating; the best of each; thread CPU time.
// Counted: failure times computed in full, those among them of certificates that were retracted
//   first, and horizons queued instead.
// Output: see result_table.h; options: see bench_options.h.
#include <string>
#include <vector>

#include "experiments/lab/bench_row.h"
#include "experiments/lab/bench_run.h"
#include "experiments/lab/result_table.h"

namespace {

using namespace kinex;

void add_row(const lab::BenchRow& row, lab::ResultTable& table) {
  const std::string arithmetic(row.arithmetics.front());
  const std::vector<lab::BenchRun> best =
      lab::best_runs(lab::scene_of(row),
                     {{.arithmetic = arithmetic, .scheduling = Scheduling::kEager},
                      {.arithmetic = arithmetic, .scheduling = Scheduling::kLazy}},
                     {.count = row.rounds});
  const lab::BenchRun &eager = best[0], &lazy = best[1];
  table.row({row.structure, row.parameters.degree, row.parameters.n, arithmetic, eager.seconds,
             eager.asked.failures_found, eager.asked.failures_unused, lazy.seconds,
             lazy.asked.failures_found, lazy.asked.failures_unused, lazy.asked.windows,
             lazy.seconds / eager.seconds});
}

void scheduling(const lab::BenchOptions& options) {
  lab::ResultTable table(
      options, "scheduling",
      "Certificates queued under a proved horizon (lazy) or with their failure time "
      "(eager): failure times found, and found for certificates that died first.",
      {{"structure", lab::ResultTable::kText, 19},
       {"degree", 0},
       {"n", 0, 6},
       {"arithmetic", lab::ResultTable::kText},
       {"eager_seconds", 3},
       {"eager_found", 0},
       {"eager_unused", 0},
       {"lazy_seconds", 3},
       {"lazy_found", 0},
       {"lazy_unused", 0},
       {"horizons", 0, 9},
       {"lazy_over_eager", 3}});
  for (const lab::BenchRow& row : lab::bench_rows("scheduling", options)) add_row(row, table);
}

}  // namespace

int main(int argc, char** argv) { return kinex::lab::bench_main(argc, argv, scheduling); }
