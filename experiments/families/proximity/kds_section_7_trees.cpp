// SPDX-License-Identifier: GPL-3.0-or-later
// Questions: how often do minimum spanning trees change, of points and of graphs, and how many events do
//   the proofs of them have for each change: by the order of all edges, by cycles, by clusters of vertices,
//   by sparsification? (Guibas 1998, section 7.)
// Scenes: random motion; pass-along-row, where a tree changes 2nm - 2 times; parallel-edges, where the
//   tree of a graph of two vertices changes n - 1 times; random graphs of n edges and n/4 or 16 vertices;
//   planar graphs of n edges.
// Expected: the integers, in every run; one event for each change where all edges of a graph are watched
//   along their paths in the tree. Bounds on all motions, O(n^3) and O(n^(5/2)
//   alpha(n)) of points, O(n k^(1/3)) of graphs with n edges and k vertices, O(n^(11/6) polylog n) events of
//   a planar graph, which runs can only contradict; and O(k n^(1/3)) as the report prints it, which they do.
// Left out: what a change costs by clusters, kds_section_7_clusters.cpp.
// Cost: about 4 minutes; --quick: seconds.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/families/points/kds_claims.h"
#include "experiments/families/proximity/experiments.h"

namespace kinex::families {

namespace {

constexpr const char* kTreeUniform = "uniform-square";
constexpr const char* kTreeRow = "pass-along-row";
constexpr int kFewVertices = 16;  // no quarter of a number of edges below
constexpr KdsRuns kList{"emst_list", kTreeUniform}, kCycles{"emst_cycles", kTreeUniform},
    kListRow{"emst_list", kTreeRow}, kCyclesRow{"emst_cycles", kTreeRow},
    kNormList{"mst_maximum_norm_list", kTreeUniform},
    kNormCycles{"mst_maximum_norm_cycles", kTreeUniform},
    kNormRow{"mst_maximum_norm_cycles", kTreeRow}, kPolygonList{"mst_polygon_list", kTreeUniform},
    kPolygonCycles{"mst_polygon_cycles", kTreeUniform},
    kPolygonListRow{"mst_polygon_list", kTreeRow}, kPolygonRow{"mst_polygon_cycles", kTreeRow},
    kGraphList{"graph_mst_list", "parallel-edges"},
    kGraphCycles{"graph_mst_cycles", "parallel-edges"},
    kRandomGraph{"graph_mst_cycles", "random-graph"}, kClusters{"emst_clusters", kTreeUniform},
    kClustersRow{"emst_clusters", kTreeRow}, kGraphClusters{"graph_mst_clusters", "parallel-edges"},
    kGraphSparsified{"graph_mst_sparsified", "parallel-edges"},
    kRandomGraphList{"graph_mst_list", "random-graph"},
    kRandomGraphClusters{"graph_mst_clusters", "random-graph"},
    kRandomGraphSparsified{"graph_mst_sparsified", "random-graph"},
    kPlanarCycles{"graph_mst_cycles", "random-planar-graph"},
    kPlanarClusters{"graph_mst_clusters", "random-planar-graph"},
    kPlanarSparsified{"graph_mst_sparsified", "random-planar-graph"};

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

// The runs of a structure for graphs, and how a sentence names it.
struct NamedRuns {
  const char* name;
  KdsRuns runs;
};
constexpr NamedRuns kParallelEdges[] = {{"by order", kGraphList},
                                        {"by cycles", kGraphCycles},
                                        {"by clusters", kGraphClusters},
                                        {"by sparsification", kGraphSparsified}};
constexpr NamedRuns kRandomGraphs[] = {{"by order", kRandomGraphList},
                                       {"by clusters", kRandomGraphClusters},
                                       {"by sparsification", kRandomGraphSparsified},
                                       {"by cycles", kRandomGraph}};
constexpr NamedRuns kPlanarGraphs[] = {{"by clusters", kPlanarClusters},
                                       {"by sparsification", kPlanarSparsified},
                                       {"by cycles", kPlanarCycles}};

std::vector<lab::FitPoint> events_per_change(const std::vector<lab::SeriesResult>& results,
                                             KdsRuns runs, int dimension = 2) {
  return ratios_of(results, runs, "processed", "external", dimension);
}

// "by order: 46.02 at n = 40, ..; by clusters: ..".
std::string graph_ratio_text(const std::vector<lab::SeriesResult>& results,
                             std::span<const NamedRuns> all) {
  std::string text;
  for (const NamedRuns& one : all) {
    text +=
        (text.empty() ? "" : "; ") + power_text(one.name, events_per_change(results, one.runs, 1));
  }
  return text;
}

// "; certificates at most: by order: 39 at n = 40, ..".
std::string certificates_text(const std::vector<lab::SeriesResult>& results,
                              std::span<const NamedRuns> all) {
  std::string text;
  for (const NamedRuns& one : all) {
    text += text.empty() ? "; certificates at most: " : "; ";
    text += power_text(one.name, means_of(results, one.runs, "max_live", 1));
  }
  return text;
}

// What is said of several structures, with the names of those that it is said of.
using Told = std::vector<std::pair<std::string, std::string>>;

void tell(Told& told, const std::string& words, const char* name) {
  const auto known = std::find_if(told.begin(), told.end(),
                                  [&words](const auto& one) { return one.first == words; });
  if (known == told.end()) {
    told.emplace_back(words, name);
  } else {
    known->second += fmt::format(", {}", name);
  }
}

// "grow with n by order, by clusters; stay the same by cycles".
std::string told_text(const Told& told) {
  std::string text;
  for (const auto& [words, names] : told) {
    text += fmt::format("{}{} {}", text.empty() ? "" : "; ", words, names);
  }
  return text;
}

// 1 if the whole interval of the exponent is above `exponent`, -1 if it is below, else 0. It is wider where a
// power fits badly, so that chi squared does not matter for that.
int side_of(const std::optional<lab::Fit>& fit, double exponent) {
  if (!fit || fit->degrees < 2) return 0;
  return fit->lower > exponent ? 1 : fit->upper < exponent ? -1 : 0;
}

constexpr const char* kRatioGrows = "grow with n";

// Of the events for each change.
std::string ratio_words(const std::vector<lab::FitPoint>& ratios) {
  const std::optional<lab::Fit> fit = lab::fit_power(ratios);
  if (fit && lab::is_exact(*fit) && std::fabs(fit->b) < 1e-9) return "stay the same";
  const int side = side_of(fit, 0);
  return side > 0 ? kRatioGrows : side < 0 ? "fall with n" : "are not told from a constant";
}

std::string ratios_told(const std::vector<lab::SeriesResult>& results,
                        std::span<const NamedRuns> all) {
  Told told;
  for (const NamedRuns& one : all) {
    tell(told, ratio_words(events_per_change(results, one.runs, 1)), one.name);
  }
  return "Events for a change " + told_text(told);
}

// How the certificates grow, and which structure has few of both.
std::string certificates_told(const std::vector<lab::SeriesResult>& results,
                              std::span<const NamedRuns> all) {
  constexpr double kMargin = 0.05;  // a term of lower order moves the exponent by as much
  Told told;
  std::string both;
  for (const NamedRuns& one : all) {
    const auto fit = lab::fit_power(means_of(results, one.runs, "max_live", 1));
    const bool is_faster = side_of(fit, 1 + kMargin) > 0;
    tell(told, is_faster ? "faster than n" : "no faster than n, as far as these sizes tell,",
         one.name);
    if (is_faster || ratio_words(events_per_change(results, one.runs, 1)) == kRatioGrows) continue;
    both += fmt::format("{}{}", both.empty() ? "" : ", ", one.name);
  }
  return "Certificates grow " + told_text(told) + ". " +
         (both.empty() ? "No structure here has both" : "Both are seen " + both) +
         ", events for a change that do not grow and certificates that grow no faster than n";
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
       "The tree in the maximum norm changes O(n^(5/2) alpha(n)) times (not in the report: Katoh, "
       "Tokuyama and Iwano 1995); of random motion:",
       kNormCycles, "changes", 2.5, KdsPower::kOnAllMotion}));
  report.claims.push_back(growth_claim(
      means_of(results, kNormRow, "external"),
      {"7.8.maximum-norm.row",
       "The tree in the maximum norm changes O(n^(5/2) alpha(n)) times (not in the report: Katoh, "
       "Tokuyama and Iwano 1995); of pass-along-row:",
       kNormRow, "changes", 2.5, KdsPower::kOnAllMotion}));
}

