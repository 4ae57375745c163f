// SPDX-License-Identifier: GPL-3.0-or-later
// Question: does the kinetic Delaunay triangulation have one certificate for each edge, a flip for
//   each failure and no other event, and how often does it change? (Guibas 1998, section 7.)
// Scenes: random motion; hull-worst, m slow points on a parabola and n that visit their gaps;
//   expanding-circle, where one point has all others as neighbours; skew-rows, two rows of n points
//   in space and m that pass between them, one after another.
// Expected: 3n - 3 certificates; no internal event; a point with certificates in proportion to n;
//   growth like n^2 on hull-worst, n = m; in space 2n^2 + 4n - 10 changes by one that passes, and
//   2n^3 + 6n - 16 for n = m: formulas found by runs, of which the orders n^2 and n^3 have a proof. The
//   bounds on all motions, O(n^3 2^alpha(n)) in the plane, runs can only contradict.
// Cost: about a minute; --quick: seconds.
#include <string>
#include <utility>
#include <vector>

#include "experiments/families/points/kds_claims.h"
#include "experiments/families/triangulation/experiments.h"

namespace kinex::families {

namespace {

constexpr KdsRuns kRandomSites{"delaunay_2", "uniform-square"}, kQuadratic{"delaunay_2", "hull-worst"},
    kWheel{"delaunay_2", "expanding-circle"}, kSkewRows{"delaunay_3", "skew-rows"};

}  // namespace

std::vector<lab::SeriesPoint> kds_section_7_delaunay_points(bool quick) {
  std::vector<lab::SeriesPoint> points;
  for (const int n : {25, 50, 100, 200, 400, 800}) {
    if (quick && n > 200) continue;
    points.push_back(kds_random(kRandomSites, n, quick ? 4 : 8));
    points.back().cost = n / 200.0;
  }
  for (const int n : {6, 8, 12, 16, 24, 32, 48, 64}) {
    if (quick && n > 32) continue;
    points.push_back(kds_single(kQuadratic, n, n));
    points.back().cost = n * n / 1000.0;
  }
  for (const int n : {8, 16, 32, 64, 128}) {
    if (quick && n > 64) continue;
    points.push_back(kds_single(kWheel, n));
  }
  for (const int n : {2, 3, 4, 6, 8, 12, 16, 24, 32}) {
    if (quick && n > 16) continue;
    points.push_back(kds_single(kSkewRows, n, 1, 3));
    points.back().cost = n * n / 1000.0;
  }
  for (const int n : {3, 4, 6, 8, 12, 16, 24}) {
    if (quick && n > 16) continue;
    points.push_back(kds_single(kSkewRows, n, n, 3));
    points.back().cost = n * n * n / 5000.0;
  }
  return points;
}

lab::PartReport kds_section_7_delaunay_report(const std::vector<lab::SeriesResult>& results,
                                              const std::string& command) {
  lab::PartReport report;
  report.claims.push_back(count_claim(
      results, {"7.1.certificates", "One certificate for each edge proves the triangulation.", kRandomSites,
                "max_live", "certificates", "3n - 3, those of the hull's edges included",
                [](double n, double) { return 3 * n - 3; }}));
  const std::vector<lab::FitPoint> ratio = ratios_of(results, kRandomSites, "processed", "external");
  lab::PaperClaim events;
  events.id = "7.1.events";
  events.kind = "finding";
  events.statement =
      "A flip replaces the edge whose certificate fails, and there is no other event: the structure is "
      "strongly efficient.";
  events.expected = "1 event for each change of the triangulation, in every run";
  events.tolerance = "none";
  events.small_run.structure = kRandomSites.structure;
  events.small_run.workload = kRandomSites.workload;
  events.assumptions = {"points in general position: at degenerate instants there are internal events"};
  bool all_equal = !ratio.empty();
  std::size_t runs = 0;
  for (const lab::SeriesResult& result : results) {
    if (result.point.key.workload == kWheel.workload) continue;
    for (const lab::RunRecord& run : result.runs) {
      ++runs;
      if (run.processed == run.external) continue;
      all_equal = false;
      events.observed += (events.observed.empty() ? "" : "; ") + run.key + ": " +
                         std::to_string(run.processed) + " events, " + std::to_string(run.external) +
                         " changes";
    }
  }
  if (events.observed.empty()) {
    events.observed = "as many events as changes in all " + std::to_string(runs) + " runs";
  }
  events.verdict = all_equal ? lab::Verdict::kConfirmed : lab::Verdict::kRefuted;
  report.claims.push_back(std::move(events));
  report.claims.push_back(growth_claim(
      means_of(results, kWheel, "max_per_object"),
      {"7.1.local", "The structure is not local: a point may be in a number of certificates proportional "
                    "to n.",
       kWheel, "the certificates of one point", 1}));
  report.claims.push_back(
      growth_claim(means_of(results, kQuadratic, "external"),
                   {"7.2.lower", "The triangulation changes Omega(n^2) times on linear motions.",
                    kQuadratic, "changes", 2, KdsPower::kAtLeast}));
  report.claims.push_back(growth_claim(
      means_of(results, kQuadratic, "external"),
      {"7.2.upper", "The triangulation changes a nearly cubic number of times at most.", kQuadratic,
       "changes", 3, KdsPower::kOnAllMotion}));
  // One that passes, and as many as there are points in a row.
  std::vector<lab::SeriesResult> one, many;
  for (const lab::SeriesResult* result : results_of(results, kSkewRows, 3)) {
    (result->point.key.parameters.m == 1 ? one : many).push_back(*result);
  }
  report.claims.push_back(count_claim(
      one, {"7.2.passage",
            "In space one point that passes between two rows of n points changes Omega(n^2) cells.",
            kSkewRows, "external", "changes", "2n^2 + 4n - 10",
            [](double n, double) { return 2 * n * n + 4 * n - 10; }}));
  // Of the orders, by skew_rows.cpp.
  const std::string proof =
      "if the rows are taken as straight, the (n - 1)^2 spheres through two neighbours of each row "
      "are "
      "empty but for a point that passes, which is in each for a while; a flip removes three cells "
      "at "
      "most";
  const std::string formula = "the formula is of these runs; it is not proved for all n";
  report.claims.back().assumptions = {
      "the order is proved, with at least (n - 1)^2 / 3 changes for every n: " + proof, formula};
  report.claims.push_back(count_claim(
      many, {"7.2.lower-space",
             "In space n points that pass between two rows of n points change Omega(n^3) cells.",
             kSkewRows, "external", "changes", "2n^3 + 6n - 16",
             [](double n, double) { return 2 * n * n * n + 6 * n - 16; }}));
  report.claims.back().assumptions = {
      "the order is proved, with at least n(n - 1)^2 / 3 changes for every n, if the points of "
      "skew-rows "
      "pass nearer to one line from n = 100 on: " +
          proof,
      formula};
  std::vector<lab::Curve> curves;
  curves.push_back({"plane: hull-worst, m = n", means_of(results, kQuadratic, "external"), ""});
  curves.push_back({"space: skew-rows, m = 1", means_of(one, kSkewRows, "external", 3), ""});
  curves.push_back({"space: skew-rows, m = n", means_of(many, kSkewRows, "external", 3), ""});
  curves.push_back({"plane: random motion", means_of(results, kRandomSites, "external"), ""});
  report.figures.push_back(growth_figure(
      "How often Delaunay triangulations change",
      "Changes of a run, and the power of n that fits all sizes, with its 95 % interval.",
      "changes of the triangulation", {1.5, 2, 3}, std::move(curves)));
  report.figure_names = {"section-7-delaunay"};
  finish_section_7(report, results, command);
  // Of six points of each kind the second program would look at 495 sets of four for a minute.
  for (lab::PaperClaim& claim : report.claims) {
    lab::WorkloadParameters& parameters = claim.small_run.parameters;
    if (claim.small_run.workload == kQuadratic.workload) parameters.n = parameters.m = 4;
    if (claim.id == "7.2.lower-space") parameters.n = parameters.m = 3;
  }
  return report;
}

}  // namespace kinex::families
