// SPDX-License-Identifier: GPL-3.0-or-later
// Questions: how often do discs meet and part, and points change the sides of lines? (Guibas 1998,
//   section 7.)
// Scenes: fan-of-discs, n discs through one point; points-through-lines, n points and m turning lines;
//   random ones.
// Expected: n(n - 1) changes of discs and 2nm of sides, which are the hard bounds; growth like n^2.
// Left out: smaller proofs of incidences (cuttings), a study of `kinex verify incidences`:
//   families/arrangement/cutting_study.cpp. Hitting sets of discs: kds_section_7_hitting.cpp.
// Cost: seconds.
#include <utility>

#include "experiments/families/points/kds_claims.h"
#include "experiments/families/proximity/experiments.h"

namespace kinex::families {

namespace {

constexpr KdsRuns kFanDiscs{"disc_pairs_all", "fan-of-discs"}, kAllDiscs{"disc_pairs_all", "random-discs"},
    kDiscBoxes{"disc_pairs_boxes", "random-discs"}, kDiscGrid{"disc_pairs_grid", "random-discs"},
    kSideLines{"incidences_all", "points-through-lines"},
    kRandomSides{"incidences_all", "random-lines-and-points"};

}  // namespace

std::vector<lab::SeriesPoint> kds_section_7_meetings_points(bool quick) {
  std::vector<lab::SeriesPoint> points;
  for (const int n : {4, 8, 16, 32}) {
    if (quick && n > 16) continue;
    points.push_back(kds_single(kFanDiscs, n));
  }
  for (const int n : {4, 8, 16, 32, 64}) {
    if (quick && n > 32) continue;
    points.push_back(kds_single(kSideLines, n, n));
  }
  for (const int n : {25, 35, 50, 70, 100, 200, 400}) {
    if (quick && n > 100) continue;
    for (const KdsRuns& runs : {kDiscBoxes, kDiscGrid}) points.push_back(kds_random(runs, n, 8));
    if (n <= 200) points.push_back(kds_random(kAllDiscs, n, 8));
    points.push_back(kds_random(kRandomSides, n, 8));
  }
  return points;
}

lab::PartReport kds_section_7_meetings_report(const std::vector<lab::SeriesResult>& results,
                                              const std::string& command) {
  lab::PartReport report;
  report.claims.push_back(count_claim(
      results,
      {"7.12.lower",
       "Sides of n lines and n points change Theta(n^2) times at worst: twice for each line and point.",
       kSideLines, "external", "changes of sides", "2nm, the bound of linear motions",
       [](double n, double m) { return 2 * n * m; }}));
  report.claims.push_back(growth_claim(
      means_of(results, kRandomSides, "external"),
      {"7.12.random", "Of random motion, sides change Theta(n^2) times (not in the report).",
       kRandomSides, "changes of sides", 2}));
  report.claims.push_back(count_claim(
      results, {"7.14.changes",
                "The pairs of discs that meet change Theta(n^2) times at worst: each two meet and part "
                "once.",
                kFanDiscs, "external", "changes", "n(n - 1), the bound of linear motions",
                [](double n, double) { return n * (n - 1); }}));
  const KdsAgreement agreement =
      agreement_of(results, {kAllDiscs.structure, kDiscBoxes.structure, kDiscGrid.structure});
  lab::PaperClaim same;
  same.id = "7.14.same-changes";
  same.kind = "finding";
  same.statement =
      "The pairs of discs that meet are maintained by all pairs, by their boxes, and by a grid.";
  same.expected = "as many changes by each, on every scene";
  same.tolerance = "none";
  same.small_run.structure = kDiscBoxes.structure;
  same.small_run.workload = kDiscBoxes.workload;
  same.verdict = !agreement.difference.empty() ? lab::Verdict::kRefuted
                 : agreement.scenes > 0        ? lab::Verdict::kConfirmed
                                               : lab::Verdict::kOpen;
  same.observed = agreement.difference.empty()
                      ? "as many on all " + std::to_string(agreement.scenes) + " scenes"
                      : agreement.difference;
  report.claims.push_back(std::move(same));
  std::vector<lab::Curve> curves;
  curves.push_back({"events, all pairs", means_of(results, kAllDiscs, "processed"), ""});
  curves.push_back({"events, boxes", means_of(results, kDiscBoxes, "processed"), ""});
  curves.push_back({"events, grid", means_of(results, kDiscGrid, "processed"), ""});
  curves.push_back({"sides of lines", means_of(results, kRandomSides, "external"), ""});
  report.figures.push_back(growth_figure(
      "Discs that meet, and sides of lines",
      "Events of a run of random motion, radii at most 1 / (4 sqrt(n)); means with bars of two standard "
      "errors; the power of n that fits all sizes, with its 95 % interval.",
      "events", {1, 1.5, 2}, std::move(curves)));
  report.figure_names = {"section-7-meetings"};
  finish_section_7(report, results, command);
  return report;
}

}  // namespace kinex::families
