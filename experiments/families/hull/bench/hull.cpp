// SPDX-License-Identifier: GPL-3.0-or-later
// Question: what does the kinetic convex hull cost: events per second in `exact` and in `double`,
//   time per event and level of the tree, building, memory; and what do the other methods cost?
// Workload: random motion (../bench_rows.cpp). Rounds of different arithmetics are interleaved; the
//   best of each counts; times are thread CPU time; n = 1,000,000 is built and run for a limited
//   number of events.
// Output: see result_table.h; options: see bench_options.h.
#include <sys/resource.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "experiments/lab/bench_aims.h"
#include "experiments/lab/bench_row.h"
#include "experiments/lab/bench_run.h"
#include "experiments/lab/result_table.h"

namespace {

using namespace kinex;

// The peak memory of this process so far; rows grow.
double process_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1e3;
}

double levels_of(int n) {
  double levels = 0;
  for (int k = 1; k < n; k *= 2) ++levels;
  return levels;
}

double seconds_per_event(const lab::BenchRun& run) {
  return run.seconds / static_cast<double>(std::max<std::uint64_t>(run.events, 1));
}

// Of all structures together, those that are read included.
struct Certificates {
  std::uint64_t most = 0, most_per_point = 0, changed_by_events = 0;
};

Certificates certificates_of(const lab::BenchRun& run) {
  Certificates all;
  for (const StructureLedger& ledger : run.structures) {
    all.most += ledger.max_live;
    all.most_per_point = std::max(all.most_per_point, ledger.max_per_object);
    all.changed_by_events += ledger.created_per_event.total + ledger.retracted_per_event.total;
  }
  return all;
}

void add_row(const lab::BenchRow& row, const lab::BenchRun& exact, const lab::BenchRun& plain,
             lab::ResultTable& table) {
  const double each = seconds_per_event(exact);
  const Certificates certificates = certificates_of(exact);
  table.row({row.structure, row.parameters.n, exact.events, exact.build, exact.seconds, 1 / each,
             plain.seconds > 0 ? exact.seconds / plain.seconds : 0, 1e9 * each,
             1e9 * each / levels_of(row.parameters.n), static_cast<double>(exact.peak_bytes) / 1e6,
             process_megabytes(), certificates.most, certificates.most_per_point});
}

// The cost of an event, in machine-independent counts and in time; each by level of the tree.
void add_growth(int n, const lab::BenchRun& exact, lab::ResultTable& table) {
  const double levels = levels_of(n);
  const double events = static_cast<double>(std::max<std::uint64_t>(exact.events, 1));
  const double changed = static_cast<double>(certificates_of(exact).changed_by_events) / events;
  const double signs =
      static_cast<double>(lab::total(exact.signs()) - exact.signs_at_start) / events;
  table.row({n, levels, changed, changed / levels, signs, signs / levels,
             1e9 * seconds_per_event(exact) / levels});
}

// The runs of convex_hull_2 by their n.
using Growth = std::vector<std::pair<int, lab::BenchRun>>;

void compare_hulls(const lab::BenchOptions& options, Growth& growth, std::vector<lab::Aim>& aims) {
  lab::ResultTable table(options, "hull",
                         "Kinetic convex hulls on uniform-square, in exact arithmetic; time over "
                         "double. Process megabytes: "
                         "the peak of this row and all rows above it.",
                         {{"structure", lab::ResultTable::kText, 25},
                          {"n", 0, 8},
                          {"events", 0, 9},
                          {"build_seconds", 3},
                          {"seconds", 3},
                          {"events_per_second", 0},
                          {"time_over_double", 2},
                          {"ns_per_event", 0},
                          {"ns_per_event_and_level", 0},
                          {"megabytes", 1},
                          {"process_megabytes_so_far", 0},
                          {"certificates", 0},
                          {"most_per_point", 0}});
  for (const lab::BenchRow& row : lab::bench_rows("hull", options)) {
    const std::vector<lab::BenchRun> best =
        lab::best_runs(lab::scene_of(row),
                       {{.arithmetic = "exact", .events = row.events},
                        {.arithmetic = "double", .events = row.events}},
                       {.count = row.rounds});
    add_row(row, best[0], best[1], table);
    if (row.structure != "convex_hull_2") continue;
    const int n = row.parameters.n;
    growth.emplace_back(n, best[0]);
    if (options.smoke) continue;
    const double events = static_cast<double>(best[0].events);
    if (n == 10000) {
      aims.push_back({"events per second at n = 10,000", 500000, events / best[0].seconds, false});
      aims.push_back(
          {"exact / double at n = 10,000", 1.25, best[0].seconds / best[1].seconds, true});
    } else if (n == 1000000) {
      aims.push_back({"events run at n = 1,000,000", 1e6, events, false});
      aims.push_back({"megabytes at n = 1,000,000", 8000, process_megabytes(), true});
    }
  }
}

void hull(const lab::BenchOptions& options) {
  Growth growth;
  std::vector<lab::Aim> aims;
  compare_hulls(options, growth, aims);
  lab::ResultTable table(
      options, "hull_growth",
      "Per event of convex_hull_2, and per event and level: certificates created "
      "and retracted, signs, time. What grows like log n is constant per level.",
      {{"n", 0, 8},
       {"levels", 0},
       {"certificates_changed", 2},
       {"certificates_per_level", 3},
       {"signs", 2},
       {"signs_per_level", 3},
       {"ns_per_level", 0}});
  for (const auto& [n, run] : growth) add_growth(n, run, table);
  lab::report_aims("hull_aims", aims, options);
}

}  // namespace

int main(int argc, char** argv) { return kinex::lab::bench_main(argc, argv, hull); }
