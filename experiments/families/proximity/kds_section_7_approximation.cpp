// SPDX-License-Identifier: GPL-3.0-or-later
// Question: is a spanning tree in the metric of a polygon nearly the Euclidean one? (Guibas 1998,
//   section 7: structures for a polyhedral metric, and for a tree at most 1 + eps times the Euclidean one.)
// Scenes: random motion; pass-along-row.
// Method: every run is audited between every two instants, where squared lengths are compared with the
//   static Euclidean tree as rationals. At some rational times the lengths are compared once more, with
//   the tree of emst_list in the same run.
// Expected: the i-th shortest edge is at most sqrt(10)/3 times that of the Euclidean tree for 12 corners,
//   sqrt(26)/5 times for 20.
// Cost: a minute or two, of audits; --quick: seconds.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "core/engine/simulator.h"
#include "experiments/families/proximity/experiments.h"
#include "experiments/lab/claim_check.h"
#include "experiments/lab/scene_run.h"
#include "experiments/lab/workload.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

namespace {

constexpr const char* kPolygonTree = "mst_polygon_list";
constexpr const char* kEuclideanTree = "emst_list";

struct Polygon {
  int corners;
  Rational ratio;  // of the squares
  const char* bound;
};

std::vector<Polygon> polygons() {
  return {{12, lab::fraction(10, 9), "sqrt(10)/3"}, {20, lab::fraction(26, 25), "sqrt(26)/5"}};
}

// Squared lengths, ascending.
std::vector<Rational> squares_of(const Snapshot& now, const std::vector<ObjectId>& edges) {
  std::vector<Rational> squares;
  for (std::size_t k = 0; k + 1 < edges.size(); k += 2) {
    const Rational x = now.position(edges[k], 0) - now.position(edges[k + 1], 0);
    const Rational y = now.position(edges[k], 1) - now.position(edges[k + 1], 1);
    squares.push_back(x * x + y * y);
  }
  std::sort(squares.begin(), squares.end());
  return squares;
}

std::vector<ObjectId> edges_of(const Simulator& simulator, std::string_view structure) {
  for (StructureId id = 0; id < simulator.structures(); ++id) {
    if (simulator.structure(id).name() == structure) return simulator.structure(id).attribute().ids;
  }
  return {};
}

struct Approximation {
  std::uint64_t checks = 0, violations = 0;  // of audits
  std::size_t edges = 0, longer = 0;         // compared with the bound, and above it
  Rational largest;                          // ratio of squares
};

void compare(const Snapshot& now, const Simulator& simulator, const Rational& bound,
             Approximation& result) {
  const std::vector<Rational> ours = squares_of(now, edges_of(simulator, kPolygonTree));
  const std::vector<Rational> euclidean = squares_of(now, edges_of(simulator, kEuclideanTree));
  if (ours.size() != euclidean.size()) ++result.longer;
  for (std::size_t i = 0; i < std::min(ours.size(), euclidean.size()); ++i) {
    ++result.edges;
    if (ours[i] > bound * euclidean[i]) ++result.longer;
    if (euclidean[i].is_zero()) continue;
    result.largest = std::max(result.largest, ours[i] / euclidean[i]);
  }
}

Approximation approximate(Scene scene, const Polygon& polygon, int times,
                          const std::function<bool()>& go_on) {
  Request cones{"cones_local", "cones_local", {}}, tree{kPolygonTree, kPolygonTree, {}};
  if (polygon.corners != 12) cones.parameters = {{"corners", Rational(polygon.corners)}};
  tree.over = {std::move(cones)};
  scene.maintain = {std::move(tree), Request{kEuclideanTree, kEuclideanTree, {}}};
  SimulatorOptions options;
  options.audit = AuditLevel::kEvents;
  const auto simulator = lab::make_simulator(scene, "exact", options);
  simulator->start();
  Approximation result;
  for (int i = 1; i <= times && go_on(); ++i) {
    const Rational t =
        scene.start + (*scene.end - scene.start) * lab::fraction(2 * i - 1, 2 * times + 1);
    simulator->run_until(t);
    compare(simulator->snapshot(t), *simulator, polygon.ratio, result);
  }
  for (StructureId id = 0; id < simulator->structures(); ++id) {
    if (simulator->structure(id).name() != kPolygonTree) continue;
    result.checks = simulator->ledger(id).audit_checks;
    result.violations = simulator->ledger(id).audit_violations;
  }
  return result;
}

// Columns of the study's table.
enum ApproximationColumn : std::size_t {
  kApproximationCorners,
  kApproximationScenes,
  kApproximationN,
  kApproximationSeeds,
  kApproximationChecks,
  kApproximationViolations,
  kApproximationEdges,
  kApproximationLonger,
  kApproximationLargest
};

}  // namespace

