// SPDX-License-Identifier: GPL-3.0-or-later
// Question: how long does a query for a box take, and how long beside its output?
// Workload: n random points of the unit square (uniform-square) right after the start. Boxes with
//   sides of coordinates of points: small ones, with about 100 points, and thin ones across the
//   whole square, likewise. The corners are placed and the answers' memory is there beforehand.
// Time: the mean of a query; thread CPU time, the best of the rounds. `built`: seconds until the
//   first answer.
// Output: see result_table.h; options: see options.h (--rows: of "structure boxes n").
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "core/engine/simulator.h"
#include "experiments/bench/options.h"
#include "experiments/bench/result_table.h"
#include "experiments/lab/cpu_clock.h"
#include "experiments/lab/workload.h"
#include "experiments/lab/workload_parts.h"
#include "structures/parts/range_search.h"
#include "structures/plan.h"

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

struct Row {
  const char* structure;
  int n;
};

void time_queries(const Row& row, const BenchOptions& options, ResultTable& table) {
  const bool smoke = options.smoke;
  const auto is_asked = [&](const char* kind) {
    const std::string name = std::string(row.structure) + " " + kind + " " + std::to_string(row.n);
    return name.find(options.rows) != name.npos;
  };
  if (!is_asked("small") && !is_asked("thin")) return;
  lab::WorkloadParameters parameters;
  parameters.n = row.n;
  Scene scene = lab::generate_scene("uniform-square", parameters, row.structure);
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
  found.reserve(static_cast<std::size_t>(row.n));
  QueryCounts ignored;
  const double first = lab::cpu_seconds();
  tree.report(low, high, found, ignored);
  const double built = lab::cpu_seconds() - first;
  const auto n = static_cast<std::size_t>(row.n);
  const auto some = std::min<std::size_t>(n, 100);
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(n * some)));
  for (const bool thin : {false, true}) {
    const char* const kind = thin ? "thin" : "small";
    if (!is_asked(kind)) continue;
    double best = 0;
    std::uint64_t points = 0;
    QueryCounts counts;
    const std::vector<Box> asked = boxes(now, thin ? n : side, thin ? some : side, smoke ? 4 : 200);
    for (int round = 0; round < (smoke ? 1 : 5); ++round) {
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
    table.row({row.structure, kind, row.n, 1e6 * best / count, static_cast<double>(points) / count,
               static_cast<double>(counts.nodes) / count, static_cast<double>(counts.signs) / count,
               built});
  }
}

}  // namespace

int main(int argc, char** argv) {
  const auto options = bench_options(argc, argv);
  if (!options) return 2;
  ResultTable table(
      *options, "queries",
      "Queries for boxes in `exact`: processor time of one, with its output, and what "
      "it looks at; means. built: seconds of the first query.",
      {{"structure", ResultTable::kText, 22},
       {"boxes", ResultTable::kText, 6},
       {"n", 0, 7},
       {"microseconds", 2},
       {"points", 1},
       {"nodes", 1},
       {"signs", 1},
       {"built", 2}});
  const int scale = options->smoke ? 1000 : 1;
  for (const char* structure :
       {"range_tree_2", "rank_kd_tree_2", "pseudo_kd_tree_2", "trajectory_tree"}) {
    time_queries({structure, 100000 / scale}, *options, table);
  }
  return 0;
}