void add_polygon_claims(const std::vector<lab::SeriesResult>& results, lab::PartReport& report) {
  for (const KdsRuns& runs : {kPolygonList, kPolygonListRow}) {
    const bool row = runs.workload == kTreeRow;
    report.claims.push_back(bound_claim(
        results, {row ? "7.8.polygon-compact.row" : "7.8.polygon-compact",
                  "The tree in a polyhedral metric, here that of a polygon of 12 corners, has a "
                  "compact structure.",
                  runs, "max_live", "certificates, those of the cones included",
                  row ? "84n - 1 for n points of each kind" : "42n - 1",
                  row ? [](double n, double) { return 84 * n - 1; }
                      : [](double n, double) { return 42 * n - 1; }}));
    report.claims.back().assumptions.push_back(
        "the structure, by the order of the pairs of points that are next in a cone, is ours");
  }
  report.claims.push_back(agreement_claim(
      results, "7.8.polygon-same-changes",
      "The order of all pairs of cones proves the tree in the metric of a polygon, and so do their "
      "cycles.",
      kPolygonListRow, {kPolygonList.structure, kPolygonCycles.structure}));
  report.claims.push_back(open_question(
      "7.8.polygon-efficient",
      "The report has structures for a polyhedral metric, not necessarily efficient ones. Events "
      "for each change of the tree in the metric of a polygon of 12 corners, those of the cones "
      "included:",
      power_text("by order, random motion", events_per_change(results, kPolygonList)) + "; " +
          power_text("by cycles, random motion", events_per_change(results, kPolygonCycles)) +
          "; " +
          power_text("by order, pass-along-row", events_per_change(results, kPolygonListRow)) +
          "; " + power_text("by cycles, pass-along-row", events_per_change(results, kPolygonRow)) +
          "; certificates: " +
          power_text("by order, at most", means_of(results, kPolygonList, "max_live")) + "; " +
          power_text("by cycles, at most", means_of(results, kPolygonCycles, "max_live")) +
          ". The bound on the proof by cycles is not linear",
      kPolygonRow));
}