lab::StudyResult study_approximate_trees(bool quick, const std::function<bool()>& go_on) {
  lab::StudyResult result;
  result.name = "section-7-approximation";
  result.table.title = "edges of a tree in the metric of a polygon, and of the Euclidean one";
  result.table.header = {"corners",    "scenes", "n",      "seeds",  "checks",
                         "violations", "edges",  "longer", "largest"};
  result.table.note =
      "checks, and violations: of audits between every two instants; edges: compared at rational "
      "times with those of the Euclidean tree, in ascending order; longer: above the bound; "
      "largest: "
      "ratio of the lengths of two edges";
  const int times = quick ? 10 : 50;
  for (const Polygon& polygon : polygons()) {
    for (const auto& [workload, n, seeds] :
         {std::tuple("uniform-square", 8, 4), std::tuple("uniform-square", 12, 2),
          std::tuple("uniform-square", 16, 1), std::tuple("pass-along-row", 4, 1)}) {
      if (quick && n > 8) continue;
      Approximation sum;
      for (int seed = 1; seed <= seeds; ++seed) {
        if (!go_on()) return result;
        const lab::WorkloadParameters parameters{.n = n, .seed = static_cast<std::uint64_t>(seed)};
        const Approximation one = approximate(
            lab::generate_scene(workload, parameters, kPolygonTree), polygon, times, go_on);
        sum.checks += one.checks;
        sum.violations += one.violations;
        sum.edges += one.edges;
        sum.longer += one.longer;
        sum.largest = std::max(sum.largest, one.largest);
      }
      result.table.rows.push_back(
          {std::to_string(polygon.corners), workload, std::to_string(n), std::to_string(seeds),
           std::to_string(sum.checks), std::to_string(sum.violations), std::to_string(sum.edges),
           std::to_string(sum.longer), fmt::format("{:.4f}", std::sqrt(sum.largest.to_double()))});
    }
  }
  return result;
}

lab::PartReport kds_section_7_approximation_report(const lab::StudyResult& result,
                                                   const std::string& command) {
  lab::PartReport report;
  for (const Polygon& polygon : polygons()) {
    std::size_t checks = 0, edges = 0, wrong = 0;
    double largest = 0;
    for (const std::vector<std::string>& row : result.table.rows) {
      if (row[kApproximationCorners] != std::to_string(polygon.corners)) continue;
      checks += std::stoul(row[kApproximationChecks]);
      edges += std::stoul(row[kApproximationEdges]);
      wrong += std::stoul(row[kApproximationViolations]) + std::stoul(row[kApproximationLonger]);
      largest = std::max(largest, std::stod(row[kApproximationLargest]));
    }
    if (edges == 0) continue;
    lab::PaperClaim claim;
    claim.id = fmt::format("7.8.approximate-{}", polygon.corners);
    claim.place = "section 7";
    claim.kind = "bound";
    claim.command = command;
    claim.statement = fmt::format(
        "A structure maintains a tree that is a (1 + eps)-approximation of the Euclidean "
        "one: in the metric of a polygon of {} corners.",
        polygon.corners);
    claim.expected = fmt::format(
        "the i-th shortest edge is at most {} = {:.4f} times that of the Euclidean "
        "tree, for every i and at all times",
        polygon.bound, std::sqrt(polygon.ratio.to_double()));
    claim.tolerance = "none";
    claim.observed = fmt::format(
        "{} times at most, of {} edges at rational times; {} checks of audits between instants; {}",
        fmt::format("{:.4f}", largest), edges, checks,
        wrong == 0 ? std::string("none is longer; consistent with the bound")
                   : fmt::format("{} are wrong", wrong));
    claim.verdict = wrong == 0 ? lab::Verdict::kOpen : lab::Verdict::kRefuted;
    claim.assumptions = {
        "runs cannot confirm a bound on all motions; the proof is in cone_tree.h",
        "the structure is ours: the report has range trees, and does not say how eps is had"};
    claim.small_run.structure = kPolygonTree;
    claim.small_run.workload = "uniform-square";
    claim.small_run = lab::small_run(std::move(claim.small_run));
    report.claims.push_back(std::move(claim));
  }
  report.tables = lab::markdown(result.table);
  return report;
}

}  // namespace kinex::families
