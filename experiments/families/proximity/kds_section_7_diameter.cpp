// SPDX-License-Identifier: GPL-3.0-or-later
// Question: how many edges does the longest path of a minimum spanning tree of random points have?
//   It decides what a proof by cycles costs: each edge outside the tree is compared with all edges of
//   the path between its ends. (Not in Guibas's report, 1998, section 7, which asks for an efficient
//   structure.)
// Scenes: n independent uniform points of the unit square, at t = 0 of random motion.
// Parameters: n from 50 to 3200, to 800 in a quick run; 16 scenes, 8 in a quick run.
// Expected: nothing; a power of n is fitted.
// Cost: seconds.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/engine/simulator.h"
#include "experiments/families/points/kds_claims.h"
#include "experiments/families/proximity/experiments.h"
#include "experiments/lab/claim_check.h"
#include "experiments/lab/growth_words.h"
#include "experiments/lab/scene_run.h"
#include "experiments/lab/statistics.h"
#include "experiments/lab/study_runs.h"
#include "experiments/lab/workload.h"
#include "structures/plan.h"

namespace kinex::families {

namespace {

constexpr const char* kTree = "emst_list";

// Of a tree on the objects 0 .. n - 1: the object that is farthest from `start`, and how far.
std::pair<ObjectId, int> farthest(const std::vector<std::vector<ObjectId>>& neighbours,
                                  ObjectId start) {
  std::vector<int> distance(neighbours.size(), -1);
  std::vector<ObjectId> reached{start};
  distance[start] = 0;
  for (std::size_t i = 0; i < reached.size(); ++i) {
    for (const ObjectId next : neighbours[reached[i]]) {
      if (distance[next] >= 0) continue;
      distance[next] = distance[reached[i]] + 1;
      reached.push_back(next);
    }
  }
  return {reached.back(), distance[reached.back()]};
}

// The audit looks at all pairs of points.
constexpr int kLargestAudited = 800;

// The edges of the longest path of the tree of random points.
int tree_diameter(int n, std::uint64_t seed, lab::StudyResult& study) {
  const Scene scene = lab::generate_scene("uniform-square", {.n = n, .seed = seed}, kTree);
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  const auto simulator = lab::make_simulator(scene, "exact", options);
  simulator->start();
  if (n <= kLargestAudited) lab::check_run(*simulator, scene.name, study);
  const std::vector<ObjectId> edges =
      simulator->structure(asked_structure(scene)).attribute().ids;
  std::vector<std::vector<ObjectId>> neighbours(static_cast<std::size_t>(n));
  for (std::size_t i = 0; i + 1 < edges.size(); i += 2) {
    neighbours[edges[i]].push_back(edges[i + 1]);
    neighbours[edges[i + 1]].push_back(edges[i]);
  }
  return farthest(neighbours, farthest(neighbours, 0).first).second;
}

}  // namespace

lab::StudyResult study_tree_diameter(bool quick, const std::function<bool()>& go_on) {
  lab::StudyResult result;
  result.name = "section-7-tree-diameter";
  result.table.title = "the longest path of a minimum spanning tree of random points";
  result.table.header = {"n", "scenes", "edges", "standard error"};
  result.table.note = fmt::format("means of as many scenes; audited up to n = {}", kLargestAudited);
  for (const int n : {50, 100, 200, 400, 800, 1600, 3200}) {
    if (quick && n > 800) continue;
    const int scenes = quick ? 8 : 16;
    lab::RunningMean mean;
    for (int seed = 1; seed <= scenes; ++seed) {
      if (!go_on()) return result;
      mean.add(tree_diameter(n, static_cast<std::uint64_t>(seed), result));
    }
    result.table.rows.push_back({std::to_string(n), std::to_string(scenes),
                                 fmt::format("{:.4f}", mean.mean()),
                                 fmt::format("{:.4f}", mean.standard_error())});
  }
  return result;
}

lab::PartReport kds_section_7_diameter_report(const lab::StudyResult& result,
                                              const std::string& command) {
  lab::PartReport report;
  std::vector<lab::FitPoint> points;
  for (const std::vector<std::string>& row : result.table.rows) {
    points.push_back({std::stod(row[0]), std::stod(row[2]), std::stod(row[3])});
  }
  const auto fit = lab::fit_power(points);
  if (!fit) return report;
  lab::PaperClaim claim = open_question(
      "7.8.diameter", "How long is the longest path of a minimum spanning tree of random points?",
      lab::fit_text(*fit) +
          fmt::format(
              ". It grows {}, the side of a square grid of as many points, and {}. It is the "
              "cost of an edge at worst: most paths are shorter",
              lab::growth_words(fit, 0.5, "n^(1/2)"), lab::growth_words(fit, 1, "n")),
      {kTree, "uniform-square"});
  claim.place = "section 7";
  claim.command = command;
  claim.assumptions = {"independent uniform points of the unit square"};
  lab::refute_by_checks(result, claim);
  claim.small_run = lab::small_run(std::move(claim.small_run));
  report.claims.push_back(std::move(claim));
  report.figures.push_back(growth_figure(
      "The longest path of a minimum spanning tree",
      "Of n random points; means with bars of two standard errors, and the power of n that fits, with its 95 % "
      "interval.",
      "edges", {0.5, 1}, {{"longest path", points, ""}}));
  report.figure_names = {"section-7-tree-diameter"};
  report.tables = lab::markdown(result.table);
  return report;
}

}  // namespace kinex::families