void add_euclidean_claims(const std::vector<lab::SeriesResult>& results, lab::PartReport& report) {
  report.claims.push_back(count_claim(
      results,
      {"7.10.lower",
       "The Euclidean tree changes Omega(n^2) times on linear motions (not in the report).",
       kCyclesRow, "external", "changes", "2nm - 2",
       [](double n, double m) { return 2 * n * m - 2; }}));
  report.claims.push_back(growth_claim(
      means_of(results, kCyclesRow, "external"),
      {"7.10.upper", "The Euclidean tree changes O(n^3) times on linear motions.", kCyclesRow,
       "changes", 3, KdsPower::kOnAllMotion}));
  report.claims.back().assumptions.push_back(
      "section 9 of the report has n^3 2^alpha(n) instead: no run tells the two apart");
  report.claims.push_back(agreement_claim(results, "7.8.same-changes",
                                          "The order of all Delaunay edges proves the tree, and so "
                                          "do their cycles, and clusters of points.",
                                          kListRow, {"emst_list", "emst_cycles", "emst_clusters"}));
  report.claims.push_back(open_question(
      "7.8.efficient",
      "Is there an efficient structure for the Euclidean tree? Events for each change of the tree, "
      "the "
      "flips of the triangulation included:",
      power_text("by order, random motion", events_per_change(results, kList)) + "; " +
          power_text("by cycles, random motion", events_per_change(results, kCycles)) + "; " +
          power_text("by clusters, random motion", events_per_change(results, kClusters)) + "; " +
          power_text("by order, pass-along-row", events_per_change(results, kListRow)) + "; " +
          power_text("by cycles, pass-along-row", events_per_change(results, kCyclesRow)) + "; " +
          power_text("by clusters, pass-along-row", events_per_change(results, kClustersRow)) +
          "; certificates: " +
          power_text("by order, at most", means_of(results, kList, "max_live")) + "; " +
          power_text("by cycles, at most", means_of(results, kCycles, "max_live")) +
          "; by clusters " + power_text("at most", means_of(results, kClusters, "max_live")) +
          ". The proof by cycles is not compact at worst, and nothing here bounds the flips of the "
          "triangulation by the changes of the tree",
      kCyclesRow));
}

