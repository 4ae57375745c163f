// SPDX-License-Identifier: GPL-3.0-or-later
// Question: what does a query for a box cost: nodes, points found, time?
// Sources: structures/range/*.h: O(log^2 n) nodes of a range tree, O(sqrt(n)) of a kd-tree on ranks
//   (50 sqrt(N) + 1 at most), O(n^(1/2 + eps)) of a pseudo kd-tree, O(n^0.695 log n) of a tree over
//   trajectories, beside those of the points that are found.
// Scene: n random points of the unit square; boxes whose sides are coordinates of points, at two
//   times of their motion.
// Expected: every hard bound, and equal answers of all trees.
// Cost: seconds.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "core/engine/simulator.h"
#include "experiments/families/range/experiments.h"
#include "experiments/lab/cpu_clock.h"
#include "experiments/lab/curves.h"
#include "experiments/lab/study_runs.h"
#include "experiments/lab/workload_parts.h"
#include "structures/parts/range_search.h"
#include "structures/plan.h"

namespace kinex::families {
namespace {

struct TreeName {
  const char* label;
  const char* structure;
  const char* delta;  // empty: no parameter
  int per_point;      // nodes for each point reported, at most
};
constexpr TreeName kCompared[] = {{"range tree", "range_tree_2", "", 1},
                               {"kd-tree on ranks", "rank_kd_tree_2", "", 2},
                               {"pseudo kd-tree, 1/4", "pseudo_kd_tree_2", "1/4", 2},
                               {"kd-tree, exact medians", "pseudo_kd_tree_2", "0", 2},
                               {"tree over trajectories", "trajectory_tree", "", 0}};

struct QueryCost {  // of boxes on n points
  struct Mean {
    double nodes = 0;  // beside those of the points that are found
    double signs = 0;
    double microseconds = 0;
  };
  int n = 0;
  double found = 0;  // points, the mean
  std::array<Mean, std::size(kCompared)> trees{};
  bool agree = true;
  std::vector<BoundCheck> broken;
};

QueryCost cost_of(int n, lab::StudyResult& study) {
  lab::WorkloadParameters parameters;
  parameters.n = n;
  Scene scene = lab::generate_scene("uniform-square", parameters, "sorted_list");
  scene.maintain.clear();
  for (const TreeName& tree : kCompared) {
    scene.maintain.push_back({tree.structure, tree.label, {}});
    if (*tree.delta == '\0') continue;
    scene.maintain.back().parameters = {{"delta", *Rational::parse(tree.delta)}};
  }
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  Simulator simulator(scene, planned_arithmetic("exact", scene), options);
  add_structures(simulator, scene);
  simulator.start();
  std::vector<RangeSearch*> trees;
  for (StructureId id = 0; id < simulator.structures(); ++id) {
    if (auto* tree = dynamic_cast<RangeSearch*>(&simulator.structure(id))) trees.push_back(tree);
  }
  Kernel& kernel = simulator.kernel();
  const std::vector<Rational> origin{Rational(0), Rational(0)};
  const ObjectId low = kernel.constant("low", origin), high = kernel.constant("high", origin);
  lab::WorkloadRandom random(static_cast<std::uint64_t>(n));
  QueryCost result;
  result.n = n;
  constexpr int kInstants = 2, kBoxes = 200, kQueries = kInstants * kBoxes;
  for (int instant = 0; instant < kInstants; ++instant) {
    // Few swaps: the scene's first part.
    const Rational t = lab::fraction(instant, 64);
    simulator.run_until(t);
    const Snapshot now = simulator.snapshot(t);
    for (int box = 0; box < kBoxes; ++box) {
      std::vector<Rational> least, most;
      for (const int axis : {0, 1}) {
        const auto side = [&]() -> Rational {
          return now.position(static_cast<ObjectId>(random.below(static_cast<std::uint64_t>(n))),
                              axis);
        };
        Rational a = side(), b = side();
        if (b < a) std::swap(a, b);
        least.push_back(a);
        most.push_back(b);
      }
      kernel.redefine(low, "low", least);
      kernel.redefine(high, "high", most);
      std::vector<ObjectId> first;
      for (std::size_t i = 0; i < trees.size(); ++i) {
        std::vector<ObjectId> found;
        QueryCounts counts;
        const double begin = lab::cpu_seconds();
        trees[i]->report(low, high, found, counts);
        const double seconds = lab::cpu_seconds() - begin;
        // The first query of all builds the trees that are built when they are asked.
        const bool is_timed = instant > 0 || box > 0;
        QueryCost::Mean& mean = result.trees[i];
        const auto nodes = static_cast<double>(counts.nodes);
        const auto reported = static_cast<double>(found.size());
        mean.nodes += std::max(0.0, nodes - kCompared[i].per_point * reported) / kQueries;
        mean.signs += static_cast<double>(counts.signs) / kQueries;
        if (is_timed) mean.microseconds += 1e6 * seconds / (kQueries - 1);
        std::sort(found.begin(), found.end());
        if (i == 0) {
          first = found;
          result.found += reported / kQueries;
        }
        result.agree = result.agree && found == first;
      }
    }
  }
  lab::check_run(simulator, scene.name, study);
  for (StructureId id = 0; id < simulator.structures(); ++id) {
    for (const BoundCheck& bound : simulator.bounds(id)) {
      if (!bound.holds) result.broken.push_back(bound);
    }
  }
  return result;
}

}  // namespace

lab::StudyResult study_query_cost(bool quick, const std::function<bool()>& go_on) {
  lab::StudyResult result;
  result.name = "range_search";
  result.table.title = "range search: the cost of a query for a box, means of 400";
  result.table.header = {"n",
                         "points found",
                         "tree",
                         "nodes beside those of the points",
                         "signs",
                         "microseconds",
                         "nodes over sqrt(n)"};
  result.table.note =
      "nodes of the points: one each in the range tree, two in a kd-tree, none in the tree over "
      "trajectories, which counts the points that it tests; microseconds: of processor time, with "
      "the "
      "points found";
  for (const int n : {64, 256, 1024, 4096}) {
    if (quick && n > 1024) continue;
    if (!go_on()) return result;
    const QueryCost cost = cost_of(n, result);
    for (std::size_t i = 0; i < cost.trees.size(); ++i) {
      const QueryCost::Mean& mean = cost.trees[i];
      result.table.rows.push_back({std::to_string(n), fmt::format("{:.1f}", cost.found),
                                   kCompared[i].label, fmt::format("{:.1f}", mean.nodes),
                                   fmt::format("{:.1f}", mean.signs),
                                   fmt::format("{:.2f}", mean.microseconds),
                                   fmt::format("{:.2f}", mean.nodes / std::sqrt(n))});
    }
    result.checks.push_back({fmt::format("range.answers.{}", n), "witness", "", "equal answers",
                             cost.agree ? "400 boxes, all equal" : "they differ",
                             "three searches: in a range tree, in three kd-trees, and over "
                             "trajectories; the first two share "
                             "how a box becomes labels",
                             cost.agree ? lab::Verdict::kConfirmed : lab::Verdict::kRefuted,
                             std::nullopt});
    result.checks.push_back(
        {fmt::format("range.queries.{}", n), "bound", "", "every hard bound",
         cost.broken.empty()
             ? "all hold"
             : cost.broken.front().id + ": " + cost.broken.front().observed.to_string(),
         "nodes looked at, touched by a swap, and stored: see structures/range",
         cost.broken.empty() ? lab::Verdict::kConfirmed : lab::Verdict::kRefuted, std::nullopt});
  }
  return result;
}

constexpr const char* kScene = "Random boxes, points of uniform-square";

// Drawn from queries of its own: the cells have none.
std::vector<lab::Figure> query_cost_figures(const std::vector<lab::CellResult>& cells) {
  const bool is_asked = std::any_of(cells.begin(), cells.end(), [](const lab::CellResult& result) {
    return result.cell.workload == "plane-sort-worst";
  });
  if (!is_asked) return {};
  std::vector<lab::Curve> nodes, times;
  for (const TreeName& tree : kCompared) {
    nodes.push_back({tree.label, {}, ""});
    times.push_back({tree.label, {}, ""});
  }
  lab::Curve found{"points found", {}, ""};
  for (const int n : {16, 64, 256, 1024}) {
    lab::StudyResult runs;
    const QueryCost cost = cost_of(n, runs);
    if (!runs.checks.empty()) continue;  // it failed: nothing is drawn of it
    const auto x = static_cast<double>(n);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (cost.trees[i].nodes > 0) nodes[i].points.push_back({x, cost.trees[i].nodes, 0});
      times[i].points.push_back({x, cost.trees[i].microseconds, 0});
    }
    found.points.push_back({x, cost.found, 0});
  }
  nodes.push_back(std::move(found));
  lab::Figure figure;
  figure.title = kQueryCostTitle;
  figure.caption =
      "Left: nodes that a query looks at, beside those of the points that it finds (one each in "
      "the "
      "range tree, two in a kd-tree), and these points. Right: its processor time. Means of 400 "
      "random "
      "boxes on n random points.";
  lab::set_curves(figure, {.x = "points n", .y = "nodes a query", .slopes = {0.5}, .title = kScene}, nodes);
  lab::Figure time;
  time.title = figure.title;
  time.joins = true;
  lab::set_curves(time, {.x = "points n", .y = "microseconds a query", .slopes = {}, .title = kScene}, times);
  return {figure, time};
}

}  // namespace kinex::families
