// SPDX-License-Identifier: GPL-3.0-or-later
// Question: how many events per second does a whole run handle in `exact`, and how does that
//   compare with floating point and with the unfiltered reference, in one process on one core?
// Workload: random motion (uniform-square), scenes full of ties (lattice, meet, grid) and bodies;
//   small and large n. Without event log and digest. Rounds of different arithmetics are
//   interleaved; the best of each counts; times are thread CPU time.
// Ratio: 0 where doubles handle other events than `exact`, or do not end. The floor
//   (floor.h) is the least that a program must do for the same events; 0 where there is none.
// Output: see result_table.h; options: see options.h; the head of bench.md is made of the rows
//   (head.cpp).
#include <sys/resource.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/engine/simulator.h"
#include "experiments/bench/floor.h"
#include "experiments/bench/options.h"
#include "experiments/bench/result_table.h"
#include "experiments/lab/cpu_clock.h"
#include "experiments/lab/family.h"
#include "experiments/lab/workload.h"
#include "structures/plan.h"
#include "structures/registry.h"

namespace {

using namespace kinex;

struct Result {
  std::uint64_t events = 0, external = 0;
  bool corrupt = false;
  double seconds = 0;
  std::uint64_t peak_bytes = 0;
  std::uint64_t max_live = 0;
  StageCounts failures{};
};

Scene scene_of(const lab::SpeedRow& contest) {
  lab::WorkloadParameters parameters;
  parameters.n = contest.n;
  parameters.m = contest.m;
  parameters.degree = contest.degree;
  parameters.turns = contest.turns;
  const lab::Workload& workload = *lab::find_workload(contest.workload);
  const bool line = find_structure_info(contest.structure)->min_dimension == 1;
  if (!workload.bodies && line && workload.min_dimension == 1) parameters.dimension = 1;
  if (find_structure_info(contest.structure)->min_dimension == 3) parameters.dimension = 3;
  if (contest.inverse_separation > 0) {
    parameters.separation = Rational(Integer(1), Integer(contest.inverse_separation));
  }
  Scene scene = lab::generate_scene(workload, parameters);
  scene.maintain = {{contest.structure, contest.structure, {}}};
  return scene;
}

Result run_once(const Scene& scene, const char* arithmetic, std::uint64_t max_events) {
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  options.max_events = max_events;
  Simulator simulator(scene, planned_arithmetic(arithmetic, scene), options);
  add_structures(simulator, scene);
  simulator.start();
  const double begin = lab::cpu_seconds();
  simulator.run_until(scene.end);
  Result result;
  result.seconds = lab::cpu_seconds() - begin;
  const StructureLedger& ledger = simulator.ledger(asked_structure(scene));
  result.events = simulator.ledger().events;
  result.external = ledger.external;
  result.corrupt = ledger.corrupt;
  result.peak_bytes = simulator.ledger().peak_bytes;
  result.max_live = ledger.max_live;
  for (const PredicateCounters& p : simulator.arithmetic().counters().by_predicate) {
    for (std::size_t s = 0; s < kStages; ++s) result.failures[s] += p.failures[s];
  }
  return result;
}

// `least_seconds`: of a round; shorter runs are repeated.
void run_contest(const lab::SpeedRow& contest, int rounds, double least_seconds, ResultTable& table) {
  const Scene scene = scene_of(contest);
  // Doubles that cycle are stopped.
  const Result exact = run_once(scene, "exact", contest.events);
  const std::uint64_t most = contest.events != 0 ? contest.events : 4 * exact.events + 1000;
  std::vector<Result> best(contest.arithmetics.size());
  const bool random = std::string_view(contest.workload) == "uniform-square";  // no ties
  const bool floored = random && has_floor(contest.structure, scene);
  FloorRun floor;
  for (int round = 0; round < rounds; ++round) {
    if (floored) {
      double spent = 0;
      do {
        const FloorRun r = run_floor(contest.structure, scene, contest.events);
        spent += r.seconds;
        if (floor.seconds == 0 || r.seconds < floor.seconds) floor = r;
      } while (spent < least_seconds);
    }
    for (std::size_t i = 0; i < best.size(); ++i) {
      // The noise of a short run exceeds its time: it is repeated.
      double spent = 0;
      do {
        const Result r = run_once(scene, contest.arithmetics[i], most);
        spent += r.seconds;
        if (best[i].seconds == 0 || r.seconds < best[i].seconds) best[i] = r;
      } while (spent < least_seconds);
    }
  }
  for (std::size_t i = 0; i < best.size(); ++i) {
    const Result& r = best[i];
    const double events = static_cast<double>(r.events);
    const auto same = [&](const Result& one) {
      return !one.corrupt && one.events == exact.events && one.external == exact.external;
    };
    const double ratio = same(best[0]) && same(r) ? r.seconds / best[0].seconds : 0;
    const bool comparable = floored && same(r) && floor.events == exact.events;
    const double over_floor = comparable ? r.seconds / floor.seconds : 0;
    const double per_certificate = static_cast<double>(r.peak_bytes) /
                                   static_cast<double>(std::max<std::uint64_t>(1, r.max_live));
    std::uint64_t asked = 0;
    for (std::uint64_t count : r.failures) asked += count;
    table.row({contest.structure, contest.workload, contest.degree, contest.n,
               contest.arithmetics[i], r.events, r.seconds, events / r.seconds,
               contest.arithmetics[0], ratio, over_floor, per_certificate, asked, r.failures[1],
               r.failures[3]});
  }
}

}  // namespace

int main(int argc, char** argv) {
  const auto options = bench_options(argc, argv);
  if (!options) return 2;
  const bool smoke = options->smoke;
  ResultTable table(
      *options, "speed",
      "Whole runs, without log and digest: time over that of the first arithmetic (0: "
      "they handle other events, or come to no end), and over that of the least program for the "
      "same events (0: there is none, or it handles others), failure times asked for, and "
      "those that 128 bits or big integers had to answer.",
      {{"structure", ResultTable::kText, 22},
       {"scene", ResultTable::kText, 18},
       {"degree", 0},
       {"n", 0, 7},
       {"arithmetic", ResultTable::kText},
       {"events", 0, 9},
       {"seconds", 4},
       {"events_per_second", 0},
       {"first", ResultTable::kText, 6},
       {"time_over_first", 3},
       {"time_over_floor", 3},
       {"bytes_per_certificate", 1},
       {"failure_times", 0},
       {"wide", 0, 6},
       {"exact", 0, 6}});
  for (const lab::FamilyExperiments& family : lab::experiment_families()) {
    if (family.speed == nullptr) continue;
    for (const lab::SpeedRow& contest : family.speed(smoke ? 100 : 1)) {
      const std::string row = std::string(contest.structure) + " " + std::string(contest.workload) +
                              " " + std::to_string(contest.degree) + " " +
                              std::to_string(contest.n);
      if (row.find(options->rows) == row.npos) continue;
      run_contest(contest, smoke ? 1 : 3, smoke ? 0 : 0.3, table);
    }
  }
  return 0;
}