// The changes of the tree of two vertices, by each structure.
lab::PaperClaim graph_lower_bound(const std::vector<lab::SeriesResult>& results) {
  const auto count = [&results](KdsRuns runs) {
    return count_claim(
        results, {"7.11.lower",
                  "The tree of a graph with n edges changes Omega(n) times (not in the report).",
                  runs, "external", "changes, of two vertices", "n - 1 by each structure",
                  [](double n, double) { return n - 1; }});
  };
  lab::PaperClaim claim = count(kGraphCycles);
  Told told;
  for (const NamedRuns& one : kParallelEdges) {
    const lab::PaperClaim by_one = count(one.runs);
    claim.verdict = std::max(claim.verdict, by_one.verdict);
    tell(told, by_one.observed, one.name);
  }
  claim.observed.clear();
  for (const auto& [words, names] : told) {
    claim.observed += fmt::format("{}{}: {}", claim.observed.empty() ? "" : "; ", names, words);
  }
  return claim;
}

// `few_vertices`: the runs of random graphs of kFewVertices vertices, which are not among `results`.
void add_graph_claims(const std::vector<lab::SeriesResult>& results,
                      const std::vector<lab::SeriesResult>& few_vertices, lab::PartReport& report) {
  report.claims.push_back(graph_lower_bound(results));
  report.claims.push_back(growth_claim(
      means_of(results, kGraphCycles, "external", 1),
      {"7.11.as-printed",
       "The tree of a graph with k vertices and n edges changes O(k n^(1/3)) times; of two "
       "vertices:",
       kGraphCycles, "changes", 1.0 / 3, KdsPower::kOnAllMotion}));
  report.claims.back().counterexample =
      "n parallel edges between two vertices, each the lightest once: n - 1 changes. The report "
      "has its "
      "two letters the wrong way round; 7.11.upper is its bound with the letters exchanged, that "
      "of "
      "Dey's technique";
  report.claims.push_back(count_claim(
      results, {"7.11.cycles", "All failures of the proof by cycles change the tree (ours).",
                kGraphCycles, "processed", "failures", "n - 1",
                [](double n, double) { return n - 1; }}));
  report.claims.push_back(count_claim(
      results,
      {"7.11.order", "The proof by order has all swaps of edges (ours).", kGraphList, "processed",
       "failures", "n(n - 1)/2", [](double n, double) { return n * (n - 1) / 2; }}));
  report.claims.push_back(agreement_claim(
      results, "7.11.same-changes",
      "The order of all edges proves the tree of a graph, and so do cycles, clusters of vertices, "
      "and "
      "sparsification.",
      kGraphClusters,
      {"graph_mst_list", "graph_mst_cycles", "graph_mst_clusters", "graph_mst_sparsified"}));
  report.claims.push_back(open_question(
      "7.11.efficient",
      "How many events does a structure have for each change of the tree of a graph, of random "
      "weights, "
      "k = n/4?",
      graph_ratio_text(results, kRandomGraphs) + certificates_text(results, kRandomGraphs) + ". " +
          ratios_told(results, kRandomGraphs) + ". " + certificates_told(results, kRandomGraphs) +
          ". Random weights say nothing of the worst case",
      kRandomGraphClusters));
  // Of one ratio of k and n alone the report's letters and the exchanged ones give the same power.
  const auto add = [&](const std::vector<lab::SeriesResult>& of_these, const char* id,
                       const char* statement, double exponent) {
    report.claims.push_back(
        growth_claim(means_of(of_these, kRandomGraph, "external", 1),
                     {id, statement, kRandomGraph, "changes", exponent, KdsPower::kOnAllMotion}));
    report.claims.back().assumptions.push_back(
        "the report prints O(k n^(1/3)) for k vertices and n edges: 7.11.as-printed");
  };
  add(results, "7.11.upper",
      "The tree of a graph with n edges and k vertices changes O(n k^(1/3)) times; of random "
      "weights, "
      "k = n/4:",
      4.0 / 3);
  add(few_vertices, "7.11.upper-few",
      "The tree of a graph with n edges and k vertices changes O(n k^(1/3)) times; of random "
      "weights, "
      "k = 16:",
      1);
}

