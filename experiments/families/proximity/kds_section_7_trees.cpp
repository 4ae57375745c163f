// SPDX-License-Identifier: GPL-3.0-or-later
// Questions: how often do minimum spanning trees change, of points and of graphs, and how many events do
//   two proofs of them have for each change? (Guibas 1998, section 7.)
// Scenes: random motion; pass-along-row, where a tree changes 2nm - 2 times; parallel-edges, where the
//   tree of a graph of two vertices changes n - 1 times; random graphs of n edges and n/4 vertices.
// Expected: the integers, in every run; one event for each change where all edges of a graph are watched
//   along their paths in the tree. Bounds on all motions, O(n^3) and O(n^(5/2)
//   alpha(n)) of points, O(n k^(1/3)) of graphs with n edges and k vertices, which runs can only
//   contradict.
// Left out: clusters of edges and sparsification (the report's structure for planar graphs), for which
//   there is no structure yet.
// Cost: about 3 minutes; --quick: seconds.
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

#include "experiments/families/points/kds_claims.h"
#include "experiments/families/proximity/experiments.h"

namespace kinex::families {

namespace {

constexpr const char* kTreeUniform = "uniform-square";
constexpr const char* kTreeRow = "pass-along-row";
constexpr KdsRuns kList{"emst_list", kTreeUniform}, kCycles{"emst_cycles", kTreeUniform},
    kListRow{"emst_list", kTreeRow}, kCyclesRow{"emst_cycles", kTreeRow},
    kNormList{"mst_maximum_norm_list", kTreeUniform}, kNormCycles{"mst_maximum_norm_cycles", kTreeUniform},
    kNormRow{"mst_maximum_norm_cycles", kTreeRow}, kGraphList{"graph_mst_list", "parallel-edges"},
    kGraphCycles{"graph_mst_cycles", "parallel-edges"},
    kRandomGraph{"graph_mst_cycles", "random-graph"};

void add_sizes(std::vector<lab::SeriesPoint>& points, KdsRuns runs, std::vector<int> sizes,
               int largest_quick, bool quick) {
  for (const int n : sizes) {
    if (quick && n > largest_quick) continue;
    points.push_back(kds_random(runs, n, 8));
    points.back().cost = 8e-6 * n * n;
  }
}

std::string power_text(const char* what, const std::vector<lab::FitPoint>& points) {
  const auto fit = lab::fit_power(points);
  if (!fit) return std::string(what) + ": too few sizes";
  return fmt::format("{}: {:.2f} at n = {:.0f}, {:.2f} at n = {:.0f}, n^{:.3f} [{:.3f}, {:.3f}]",
                     what, points.front().count, points.front().n, points.back().count,
                     points.back().n, fit->b, fit->lower, fit->upper);
}

void add_norm_claims(const std::vector<lab::SeriesResult>& results, lab::PartReport& report) {
  report.claims.push_back(bound_claim(
      results, {"7.8.compact", "The tree in a polyhedral metric has a compact structure.", kNormList,
                "max_live", "certificates", "16n - 1",
                [](double n, double) { return 16 * n - 1; }}));
  report.claims.back().assumptions.push_back(
      "the maximum norm; the structure, on the pairs of points that are next in an octant, is ours");
  report.claims.push_back(growth_claim(
      means_of(results, kNormCycles, "external"),
      {"7.8.maximum-norm.random",
       "The tree in the maximum norm changes O(n^(5/2) alpha(n)) times; of random motion:", kNormCycles,
       "changes", 2.5, KdsPower::kOnAllMotion}));
  report.claims.push_back(growth_claim(
      means_of(results, kNormRow, "external"),
      {"7.8.maximum-norm.row",
       "The tree in the maximum norm changes O(n^(5/2) alpha(n)) times; of pass-along-row:", kNormRow,
       "changes", 2.5, KdsPower::kOnAllMotion}));
}

void add_euclidean_claims(const std::vector<lab::SeriesResult>& results, lab::PartReport& report) {
  report.claims.push_back(count_claim(
      results, {"7.10.lower", "The Euclidean tree changes Omega(n^2) times on linear motions.",
                kCyclesRow, "external", "changes", "2nm - 2",
                [](double n, double m) { return 2 * n * m - 2; }}));
  report.claims.push_back(growth_claim(
      means_of(results, kCyclesRow, "external"),
      {"7.10.upper", "The Euclidean tree changes O(n^3) times on linear motions.", kCyclesRow,
       "changes", 3, KdsPower::kOnAllMotion}));
  report.claims.back().assumptions.push_back(
      "section 9 of the report has n^3 2^alpha(n) instead: no run tells the two apart");
  const KdsAgreement agreement = agreement_of(results, {"emst_list", "emst_cycles"});
  lab::PaperClaim same;
  same.id = "7.8.same-changes";
  same.kind = "finding";
  same.statement = "The order of all Delaunay edges proves the tree, and so do their cycles.";
  same.expected = "as many changes by both, on every scene";
  same.tolerance = "none";
  same.small_run.structure = kListRow.structure;
  same.small_run.workload = kListRow.workload;
  same.verdict = !agreement.difference.empty() ? lab::Verdict::kRefuted
                 : agreement.scenes > 0        ? lab::Verdict::kConfirmed
                                               : lab::Verdict::kOpen;
  same.observed = agreement.difference.empty()
                      ? fmt::format("as many on all {} scenes", agreement.scenes)
                      : agreement.difference;
  report.claims.push_back(std::move(same));
  report.claims.push_back(open_question(
      "7.8.efficient",
      "Is there an efficient structure for the Euclidean tree? Events for each change of the tree, the "
      "flips of the triangulation included:",
      power_text("by order, random motion", ratios_of(results, kList, "processed", "external")) + "; " +
          power_text("by cycles, random motion",
                     ratios_of(results, kCycles, "processed", "external")) +
          "; " +
          power_text("by order, pass-along-row",
                     ratios_of(results, kListRow, "processed", "external")) +
          "; " +
          power_text("by cycles, pass-along-row",
                     ratios_of(results, kCyclesRow, "processed", "external")) +
          "; the price of cycles is certificates: " +
          power_text("of random motion, at most", means_of(results, kCycles, "max_live")),
      kCyclesRow));
}

void add_graph_claims(const std::vector<lab::SeriesResult>& results, lab::PartReport& report) {
  report.claims.push_back(count_claim(
      results, {"7.11.lower", "The tree of a graph with n edges changes Omega(n) times.", kGraphCycles,
                "external", "changes, of two vertices", "n - 1",
                [](double n, double) { return n - 1; }}));
  report.claims.push_back(count_claim(
      results, {"7.11.cycles", "All failures of the proof by cycles change the tree (ours).",
                kGraphCycles, "processed", "failures", "n - 1",
                [](double n, double) { return n - 1; }}));
  report.claims.push_back(count_claim(
      results, {"7.11.order", "The proof by order has all swaps of edges (ours).", kGraphList,
                "processed", "failures", "n(n - 1)/2",
                [](double n, double) { return n * (n - 1) / 2; }}));
  report.claims.push_back(growth_claim(
      means_of(results, kRandomGraph, "external", 1),
      {"7.11.upper",
       "The tree of a graph with n edges and k vertices changes O(n k^(1/3)) times; of random weights, "
       "k = n/4:",
       kRandomGraph, "changes", 4.0 / 3, KdsPower::kOnAllMotion}));
}

}  // namespace

std::vector<lab::SeriesPoint> kds_section_7_trees_points(bool quick) {
  std::vector<lab::SeriesPoint> points;
  add_sizes(points, kList, {25, 35, 50, 70, 100, 200, 300}, 100, quick);
  add_sizes(points, kCycles, {25, 35, 50, 70, 100, 200, 400, 800}, 100, quick);
  add_sizes(points, kNormList, {12, 18, 25, 35, 50, 100, 200}, 50, quick);
  add_sizes(points, kNormCycles, {12, 18, 25, 35, 50, 100, 200}, 50, quick);
  for (const int n : {3, 4, 6, 8, 12, 16, 24}) {
    if (quick && n > 12) continue;
    for (const KdsRuns& runs : {kListRow, kCyclesRow, kNormRow}) {
      points.push_back(kds_single(runs, n, n));
      points.back().cost = n * n / 1000.0;
    }
  }
  for (const int n : {4, 8, 16, 32, 64, 128}) {
    if (quick && n > 64) continue;
    for (const KdsRuns& runs : {kGraphList, kGraphCycles}) {
      points.push_back(kds_single(runs, n, 1, 1));
    }
  }
  for (const int n : {40, 80, 160, 320, 640, 1280}) {
    if (quick && n > 320) continue;
    points.push_back(kds_random(kRandomGraph, n, 8, 1));
    points.back().key.parameters.m = n / 4;
    points.back().cost = n / 1000.0;
  }
  return points;
}

lab::PartReport kds_section_7_trees_report(const std::vector<lab::SeriesResult>& results,
                                           const std::string& command) {
  lab::PartReport report;
  add_norm_claims(results, report);
  add_euclidean_claims(results, report);
  add_graph_claims(results, report);
  std::vector<lab::Curve> curves;
  curves.push_back({"events, by the order of all edges", means_of(results, kList, "processed"), ""});
  curves.push_back({"events, by cycles", means_of(results, kCycles, "processed"), ""});
  curves.push_back({"changes of the tree", means_of(results, kCycles, "external"), ""});
  curves.push_back({"events in the maximum norm, by cycles",
                    means_of(results, kNormCycles, "processed"), ""});
  curves.push_back({"changes in the maximum norm", means_of(results, kNormCycles, "external"), ""});
  report.figures.push_back(growth_figure(
      "Spanning trees of points in random motion",
      "Events of a run, flips of the triangulation or changes of the octants included; means with bars of "
      "two standard errors; the power of n that fits all sizes, with its 95 % interval.",
      "events", {1.5, 2, 2.5}, std::move(curves)));
  report.figure_names = {"section-7-trees"};
  finish_section_7(report, results, command);
  return report;
}

}  // namespace kinex::families
