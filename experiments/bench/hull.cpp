// SPDX-License-Identifier: GPL-3.0-or-later
// Question: what does the kinetic convex hull cost: events per second in `exact` and in `double`,
//   time per event and level of the tree, building, memory; and what do the other methods cost?
// Workload: uniform-square (origin and destination uniform in the unit square, t in [0, 1]). Rounds
//   of different arithmetics are interleaved; the best of each counts; times are thread CPU time;
//   n = 1,000,000 is built and run for a limited number of events.
// Output: see result_table.h; options: see options.h.
#include <sys/resource.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
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
  int n;
  int rounds;
  std::uint64_t events;  // the run stops after this many; 0: at the end of the scene
};

struct Result {
  std::uint64_t events = 0;
  double build = 0, run = 0;
  std::uint64_t bytes = 0, live = 0, per_object = 0;
  std::uint64_t changed = 0, signs = 0;  // certificates and signs, by events
};

std::uint64_t signs_so_far(const Simulator& simulator) {
  std::uint64_t sum = 0;
  for (const PredicateCounters& predicate :
       simulator.arithmetic().counters().by_predicate) {
    for (const std::uint64_t count : predicate.signs) sum += count;
  }
  return sum;
}

Scene scene_of(const Contest& contest) {
  lab::WorkloadParameters parameters;
  parameters.n = contest.n;
  parameters.seed = 1;
  parameters.degree = 1;
  parameters.dimension = 2;
  Scene scene = lab::generate_scene(*lab::find_workload("uniform-square"), parameters);
  scene.maintain = {{contest.structure, contest.structure, {}}};
  return scene;
}

Result measure(const Scene& scene, const char* arithmetic, std::uint64_t events) {
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  options.max_events = events;
  Simulator simulator(scene, planned_arithmetic(arithmetic, scene), options);
  add_structures(simulator, scene);
  Result result;
  const double start = lab::cpu_seconds();
  simulator.start();
  const std::uint64_t signs = signs_so_far(simulator);
  const double built = lab::cpu_seconds();
  simulator.run_until(std::nullopt);
  result.build = built - start;
  result.run = lab::cpu_seconds() - built;
  result.events = simulator.ledger().events;
  result.bytes = simulator.ledger().peak_bytes;
  result.signs = signs_so_far(simulator) - signs;
  for (std::size_t i = 0; i < simulator.structures(); ++i) {
    const StructureLedger& ledger = simulator.ledger(static_cast<StructureId>(i));
    result.live += ledger.max_live;
    result.changed += ledger.created_per_event.total + ledger.retracted_per_event.total;
    result.per_object = std::max(result.per_object, ledger.max_per_object);
  }
  return result;
}

// The peak memory of this process so far; contests grow.
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

void add_row(const Contest& contest, const Result& exact, const Result& plain, ResultTable& table) {
  const double levels = levels_of(contest.n);
  const double events = static_cast<double>(std::max<std::uint64_t>(exact.events, 1));
  const double each = exact.run / events;
  table.row({contest.structure, contest.n, exact.events, exact.build, exact.run, 1 / each,
             plain.run > 0 ? exact.run / plain.run : 0, 1e9 * each, 1e9 * each / levels,
             static_cast<double>(exact.bytes) / 1e6, process_megabytes(), exact.live,
             exact.per_object});
}

// The cost of an event, in machine-independent counts and in time; each by level of the tree.
void add_growth(const Contest& contest, const Result& exact, ResultTable& table) {
  const double levels = levels_of(contest.n);
  const double events = static_cast<double>(std::max<std::uint64_t>(exact.events, 1));
  const double changed = static_cast<double>(exact.changed) / events;
  const double signs = static_cast<double>(exact.signs) / events;
  table.row({contest.n, levels, changed, changed / levels, signs, signs / levels,
             1e9 * exact.run / events / levels});
}

struct Aim {
  std::string what;
  double wanted, measured;
  bool at_most;
};

void add_aims(const std::vector<Aim>& aims, const BenchOptions& options) {
  ResultTable table(options, "hull_aims", "Aims.",
                    {{"aim", ResultTable::kText, 40},
                     {"wanted", 2, 10},
                     {"measured", 2, 10},
                     {"met", ResultTable::kText, 4}});
  for (const Aim& aim : aims) {
    const bool met = aim.at_most ? aim.measured <= aim.wanted : aim.measured >= aim.wanted;
    table.row({aim.what, aim.wanted, aim.measured, met ? "yes" : "no"});
  }
}

}  // namespace

int main(int argc, char** argv) {
  const auto options = bench_options(argc, argv);
  if (!options) return 2;
  std::vector<Contest> contests{
      {"convex_hull_2", 1000, 5, 0},         {"convex_hull_2", 10000, 5, 0},
      {"convex_hull_2", 100000, 2, 0},       {"convex_hull_2", 1000000, 1, 1000000},
      {"convex_hull_2_naive", 10000, 3, 0},  {"convex_hull_2_brute_force", 1000, 3, 0},
      {"convex_hull_2_delaunay", 1000, 3, 0}};
  if (options->smoke) {
    contests = {{"convex_hull_2", 50, 1, 0},
                {"convex_hull_2_naive", 50, 1, 0},
                {"convex_hull_2_brute_force", 20, 1, 0},
                {"convex_hull_2_delaunay", 20, 1, 0}};
  }
  std::vector<std::pair<Contest, Result>> growth;
  std::vector<Aim> aims;
  {
    ResultTable table(
        *options, "hull",
        "Kinetic convex hulls on uniform-square, in exact arithmetic; time over double.",
        {{"structure", ResultTable::kText, 25},
         {"n", 0, 8},
         {"events", 0, 9},
         {"build_seconds", 3},
         {"seconds", 3},
         {"events_per_second", 0},
         {"time_over_double", 2},
         {"ns_per_event", 0},
         {"ns_per_event_and_level", 0},
         {"megabytes", 1},
         {"process_megabytes", 0},
         {"certificates", 0},
         {"most_per_point", 0}});
    for (const Contest& contest : contests) {
      const Scene scene = scene_of(contest);
      Result best[2];
      for (int round = 0; round < contest.rounds; ++round) {
        for (const int which : {0, 1}) {
          const Result result = measure(scene, which == 0 ? "exact" : "double", contest.events);
          if (round == 0 || result.run < best[which].run) best[which] = result;
        }
      }
      add_row(contest, best[0], best[1], table);
      if (std::string(contest.structure) != "convex_hull_2") continue;
      growth.emplace_back(contest, best[0]);
      const double events = static_cast<double>(best[0].events);
      if (contest.n == 10000) {
        aims.push_back({"events per second at n = 10,000", 500000, events / best[0].run, false});
        aims.push_back({"exact / double at n = 10,000", 1.25, best[0].run / best[1].run, true});
      } else if (contest.n == 1000000) {
        aims.push_back({"events run at n = 1,000,000", 1e6, events, false});
        aims.push_back({"megabytes at n = 1,000,000", 8000, process_megabytes(), true});
      }
    }
  }
  {
    ResultTable table(*options, "hull_growth",
                      "Per event of convex_hull_2, and per event and level: certificates created "
                      "and retracted, signs, time. What grows like log n is constant per level.",
                      {{"n", 0, 8},
                       {"levels", 0},
                       {"certificates_changed", 2},
                       {"certificates_per_level", 3},
                       {"signs", 2},
                       {"signs_per_level", 3},
                       {"ns_per_level", 0}});
    for (const auto& [contest, result] : growth) add_growth(contest, result, table);
  }
  if (!aims.empty()) add_aims(aims, *options);
  return 0;
}