void add_planar_claims(const std::vector<lab::SeriesResult>& results, lab::PartReport& report) {
  const auto add = [&](const char* id, const char* statement, KdsRuns runs) {
    report.claims.push_back(
        growth_claim(means_of(results, runs, "processed", 1),
                     {id, statement, runs, "events", 11.0 / 6, KdsPower::kOnAllMotion}));
    report.claims.back().assumptions.push_back(
        "linear weights, of which any two cross once, as pseudolines do; the power without its "
        "logarithms. The structure is ours, after Agarwal, Eppstein, Guibas and Henzinger (1998), "
        "and "
        "not their version for planar graphs, which has a better bound than the report");
  };
  add("7.9.clusters",
      "The tree of a planar graph of n edges has a structure with O(n^(11/6) polylog n) events; by "
      "clusters, of random weights:",
      kPlanarClusters);
  add("7.9.sparsified",
      "The tree of a planar graph of n edges has a structure with O(n^(11/6) polylog n) events; by "
      "sparsification, of random weights:",
      kPlanarSparsified);
  Told events;
  for (const NamedRuns& one : kPlanarGraphs) {
    const auto fit = lab::fit_power(means_of(results, one.runs, "processed", 1));
    const int side = side_of(fit, 11.0 / 6);
    tell(events,
         side > 0   ? "faster than n^(11/6)"
         : side < 0 ? "more slowly than n^(11/6)"
                    : "at a rate that these sizes do not tell from that of n^(11/6)",
         one.name);
  }
  report.claims.push_back(
      open_question("7.9.efficient",
                    "The report takes fewer events to be probable. Events for each change of the "
                    "tree of a planar graph:",
                    graph_ratio_text(results, kPlanarGraphs) + "; " +
                        power_text("changes", means_of(results, kPlanarCycles, "external", 1)) +
                        ". " + ratios_told(results, kPlanarGraphs) + ". Events grow " +
                        told_text(events) + ". Random weights say nothing of the worst case",
                    kPlanarClusters));
}

// Events for each change where their numbers are known: of points along a row, and of parallel edges.
void add_ratio_figures(const std::vector<lab::SeriesResult>& results, lab::PartReport& report) {
  std::vector<lab::Curve> rows, edges;
  for (const auto& [name, runs] :
       {NamedRuns{"by the order of all edges", kListRow}, NamedRuns{"by cycles", kCyclesRow},
        NamedRuns{"by clusters", kClustersRow}, NamedRuns{"maximum norm, by cycles", kNormRow},
        NamedRuns{"polygon of 12 corners, by order", kPolygonListRow},
        NamedRuns{"polygon of 12 corners, by cycles", kPolygonRow}}) {
    rows.push_back({name, events_per_change(results, runs), ""});
  }
  for (const NamedRuns& one : kParallelEdges) {
    edges.push_back({one.name, events_per_change(results, one.runs, 1), ""});
  }
  report.figures.push_back(growth_figure("Events for each change of a spanning tree along a row",
                                         "Of pass-along-row, n points of each kind, where the "
                                         "Euclidean tree changes 2n^2 - 2 times; exact "
                                         "counts, flips of the triangulation or changes of the "
                                         "cones included, and the power of n that "
                                         "fits all sizes, with its 95 % interval.",
                                         "events for a change", {0.5, 1}, std::move(rows)));
  report.figure_names.push_back("section-7-trees-row");
  report.figures.push_back(
      growth_figure("Events for each change of the tree of parallel edges",
                    "Of n parallel edges between two vertices, where the tree changes n - 1 times; "
                    "exact counts, and "
                    "the power of n that fits all sizes, with its 95 % interval.",
                    "events for a change", {0.5, 1}, std::move(edges)));
  report.figure_names.push_back("section-7-trees-edges");
}

}  // namespace

