// SPDX-License-Identifier: GPL-3.0-or-later
// Question: where does lazy scheduling pay? (Guibas 1998, section 10: certificates are queued under
//   a horizon before which they are proved not to fail.)
// Workload: uniform-square. For each structure, degree and arithmetic one run with and one without,
//   alternating; the best of each; thread CPU time.
// Counted: failure times computed in full, those among them of certificates that were retracted
//   first, and horizons queued instead.
// Output: see result_table.h; options: see options.h.
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "core/engine/simulator.h"
#include "experiments/bench/options.h"
#include "experiments/bench/result_table.h"
#include "experiments/lab/cpu_clock.h"
#include "experiments/lab/workload.h"
#include "structures/plan.h"

namespace {

using namespace kinex;

struct Contest {
  const char* structure;
  int degree;
  int n;
  const char* arithmetic;
};

struct Result {
  double seconds = 0;
  std::uint64_t found = 0, unused = 0, windows = 0;
};

Result run_once(const Scene& scene, const char* arithmetic, Scheduling scheduling) {
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  options.scheduling = scheduling;
  Simulator simulator(scene, planned_arithmetic(arithmetic, scene), options);
  add_structures(simulator, scene);
  simulator.start();
  const double begin = lab::cpu_seconds();
  simulator.run_until(scene.end);
  const StructureLedger& ledger = simulator.ledger(0);
  return {lab::cpu_seconds() - begin, ledger.failures_found, ledger.failures_unused, ledger.windows};
}

void run_contest(const Contest& contest, int rounds, ResultTable& table) {
  lab::WorkloadParameters parameters;
  parameters.n = contest.n;
  parameters.degree = contest.degree;
  Scene scene = lab::generate_scene(*lab::find_workload("uniform-square"), parameters);
  scene.maintain = {{contest.structure, contest.structure, {}}};
  Result eager, lazy;
  for (int round = 0; round < rounds; ++round) {
    const Result e = run_once(scene, contest.arithmetic, Scheduling::kEager);
    const Result l = run_once(scene, contest.arithmetic, Scheduling::kLazy);
    if (round == 0 || e.seconds < eager.seconds) eager = e;
    if (round == 0 || l.seconds < lazy.seconds) lazy = l;
  }
  table.row({contest.structure, contest.degree, contest.n, contest.arithmetic, eager.seconds,
             eager.found, eager.unused, lazy.seconds, lazy.found, lazy.unused, lazy.windows,
             lazy.seconds / eager.seconds});
}

}  // namespace

int main(int argc, char** argv) {
  const auto options = bench_options(argc, argv);
  if (!options) return 2;
  const bool smoke = options->smoke;
  ResultTable table(*options, "scheduling",
                    "Certificates queued under a proved horizon (lazy) or with their failure time "
                    "(eager): failure times found, and found for certificates that died first.",
                    {{"structure", ResultTable::kText, 19},
                     {"degree", 0},
                     {"n", 0, 6},
                     {"arithmetic", ResultTable::kText},
                     {"eager_seconds", 3},
                     {"eager_found", 0},
                     {"eager_unused", 0},
                     {"lazy_seconds", 3},
                     {"lazy_found", 0},
                     {"lazy_unused", 0},
                     {"horizons", 0, 9},
                     {"lazy_over_eager", 3}});
  const int small = smoke ? 20 : 0;
  for (const char* arithmetic : {"exact", "double", "sturm"}) {
    const bool slow = std::strcmp(arithmetic, "sturm") == 0;
    for (const int degree : {1, 2, 3}) {
      const auto size = [&](int fast_n, int slow_n) {
        return small ? small : slow ? slow_n : fast_n;
      };
      run_contest({"sorted_list", degree, size(1000, 80), arithmetic}, slow || smoke ? 1 : 3,
                  table);
      run_contest({"maximum_tournament", degree, size(10000, 300), arithmetic},
                  slow || smoke ? 1 : 3, table);
      run_contest({"delaunay_2", degree, size(500, degree == 1 ? 60 : 24), arithmetic},
                  slow || smoke ? 1 : 3, table);
    }
  }
  return 0;
}
