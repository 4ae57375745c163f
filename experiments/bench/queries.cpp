// SPDX-License-Identifier: GPL-3.0-or-later
// Question: how long does a query for a box take, and how long for each node that it looks at? How
//   long do the trees take to follow a swap in their lists?
// Workload: n random points of the unit square right after the start. Boxes with
//   sides of coordinates of points: small ones, with about 100 points, and thin ones across the
//   whole square, likewise. The corners are placed and the answers' memory is there beforehand.
// Time: the mean of a query, and that over the nodes looked at, searches in the lists included;
//   thread CPU time, the best of the rounds. `built`: seconds until the first answer.
// Swaps: the first ones of the same scene, in rounds of which the best counts. `own`: the time of a
//   swap beyond that of the first row, the lists alone.
// Output: see result_table.h; options: see bench_options.h (--rows: of "structure boxes n", or of
//   "structure swaps n").
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/engine/simulator.h"
#include "experiments/lab/bench_row.h"
#include "experiments/lab/bench_run.h"
#include "experiments/lab/cpu_clock.h"
#include "experiments/lab/result_table.h"
#include "experiments/lab/workload_parts.h"
#include "structures/parts/range_search.h"
#include "structures/plan.h"
#include "structures/registry.h"

namespace {

using namespace kinex;

struct Box {
  std::vector<Rational> low, high;
};

// `width` and `height` count points of the order by x and by y.
std::vector<Box> boxes(const Snapshot& now, std::size_t width, std::size_t height, int count) {
  std::vector<Rational> x, y;
  for (ObjectId id = 0; id < now.objects(); ++id) {
    x.push_back(now.position(id, 0));
    y.push_back(now.position(id, 1));
  }
  std::sort(x.begin(), x.end());
  std::sort(y.begin(), y.end());
  lab::WorkloadRandom random(now.objects());
  std::vector<Box> result;
  for (int i = 0; i < count; ++i) {
    const std::size_t a = random.below(x.size() - width + 1);
    const std::size_t b = random.below(y.size() - height + 1);
    result.push_back({{x[a], y[b]}, {x[a + width - 1], y[b + height - 1]}});
  }
  return result;
}

// "structure boxes n", or "structure swaps n": is it asked for?
bool is_asked(const lab::BenchRow& row, const char* what, const lab::BenchOptions& options) {
  const std::string text =
      std::string(row.structure) + " " + what + " " + std::to_string(row.parameters.n);
  return text.find(options.rows) != std::string::npos;
}

void time_queries(const lab::BenchRow& row, const lab::BenchOptions& options,
                  lab::ResultTable& table) {
  if (!is_asked(row, "small", options) && !is_asked(row, "thin", options)) return;
  const Scene scene = lab::scene_of(row);
  SimulatorOptions simulator_options;
  simulator_options.audit = AuditLevel::kNone;
  Simulator simulator(scene, planned_arithmetic("exact", scene), simulator_options);
  add_structures(simulator, scene);
  simulator.start();
  auto& tree = dynamic_cast<RangeSearch&>(simulator.structure(asked_structure(scene)));
  Kernel& kernel = simulator.kernel();
  const Snapshot now = simulator.snapshot(scene.start);
  const std::vector<Rational> origin(2);
  const ObjectId low = kernel.constant("low", origin), high = kernel.constant("high", origin);
  std::vector<ObjectId> found;
  const auto n = static_cast<std::size_t>(row.parameters.n);
  found.reserve(n);
  QueryCounts ignored;
  const double first = lab::cpu_seconds();
  tree.report(low, high, found, ignored);
  const double built = lab::cpu_seconds() - first;
  const auto some = std::min<std::size_t>(n, 100);
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(n * some)));
  for (const bool thin : {false, true}) {
    const char* const kind = thin ? "thin" : "small";
    if (!is_asked(row, kind, options)) continue;
    double best = 0;
    std::uint64_t points = 0;
    QueryCounts counts;
    const std::vector<Box> asked =
        boxes(now, thin ? n : side, thin ? some : side, options.smoke ? 4 : 200);
    for (int round = 0; round < row.rounds; ++round) {
      double seconds = 0;
      points = 0;
      counts = {};
      for (const Box& box : asked) {
        kernel.redefine(low, "low", box.low);
        kernel.redefine(high, "high", box.high);
        found.clear();
        const double begin = lab::cpu_seconds();
        tree.report(low, high, found, counts);
        seconds += lab::cpu_seconds() - begin;
        points += found.size();
      }
      if (round == 0 || seconds < best) best = seconds;
    }
    const auto count = static_cast<double>(asked.size());
    table.row({row.structure, kind, row.parameters.n, 1e6 * best / count,
               static_cast<double>(points) / count, static_cast<double>(counts.nodes) / count,
               static_cast<double>(counts.signs) / count,
               1e9 * best / static_cast<double>(counts.nodes), built});
  }
}