std::vector<lab::SeriesPoint> kds_section_7_trees_points(bool quick) {
  std::vector<lab::SeriesPoint> points;
  add_sizes(points, kList, {25, 35, 50, 70, 100, 200, 300}, 100, quick);
  add_sizes(points, kCycles, {25, 35, 50, 70, 100, 200, 400, 800}, 100, quick);
  add_sizes(points, kClusters, {18, 25, 35, 50, 70, 100, 200}, 50, quick);
  add_sizes(points, kNormList, {12, 18, 25, 35, 50, 100, 200}, 50, quick);
  add_sizes(points, kNormCycles, {12, 18, 25, 35, 50, 100, 200}, 50, quick);
  add_sizes(points, kPolygonList, {12, 18, 25, 35, 50, 70, 100}, 35, quick);
  add_sizes(points, kPolygonCycles, {12, 18, 25, 35, 50, 100, 200}, 50, quick);
  for (const int n : {3, 4, 6, 8, 12}) {
    if (quick && n > 8) continue;
    for (const KdsRuns& runs : {kPolygonListRow, kPolygonRow}) {
      points.push_back(kds_single(runs, n, n));
      points.back().cost = n * n * n / 5000.0;
    }
  }
  for (const int n : {3, 4, 6, 8, 12, 16, 24}) {
    if (quick && n > 12) continue;
    for (const KdsRuns& runs : {kListRow, kCyclesRow, kClustersRow, kNormRow}) {
      points.push_back(kds_single(runs, n, n));
      points.back().cost = n * n / 1000.0;
    }
  }
  for (const int n : {4, 8, 16, 32, 64, 128}) {
    if (quick && n > 64) continue;
    for (const KdsRuns& runs : {kGraphList, kGraphCycles, kGraphClusters, kGraphSparsified}) {
      points.push_back(kds_single(runs, n, 1, 1));
    }
  }
  for (const int n : {40, 80, 160, 320, 640, 1280}) {
    if (quick && n > 320) continue;
    for (const KdsRuns& runs :
         {kRandomGraph, kRandomGraphList, kRandomGraphClusters, kRandomGraphSparsified}) {
      if (runs.structure != kRandomGraph.structure && n > 640) continue;
      points.push_back(kds_random(runs, n, 8, 1));
      points.back().key.parameters.m = n / 4;
      points.back().cost = n / 1000.0;
    }
    points.push_back(kds_random(kRandomGraph, n, 8, 1));
    points.back().key.parameters.m = kFewVertices;
    points.back().cost = n / 1000.0;
    for (const KdsRuns& runs : {kPlanarCycles, kPlanarClusters, kPlanarSparsified}) {
      if (n > 640) continue;
      points.push_back(kds_random(runs, n, 8, 1));
      points.back().cost = n / 1000.0;
    }
  }
  return points;
}

lab::PartReport kds_section_7_trees_report(const std::vector<lab::SeriesResult>& results,
                                           const std::string& command) {
  std::vector<lab::SeriesResult> few_vertices, others;
  for (const lab::SeriesResult& result : results) {
    const bool is_few = result.point.key.workload == kRandomGraph.workload &&
                        result.point.key.parameters.m == kFewVertices;
    (is_few ? few_vertices : others).push_back(result);
  }
  lab::PartReport report;
  add_norm_claims(results, report);
  add_polygon_claims(results, report);
  add_euclidean_claims(results, report);
  add_planar_claims(results, report);
  add_graph_claims(others, few_vertices, report);
  std::vector<lab::Curve> curves;
  curves.push_back({"events, by the order of all edges", means_of(results, kList, "processed"), ""});
  curves.push_back({"events, by cycles", means_of(results, kCycles, "processed"), ""});
  curves.push_back({"events, by clusters", means_of(results, kClusters, "processed"), ""});
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
  add_ratio_figures(results, report);
  finish_section_7(report, results, command);
  return report;
}

}  // namespace kinex::families
