// SPDX-License-Identifier: GPL-3.0-or-later
// Question: what does the kinetic convex hull cost: events per second in `exact` and in `double`,
// time per event and level of the tree, building, memory; and what do the other methods cost?
// Workload: uniform-square (origin and destination uniform in the unit square, t in [0, 1]).
// Rounds of different arithmetics are interleaved; the best of each is taken; times are thread CPU
// time. Output: a table on stdout, or JSON lines with --json. --smoke: tiny sizes, for the test
// suite. n = 1,000,000 is built and run for a while only.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "core/simulator.h"
#include "experiments/bench/options.h"
#include "experiments/cpu_clock.h"
#include "experiments/workload.h"
#include "structures/plan.h"

namespace {

using namespace kinex;

struct Contest {
  const char* structure;
  int n;
  int rounds;
  std::uint64_t events;  // the run stops after so many; 0: at the end of the scene
};

struct Result {
  std::uint64_t events = 0;
  double build = 0, run = 0;
  std::uint64_t bytes = 0, live = 0, per_object = 0;
};

Scene scene_of(const Contest& contest) {
  WorkloadParameters parameters;
  parameters.n = contest.n;
  parameters.seed = 1;
  parameters.degree = 1;
  parameters.dimension = 2;
  Scene scene = generate_scene(*find_workload("uniform-square"), parameters);
  scene.maintain = {{contest.structure, contest.structure, {}}};
  return scene;
}

Result measure(const Scene& scene, const char* arithmetic, std::uint64_t events) {
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  options.max_events = events;
  Simulator simulator(scene, make_arithmetic(arithmetic, scene), options);
  add_structures(simulator, scene);
  Result result;
  const double start = cpu_seconds();
  simulator.start();
  const double built = cpu_seconds();
  simulator.run_until(std::nullopt);
  result.build = built - start;
  result.run = cpu_seconds() - built;
  result.events = simulator.ledger().events;
  result.bytes = simulator.ledger().peak_bytes;
  for (std::size_t i = 0; i < simulator.structures(); ++i) {
    const StructureLedger& ledger = simulator.kernel().ledger(static_cast<StructureId>(i));
    result.live += ledger.max_live;
    result.per_object = std::max(result.per_object, ledger.max_per_object);
  }
  return result;
}

void print(const Contest& contest, const Result& exact, const Result& plain, bool json) {
  double levels = 0;
  for (int k = 1; k < contest.n; k *= 2) ++levels;
  const double events = static_cast<double>(std::max<std::uint64_t>(exact.events, 1));
  const double each = exact.run / events;
  const double ratio = plain.run > 0 ? exact.run / plain.run : 0;
  if (json) {
    std::printf(
        "{\"structure\": \"%s\", \"n\": %d, \"events\": %llu, \"build\": %.6f, \"run\": %.6f, "
        "\"events_per_second\": %.0f, \"ratio_to_double\": %.3f, \"ns_per_event\": %.1f, "
        "\"ns_per_event_and_level\": %.1f, \"bytes\": %llu, \"max_live\": %llu, "
        "\"max_per_object\": %llu}\n",
        contest.structure, contest.n, static_cast<unsigned long long>(exact.events), exact.build,
        exact.run, 1 / each, ratio, 1e9 * each, 1e9 * each / levels,
        static_cast<unsigned long long>(exact.bytes), static_cast<unsigned long long>(exact.live),
        static_cast<unsigned long long>(exact.per_object));
    return;
  }
  std::printf("%-26s %8d %9llu %8.3f %8.3f %10.0f %6.2f %8.0f %7.0f %9.1f %9llu %6llu\n",
              contest.structure, contest.n, static_cast<unsigned long long>(exact.events),
              exact.build, exact.run, 1 / each, ratio, 1e9 * each, 1e9 * each / levels,
              static_cast<double>(exact.bytes) / 1e6, static_cast<unsigned long long>(exact.live),
              static_cast<unsigned long long>(exact.per_object));
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
  if (!options->json) {
    std::printf("%-26s %8s %9s %8s %8s %10s %6s %8s %7s %9s %9s %6s\n", "structure", "n", "events",
                "build s", "run s", "events/s", "ratio", "ns/event", "/level", "MB", "certs",
                "per pt");
  }
  for (const Contest& contest : contests) {
    const Scene scene = scene_of(contest);
    Result best[2];
    for (int round = 0; round < contest.rounds; ++round) {
      for (const int which : {0, 1}) {
        const Result result = measure(scene, which == 0 ? "exact" : "double", contest.events);
        if (round == 0 || result.run < best[which].run) best[which] = result;
      }
    }
    print(contest, best[0], best[1], options->json);
  }
  return 0;
}
