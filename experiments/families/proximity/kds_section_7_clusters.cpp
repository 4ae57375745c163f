// SPDX-License-Identifier: GPL-3.0-or-later
// Question: how many certificates does a change of a minimum spanning tree make, by clusters of its vertices
//   and by cycles? (Guibas 1998, section 7, names a structure by clusters for planar graphs; Agarwal,
//   Eppstein, Guibas and Henzinger, 1998, have O(n^(2/3) log^(4/3) n) for a change of the tree of any graph
//   of n vertices, and O(n^(1/4) log^(3/2) n) for planar ones without insertions.)
// Scenes: points in random motion, whose graph, the Delaunay triangulation, is planar and changes; random
//   graphs of n vertices and 4n edges; random weights on a planar graph.
// Parameters: from 16 to 512 vertices, in a quick run to 64; 8 scenes, 4 in a quick run.
// Expected: nothing; a power of the number of vertices is fitted. Clusters have about n^(2/3) vertices, a
//   change makes O(z log n + k^2) certificates for k clusters of z vertices: n^(2/3) log n.
// Cost: about a minute; --quick: seconds.
#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
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

struct TreeScenes {
  const char* id;
  const char* statement;
  const char* workload;
  const char* clusters;
  const char* cycles;
  int edges;  // of the workload for each vertex; 0: its --n are the vertices
};
constexpr TreeScenes kTreeScenes[] = {
    {"7.9.per-change.points",
     "How many certificates does a change of the Euclidean tree make, by clusters?",
     "uniform-square", "emst_clusters", "emst_cycles", 0},
    {"7.9.per-change.graph",
     "How many certificates does a change of the tree of a graph make, by clusters?",
     "random-graph", "graph_mst_clusters", "graph_mst_cycles", 4},
    {"7.9.per-change.planar",
     "How many certificates does a change of the tree of a planar graph make, by clusters?",
     "random-planar-graph", "graph_mst_clusters", "graph_mst_cycles", 3}};

lab::WorkloadParameters graph_parameters(const TreeScenes& kind, int vertices, std::uint64_t seed) {
  lab::WorkloadParameters parameters{.n = vertices, .seed = seed};
  if (kind.edges > 0) parameters.n = kind.edges * vertices;
  if (kind.workload == std::string_view("random-graph")) parameters.m = vertices;
  return parameters;
}

// The vertices of the tree: points, or the ends of edges.
std::size_t vertices_of(const Scene& scene) {
  std::set<std::string> ends;
  for (const SceneObject& object : scene.objects)
    ends.insert(object.ends.begin(), object.ends.end());
  return ends.empty() ? scene.objects.size() : ends.size();
}

struct TreeCost {
  double changes = 0, made = 0;  // certificates of the tree's structure, after the start
};

TreeCost tree_cost(const Scene& scene, lab::StudyResult& study) {
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  const auto simulator = lab::make_simulator(scene, "exact", options);
  const StructureId tree = asked_structure(scene);
  simulator->start();
  const std::uint64_t built = simulator->ledger(tree).certificates_created;
  simulator->run_until(std::nullopt);
  lab::check_run(*simulator, scene.name, study);
  const StructureLedger& ledger = simulator->ledger(tree);
  return {static_cast<double>(ledger.external),
          static_cast<double>(ledger.certificates_created - built)};
}

// Columns of the study's table.
enum CostColumn : std::size_t {
  kColumnScenes,
  kColumnVertices,
  kColumnSeeds,
  kColumnChanges,
  kColumnClusters,
  kColumnError,
  kColumnShare,
  kColumnCycles,
  kColumnCyclesError
};

std::vector<lab::FitPoint> points_of(const lab::StudyResult& result, std::string_view workload,
                                     CostColumn counted, CostColumn error) {
  std::vector<lab::FitPoint> points;
  for (const std::vector<std::string>& row : result.table.rows) {
    if (row[kColumnScenes] != workload) continue;
    points.push_back(
        {std::stod(row[kColumnVertices]), std::stod(row[counted]), std::stod(row[error])});
  }
  return points;
}

// What the two counts tell of each other, and of the bound on clusters.
std::string comparison(const std::vector<lab::FitPoint>& clusters,
                       const std::vector<lab::FitPoint>& cycles) {
  const std::size_t below = lab::times_below(cycles, clusters);
  const bool always = below == cycles.size();
  std::string text = always ? std::string("Cycles make fewer certificates at every size")
                            : fmt::format(
                                  "Cycles make fewer certificates at {} of {} sizes, by more than "
                                  "two standard errors",
                                  below, cycles.size());
  const auto gap = lab::fit_power(lab::ratios(cycles, clusters));
  const lab::GrowthOrder widens = lab::growth_order(gap, 0);
  text += widens == lab::GrowthOrder::kFaster ? "; the ratio of the two grows with n"
          : widens == lab::GrowthOrder::kSlower
              ? "; the ratio of the two falls with n"
              : "; whether the ratio of the two grows is not told";
  if (gap) text += fmt::format(" (exponent in [{:.3g}, {:.3g}])", gap->lower, gap->upper);
  for (const auto& [name, points] :
       {std::pair{"clusters", &clusters}, std::pair{"cycles", &cycles}}) {
    text += fmt::format("; by {} they grow {}", name,
                        lab::growth_words(lab::fit_power(*points), 2.0 / 3, "n^(2/3)"));
  }
  if (always) text += ". No size here shows that clusters pay";
  return text;
}

}  // namespace