// ---- swaps

// The changes of the lists: of the structures that read no other.
std::uint64_t swaps_of(const Scene& scene, const lab::BenchRun& run) {
  std::uint64_t swaps = 0;
  const std::vector<PlannedStructure> plan = plan_structures(scene);
  for (std::size_t id = 0; id < plan.size(); ++id) {
    if (find_structure_info(plan[id].request.structure)->reads.empty()) {
      swaps += run.structures[id].external;
    }
  }
  return swaps;
}

// Rows of one size; the first has the lists alone.
void time_swaps(const std::vector<lab::BenchRow>& rows, const lab::BenchOptions& options,
                lab::ResultTable& table) {
  std::vector<lab::BenchRow> asked;
  for (const lab::BenchRow& row : rows) {
    if (asked.empty() || is_asked(row, "swaps", options)) asked.push_back(row);
  }
  const bool first_is_asked = is_asked(rows.front(), "swaps", options);
  if (asked.size() == 1 && !first_is_asked) return;
  std::vector<Scene> scenes;
  std::vector<std::function<lab::BenchRun()>> ways;
  for (const lab::BenchRow& row : asked) scenes.push_back(lab::scene_of(row));
  for (const Scene& scene : scenes) {
    ways.emplace_back([&] { return lab::run_once(scene, {.events = rows.front().events}); });
  }
  const std::vector<lab::BenchRun> best = lab::best_of_rounds(ways, {.count = rows.front().rounds});
  for (std::size_t i = first_is_asked ? 0 : 1; i < asked.size(); ++i) {
    const std::uint64_t swaps = swaps_of(scenes[i], best[i]);
    const auto count = static_cast<double>(swaps);
    table.row({asked[i].structure, asked[i].parameters.n, swaps, best[i].seconds,
               count / best[i].seconds, 1e9 * (best[i].seconds - best[0].seconds) / count});
  }
}

void queries(const lab::BenchOptions& options) {
  lab::ResultTable table(
      options, "queries",
      "Queries for boxes in `exact`: processor time of one, with its output, and what "
      "it looks at; means. built: seconds of the first query.",
      {{"structure", lab::ResultTable::kText, 22},
       {"boxes", lab::ResultTable::kText, 6},
       {"n", 0, 7},
       {"microseconds", 2},
       {"points", 1},
       {"nodes", 1},
       {"signs", 1},
       {"nanoseconds_a_node", 1},
       {"built", 2}});
  lab::BenchOptions all = options;
  all.rows.clear();
  for (const lab::BenchRow& row : lab::bench_rows("queries", all)) {
    time_queries(row, options, table);
  }
  lab::ResultTable swaps(
      options, "queries_swaps",
      "Swaps in the lists of both coordinates, with the trees that follow them: a "
      "second, and nanoseconds of a swap beyond those of the lists.",
      {{"structure", lab::ResultTable::kText, 22},
       {"n", 0, 7},
       {"swaps", 0, 8},
       {"seconds", 3},
       {"swaps_per_second", 0},
       {"own", 0, 7}});
  std::vector<lab::BenchRow> of_one_size;
  for (const lab::BenchRow& row : lab::bench_rows("queries_swaps", all)) {
    if (!of_one_size.empty() && of_one_size[0].parameters.n != row.parameters.n) {
      time_swaps(of_one_size, options, swaps);
      of_one_size.clear();
    }
    of_one_size.push_back(row);
  }
  if (!of_one_size.empty()) time_swaps(of_one_size, options, swaps);
}

}  // namespace

int main(int argc, char** argv) { return kinex::lab::bench_main(argc, argv, queries); }
