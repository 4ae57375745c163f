// SPDX-License-Identifier: GPL-3.0-or-later
// Question: how many events per second does a whole run handle in `exact`, and how does that
//   compare with floating point and with the unfiltered reference, in one process on one core?
// Workload: random motion (uniform-square), scenes full of ties (lattice, meet, grid) and bodies;
//   small and large n. Without event log and digest. Rounds of different arithmetics are
//   interleaved; the best of each counts; times are thread CPU time.
// Ratio: 0 where doubles handle other events than `exact`, or do not end.
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
#include "experiments/bench/options.h"
#include "experiments/bench/result_table.h"
#include "experiments/cpu_clock.h"
#include "experiments/workload.h"
#include "structures/plan.h"
#include "structures/registry.h"

namespace {

using namespace kinex;

struct Contest {
  const char* structure;
  const char* workload;
  int degree;
  int n;
  std::vector<const char*> arithmetics;  // the first is the reference of the ratios
  std::uint64_t events = 0;              // the run stops after them; 0: at the end of the scene
  int m = 0;
  int inverse_separation = 0;  // of two bodies: 1 / separation; 0: the family's own
  int turns = -1;
};

struct Result {
  std::uint64_t events = 0, external = 0;
  bool corrupt = false;
  double seconds = 0;
  std::uint64_t peak_bytes = 0;
  std::uint64_t max_live = 0;
  StageCounts failures{};
};

Scene scene_of(const Contest& contest) {
  WorkloadParameters parameters;
  parameters.n = contest.n;
  parameters.m = contest.m;
  parameters.degree = contest.degree;
  parameters.turns = contest.turns;
  const Workload& workload = *find_workload(contest.workload);
  const std::string_view structure = contest.structure;
  const bool line = structure == "sorted_list" || structure.find("m_") != structure.npos;
  if (!workload.bodies && line && workload.min_dimension == 1) parameters.dimension = 1;
  if (contest.inverse_separation > 0) {
    parameters.separation = Rational(Integer(1), Integer(contest.inverse_separation));
  }
  Scene scene = generate_scene(workload, parameters);
  scene.maintain = {{contest.structure, contest.structure, {}}};
  return scene;
}

Result run_once(const Scene& scene, const char* arithmetic, std::uint64_t max_events) {
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  options.max_events = max_events;
  Simulator simulator(scene, make_arithmetic(arithmetic, scene), options);
  add_structures(simulator, scene);
  simulator.start();
  const double begin = cpu_seconds();
  simulator.run_until(scene.end);
  Result result;
  result.seconds = cpu_seconds() - begin;
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
void run_contest(const Contest& contest, int rounds, double least_seconds, ResultTable& table) {
  const Scene scene = scene_of(contest);
  // Doubles that cycle are stopped.
  const Result exact = run_once(scene, "exact", contest.events);
  const std::uint64_t most = contest.events != 0 ? contest.events : 4 * exact.events + 1000;
  std::vector<Result> best(contest.arithmetics.size());
  for (int round = 0; round < rounds; ++round) {
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
    const double per_certificate = static_cast<double>(r.peak_bytes) /
                                   static_cast<double>(std::max<std::uint64_t>(1, r.max_live));
    std::uint64_t asked = 0;
    for (std::uint64_t count : r.failures) asked += count;
    table.row({contest.structure, contest.workload, contest.degree, contest.n,
               contest.arithmetics[i], r.events, r.seconds, events / r.seconds,
               contest.arithmetics[0], ratio, per_certificate, asked, r.failures[1],
               r.failures[3]});
  }
}

std::vector<Contest> contests(int scale) {
  const std::vector<const char*> three{"double", "exact", "gsl"}, two{"double", "exact"},
      reference{"exact", "sturm"};
  const char* const random = "uniform-square";
  const auto n = [scale](int size) { return std::max(size / scale, 8); };
  std::vector<Contest> list{
      {"sorted_list", random, 1, n(4000), three},
      {"sorted_list", random, 2, n(2000), three},
      {"sorted_list", random, 3, n(2000), three},
      {"maximum_tournament", random, 1, n(40000), three},
      {"maximum_tournament", random, 3, n(20000), three},
      {"delaunay_2", random, 1, n(4000), three},
      {"delaunay_2", random, 2, n(1000), three},
      {"delaunay_2", random, 3, n(1000), three},
      {"delaunay_2", random, 1, n(10000), two},
      // How the cost of an event grows with n.
      {"sorted_list", random, 1, n(1000), two, 400000},
      {"sorted_list", random, 1, n(10000), two, 400000},
      {"sorted_list", random, 1, n(100000), two, 400000},
      {"delaunay_2", random, 1, n(1000), two, 50000},
      {"delaunay_2", random, 1, n(10000), two, 200000},
      {"delaunay_2", random, 1, n(100000), two, 400000},
      {"maximum_tournament", random, 1, n(1000), two},
      {"maximum_tournament", random, 1, n(10000), two},
      {"maximum_tournament", random, 1, n(100000), two},
      {"convex_hull_2", random, 1, n(1000), two},
      {"convex_hull_2", random, 1, n(10000), two},
      {"convex_hull_2", random, 2, n(1000), two},
      {"maximum_heap", random, 1, n(10000), two},
      {"maximum_hanger", random, 1, n(10000), two},
  };
  // Small scenes: the cost of a run apart from its events.
  for (const char* structure :
       {"sorted_list", "maximum_tournament", "convex_hull_2", "delaunay_2"}) {
    for (const int size : {10, 30}) {
      list.push_back({structure, random, 1, size, two});
      list.push_back({structure, random, 3, size, two});
    }
  }
  // Ties: simultaneous and degenerate events.
  for (const char* workload : {"lattice", "meet", "grid"}) {
    for (const int size : {30, n(400), n(2000)}) {
      list.push_back({"sorted_list", workload, 1, size, two});
      list.push_back({"maximum_tournament", workload, 1, size, two});
      if (size > 1000) continue;
      list.push_back({"convex_hull_2", workload, 1, size, two});
      list.push_back({"delaunay_2", workload, 1, size, two});
    }
  }
  // Bodies.
  const int turns = scale > 1 ? 2 : 100;
  for (const int size : {8, 32, n(128)}) {
    list.push_back({"separation_mixed", "polygon-gears", 1, size, two, 0, size - 1, 100, turns});
  }
  for (const char* other : {"separation_hysteresis", "closest_features", "inner_tangents"}) {
    list.push_back(
        {other, "polygon-gears", 1, n(128), two, 0, n(128) - 1, 100, scale > 1 ? 2 : 20});
  }
  list.push_back(
      {"separation_mixed", "polygon-spin-orbit", 1, n(128), two, 0, n(128) - 1, 100, turns});
  list.push_back({"separation_minkowski", "polygon-orbit", 1, n(128), two});
  list.push_back({"closest_features", "polygon-fan", 1, n(64), two});
  list.push_back({"inner_tangents", "polygon-tangents", 1, n(64), two});
  for (const int degree : {1, 2, 3}) {
    list.push_back({"separation_mixed", "polygon-random", degree, n(64), two});
  }
  for (const int size : {10, n(100), n(1000)}) {
    list.push_back({"separation_mixed", "polygons-in-box", 1, size, two});
  }
  list.push_back({"sorted_list", random, 1, n(400), reference});
  list.push_back({"delaunay_2", random, 1, n(200), reference});
  return list;
}

}  // namespace

int main(int argc, char** argv) {
  const auto options = bench_options(argc, argv);
  if (!options) return 2;
  const bool smoke = options->smoke;
  ResultTable table(
      *options, "speed",
      "Whole runs, without log and digest: time over that of the first arithmetic (0: "
      "they handle other events, or come to no end), failure times asked for, and "
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
       {"bytes_per_certificate", 1},
       {"failure_times", 0},
       {"wide", 0, 6},
       {"exact", 0, 6}});
  for (const Contest& contest : contests(smoke ? 100 : 1)) {
    run_contest(contest, smoke ? 1 : 3, smoke ? 0 : 0.3, table);
  }
  return 0;
}
