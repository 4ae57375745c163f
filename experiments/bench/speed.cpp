// SPDX-License-Identifier: GPL-3.0-or-later
// Question: how many events per second does a whole run handle in `exact`, and how does that
//   compare with floating point and with the unfiltered reference, in one process on one core?
// Workload: random motion, scenes full of ties or of new plans, and bodies; small and large n.
//   Without event log and digest. Rounds of different arithmetics are interleaved; the best of each
//   counts (one round of runs longer than three seconds); times are thread CPU time.
// Ratio: 0 where doubles handle other events than `exact`, or do not end. The floor
//   (BenchRow::floor) is the least that a program must do for the same events; 0 where there is none.
// Output: see result_table.h; options: see bench_options.h; the head of bench.md is made of the rows
//   (head.cpp).
#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "experiments/lab/bench_row.h"
#include "experiments/lab/bench_run.h"
#include "experiments/lab/result_table.h"

namespace {

using namespace kinex;

// The noise of a short run exceeds its time: it is repeated. That of a long one is small: it is run once.
constexpr double kLeastSeconds = 0.3, kLongSeconds = 3;

// The largest numbers of certificates of all structures, those that are read included; at least 1.
double certificates_of(const lab::BenchRun& run) {
  std::uint64_t sum = 0;
  for (const StructureLedger& ledger : run.structures) sum += ledger.max_live;
  return static_cast<double>(std::max<std::uint64_t>(1, sum));
}

void add_row(const lab::BenchRow& row, double least_seconds, lab::ResultTable& table) {
  const Scene scene = lab::scene_of(row);
  const lab::BenchRun exact = lab::run_once(scene, {.arithmetic = "exact", .events = row.events});
  // Doubles that cycle are stopped.
  const std::uint64_t most = row.events != 0 ? row.events : 4 * exact.events + 1000;
  std::vector<std::function<lab::BenchRun()>> ways;
  for (const std::string_view arithmetic : row.arithmetics) {
    ways.emplace_back([&, arithmetic] {
      return lab::run_once(scene, {.arithmetic = std::string(arithmetic), .events = most});
    });
  }
  if (row.floor != nullptr) ways.emplace_back([&] { return row.floor(scene, row.events); });
  const int rounds = exact.seconds > kLongSeconds ? 1 : row.rounds;
  const std::vector<lab::BenchRun> best =
      lab::best_of_rounds(ways, {.count = rounds, .least_seconds = least_seconds});
  const lab::BenchRun& first = best.front();
  for (std::size_t i = 0; i < row.arithmetics.size(); ++i) {
    const lab::BenchRun& run = best[i];
    const bool same = lab::same_events(run, exact);
    const bool floored = row.floor != nullptr && same && best.back().events == exact.events;
    const StageCounts failures = run.failures();
    table.row({row.structure, row.workload, row.parameters.degree, row.parameters.n,
               row.arithmetics[i], run.events, run.seconds,
               static_cast<double>(run.events) / run.seconds, row.arithmetics[0],
               same && lab::same_events(first, exact) ? run.seconds / first.seconds : 0,
               floored ? run.seconds / best.back().seconds : 0,
               static_cast<double>(run.peak_bytes) / certificates_of(run),
               lab::total(failures), failures[1], failures[3]});
  }
}

void speed(const lab::BenchOptions& options) {
  lab::ResultTable table(
      options, "speed",
      "Whole runs, without log and digest: time over that of the first arithmetic (0: "
      "they handle other events, or do not finish), and over that of the least program for the "
      "same events (0: there is none, or it handles others), failure times asked for, and "
      "those that 128 bits or big integers had to answer.",
      {{"structure", lab::ResultTable::kText, 25},
       {"scene", lab::ResultTable::kText, 18},
       {"degree", 0},
       {"n", 0, 7},
       {"arithmetic", lab::ResultTable::kText},
       {"events", 0, 9},
       {"seconds", 4},
       {"events_per_second", 0},
       {"first", lab::ResultTable::kText, 6},
       {"time_over_first", 3},
       {"time_over_floor", 3},
       {"bytes_per_certificate", 1},
       {"failure_times", 0},
       {"wide", 0, 6},
       {"exact", 0, 6}});
  for (const lab::BenchRow& row : lab::bench_rows("speed", options)) {
    add_row(row, options.smoke ? 0 : kLeastSeconds, table);
  }
}

}  // namespace

int main(int argc, char** argv) { return kinex::lab::bench_main(argc, argv, speed); }