lab::StudyResult study_tree_clusters(bool quick, const std::function<bool()>& go_on) {
  lab::StudyResult result;
  result.name = "section-7-clusters";
  result.table.title = "certificates that a change of a minimum spanning tree makes";
  result.table.header = {"scenes",         "vertices",  "seeds",     "changes",       "by clusters",
                         "standard error", "/ n^(2/3)", "by cycles", "standard error"};
  result.table.note =
      "changes: means of a run. Certificates of the structure of the tree that were made after the "
      "start, for "
      "each change: of internal events, too, and of edges that come and go in a triangulation";
  const int seeds = quick ? 4 : 8;
  for (const TreeScenes& kind : kTreeScenes) {
    for (const int vertices : {16, 32, 64, 128, 256, 512}) {
      if (quick && vertices > 64) continue;
      lab::RunningMean changes, clusters, cycles;
      std::size_t counted = 0;
      for (int seed = 1; seed <= seeds; ++seed) {
        if (!go_on()) return result;
        const lab::WorkloadParameters parameters =
            graph_parameters(kind, vertices, static_cast<std::uint64_t>(seed));
        const Scene scene = lab::generate_scene(kind.workload, parameters, kind.clusters);
        counted = vertices_of(scene);
        const TreeCost by_clusters = tree_cost(scene, result);
        const TreeCost by_cycles =
            tree_cost(lab::generate_scene(kind.workload, parameters, kind.cycles), result);
        if (by_clusters.changes != by_cycles.changes) {
          result.checks.push_back(
              {fmt::format("{}.changes.{}.{}", kind.id, vertices, seed), "exactly", "",
               fmt::format("{:.0f}", by_cycles.changes), fmt::format("{:.0f}", by_clusters.changes),
               "the changes by cycles on the same scene", lab::Verdict::kRefuted, std::nullopt});
        }
        changes.add(by_clusters.changes);
        if (by_clusters.changes == 0 || by_cycles.changes == 0) continue;
        clusters.add(by_clusters.made / by_clusters.changes);
        cycles.add(by_cycles.made / by_cycles.changes);
      }
      result.table.rows.push_back(
          {kind.workload, std::to_string(counted), std::to_string(seeds),
           fmt::format("{:.1f}", changes.mean()), fmt::format("{:.3f}", clusters.mean()),
           fmt::format("{:.4f}", clusters.standard_error()),
           fmt::format("{:.2f}", clusters.mean() / std::pow(static_cast<double>(counted), 2.0 / 3)),
           fmt::format("{:.3f}", cycles.mean()), fmt::format("{:.4f}", cycles.standard_error())});
    }
  }
  return result;
}

lab::PartReport kds_section_7_clusters_report(const lab::StudyResult& result,
                                              const std::string& command) {
  lab::PartReport report;
  std::vector<lab::Curve> curves;
  for (const TreeScenes& kind : kTreeScenes) {
    const auto clusters = points_of(result, kind.workload, kColumnClusters, kColumnError);
    const auto cycles = points_of(result, kind.workload, kColumnCycles, kColumnCyclesError);
    const auto fit = lab::fit_power(clusters), other = lab::fit_power(cycles);
    if (!fit || !other) continue;
    lab::PaperClaim claim =
        open_question(kind.id, kind.statement,
                      lab::fit_text(*fit) + "; by cycles " + lab::fit_text(*other) + ". " +
                          comparison(clusters, cycles),
                      {kind.clusters, kind.workload});
    lab::refute_by_checks(result, claim);
    claim.place = "section 7";
    claim.command = command;
    claim.assumptions = {
        "n: the number of vertices. The bound of Agarwal, Eppstein, Guibas and Henzinger (1998), "
        "O(n^(2/3) log^(4/3) n), is on time, of their layout; ours has clusters of n^(2/3) "
        "vertices, and no "
        "version of its own for planar graphs",
        "random scenes, which say nothing of the worst case"};
    if (kind.edges > 0) claim.small_run.parameters.dimension = 1;
    claim.small_run = lab::small_run(std::move(claim.small_run));
    report.claims.push_back(std::move(claim));
    curves.push_back({std::string(kind.workload) + ", by clusters", clusters, ""});
    curves.push_back({std::string(kind.workload) + ", by cycles", cycles, ""});
  }
  if (curves.empty()) return report;
  report.figures.push_back(growth_figure("Certificates made for a change of a spanning tree",
                                         "Over the number of vertices; means with bars of two "
                                         "standard errors, and the power that fits, with its "
                                         "95 % interval.",
                                         "certificates for a change", {0.5, 2.0 / 3, 1},
                                         std::move(curves)));
  report.figure_names = {"section-7-clusters"};
  report.tables = lab::markdown(result.table);
  return report;
}

}  // namespace kinex::families
