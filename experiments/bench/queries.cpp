// SPDX-License-Identifier: GPL-3.0-or-later
// Question: how long does a query for a box take, and how long for each node that it looks at? How
//   long do the trees take to follow a swap in their lists?
// Workload: n random points of the unit square (uniform-square) right after the start. Boxes with
//   sides of coordinates of points: small ones, with about 100 points, and thin ones across the
//   whole square, likewise. The corners are placed and the answers' memory is there beforehand.
// Time: the mean of a query, and that over the nodes looked at, searches in the lists included; thread CPU time, the best of the rounds. `built`: seconds until the
//   first answer.
// Swaps: the first ones of the same scene, in rounds of which the best counts. `own`: the time of a
//   swap beyond that of the two lists alone.
// Output: see result_table.h; options: see options.h (--rows: of "structure boxes n", or of
//   "structure swaps n").
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
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
               1e9 * best / static_cast<double>(counts.nodes), built});
  }
}

// ---- swaps

struct Following {
  const char* name;
  std::vector<Request> trees;  // none: the lists alone
};

std::vector<Following> followings() {
  const Request x{"sorted_list", "x", {}};
  Request y{"sorted_list", "y", {}};
  y.key.kind = Key::Kind::kCoordinate;
  y.key.axis = 1;
  const Request range{"range_tree_2", "range", {}}, rank{"rank_kd_tree_2", "rank", {}},
      pseudo{"pseudo_kd_tree_2", "pseudo", {}};
  return {{"lists", {x, y}},
          {"range_tree_2", {range}},
          {"rank_kd_tree_2", {rank}},
          {"pseudo_kd_tree_2", {pseudo}},
          {"all three", {range, rank, pseudo}}};
}

struct Swaps {
  std::uint64_t count = 0;
  double seconds = 0;
};

Swaps run_swaps(Scene scene, const std::vector<Request>& requests, std::uint64_t most) {
  scene.maintain = requests;
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  options.max_events = most;
  Simulator simulator(scene, planned_arithmetic("exact", scene), options);
  add_structures(simulator, scene);
  simulator.start();
  const double begin = lab::cpu_seconds();
  simulator.run_until(scene.end);
  Swaps result;
  result.seconds = lab::cpu_seconds() - begin;
  for (StructureId id = 0; id < simulator.structures(); ++id) {
    if (simulator.structure(id).name() == "sorted_list") {
      result.count += simulator.ledger(id).external;
    }
  }
  return result;
}

void time_swaps(int n, std::uint64_t most, const BenchOptions& options, ResultTable& table) {
  lab::WorkloadParameters parameters;
  parameters.n = n;
  const Scene scene = lab::generate_scene("uniform-square", parameters, "range_tree_2");
  std::vector<Following> asked = followings();
  const auto is_asked = [&](const Following& following) {
    const std::string name = std::string(following.name) + " swaps " + std::to_string(n);
    return name.find(options.rows) != name.npos;
  };
  if (std::none_of(asked.begin(), asked.end(), is_asked)) return;
  std::vector<Swaps> best(asked.size());
  for (int round = 0; round < (options.smoke ? 1 : 5); ++round) {
    for (std::size_t i = 0; i < asked.size(); ++i) {
      if (i > 0 && !is_asked(asked[i])) continue;
      const Swaps swaps = run_swaps(scene, asked[i].trees, most);
      if (round == 0 || swaps.seconds < best[i].seconds) best[i] = swaps;
    }
  }
  for (std::size_t i = 0; i < asked.size(); ++i) {
    if (!is_asked(asked[i])) continue;
    const auto count = static_cast<double>(best[i].count);
    table.row({asked[i].name, n, best[i].count, best[i].seconds, count / best[i].seconds,
               1e9 * (best[i].seconds - best[0].seconds) / count});
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
       {"nanoseconds_a_node", 1},
       {"built", 2}});
  const int scale = options->smoke ? 1000 : 1;
  for (const char* structure :
       {"range_tree_2", "rank_kd_tree_2", "pseudo_kd_tree_2", "trajectory_tree"}) {
    time_queries({structure, 100000 / scale}, *options, table);
  }
  ResultTable swaps(*options, "queries_swaps",
                    "Swaps in the lists of both coordinates, with the trees that follow them: a "
                    "second, and nanoseconds of a swap beyond those of the lists.",
                    {{"structure", ResultTable::kText, 22},
                     {"n", 0, 7},
                     {"swaps", 0, 8},
                     {"seconds", 3},
                     {"swaps_per_second", 0},
                     {"own", 0, 7}});
  for (const int n : {2000, 100000}) {
    time_swaps(n / scale, static_cast<std::uint64_t>(400000 / scale), *options, swaps);
  }
  return 0;
}
