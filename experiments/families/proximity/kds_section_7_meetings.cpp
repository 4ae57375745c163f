// SPDX-License-Identifier: GPL-3.0-or-later
// Questions: how often do discs meet and part, and points change the sides of lines? (Guibas 1998,
//   section 7.)
// Scenes: fan-of-discs, n discs through one point; points-through-lines, n points and m turning lines;
//   random ones.
// Expected: n(n - 1) changes of discs and 2nm of sides, which are the hard bounds; growth like n^2.
//   The proof of incidences by a cutting, of O(n^(5/3)) certificates: a power is fitted.
// Left out: cuttings of other samples: families/arrangement/kds_section_7_cuttings.cpp, and
//   cutting_study.cpp, of `kinex verify incidences`. Hitting sets of discs: kds_section_7_hitting.cpp.
// Cost: seconds.
#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "experiments/families/points/kds_claims.h"
#include "experiments/families/proximity/experiments.h"
#include "experiments/lab/growth_words.h"

namespace kinex::families {

namespace {

constexpr KdsRuns kFanDiscs{"disc_pairs_all", "fan-of-discs"},
    kAllDiscs{"disc_pairs_all", "random-discs"}, kDiscBoxes{"disc_pairs_boxes", "random-discs"},
    kDiscGrid{"disc_pairs_grid", "random-discs"},
    kSideLines{"incidences_all", "points-through-lines"},
    kRandomSides{"incidences_all", "random-lines-and-points"},
    kCuttingSides{"incidences_cutting", "random-lines-and-points"};

std::string power_of(const char* what, const std::vector<lab::FitPoint>& points) {
  const auto fit = lab::fit_power(points);
  if (!fit) return std::string(what) + ": too few sizes";
  return fmt::format("{}: {:.0f} at n = {:.0f}, {:.0f} at n = {:.0f}, {}", what,
                     points.front().count, points.front().n, points.back().count, points.back().n,
                     lab::fit_text(*fit));
}

// "; at n = 400 they are 0.84 times those of all pairs": of a cutting, at the largest size.
std::string against_all_pairs(const std::vector<lab::SeriesResult>& results, const char* quantity) {
  const std::vector<lab::FitPoint> ratios =
      ratios_of(results, kCuttingSides, kRandomSides, quantity);
  if (ratios.empty()) return {};
  return fmt::format("; at n = {:.0f} they are {:.2f} times those of all pairs", ratios.back().n,
                     ratios.back().count);
}

std::string cutting_text(const std::vector<lab::SeriesResult>& results) {
  const std::vector<lab::FitPoint> certificates = means_of(results, kCuttingSides, "max_live"),
                                   events = means_of(results, kCuttingSides, "processed");
  const auto certificates_fit = lab::fit_power(certificates);
  return power_of("certificates", certificates) + "; " + power_of("events", events) + "; " +
         power_of("of all pairs, certificates", means_of(results, kRandomSides, "max_live")) +
         ". The certificates grow " + lab::growth_words(certificates_fit, 5.0 / 3, "n^(5/3)") +
         ", and " + lab::growth_words(certificates_fit, 2, "n^2") +
         against_all_pairs(results, "max_live") + ". The events grow " +
         lab::growth_words(lab::fit_power(events), 2, "n^2") +
         against_all_pairs(results, "processed") + ". Random motion says nothing of the worst case";
}

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
    points.push_back(kds_random(kCuttingSides, n, 8));
    points.back().cost = n * n / 5000.0;
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
  report.claims.back().assumptions = {
      "the upper half is not a matter of runs: the side of a point and a line, both of linear "
      "coefficients, is the sign of a polynomial of degree 2, which changes twice at most, those "
      "of all "
      "pairs 2nm times; this bound is checked in every run"};
  report.claims.push_back(growth_claim(
      means_of(results, kRandomSides, "external"),
      {"7.12.random", "Of random motion, sides change Theta(n^2) times (not in the report).",
       kRandomSides, "changes of sides", 2}));
  report.claims.push_back(
      agreement_claim(results, "7.12.same-changes",
                      "A proof by a cutting has as many changes of sides as that of all pairs.",
                      kCuttingSides, {kRandomSides.structure, kCuttingSides.structure}));
  report.claims.push_back(open_question("7.12.proof",
                                        "Sides of n lines and n points have a proof of O(n^(5/3)) "
                                        "certificates, with nearly n^2 events. By a "
                                        "random sample of n^(1/3) lines, of random motion:",
                                        cutting_text(results), kCuttingSides));
  report.claims.back().expected =
      "certificates, the most at one time: n^(5/3) log n, those of the sample included; events: up "
      "to "
      "r n^2 log n, r = n^(1/3), if lines pass the corners of all trapezoids";
  report.claims.back().assumptions = {
      "a random sample instead of the report's eps-net; runs cannot confirm a bound on all motions",
      "the power without its logarithm; n: lines and points together, half of each",
      "r: the cube root of the number of lines, rounded up; 7.12.cuttings has sizes where it is an "
      "integer"};
  report.claims.push_back(count_claim(
      results,
      {"7.14.changes",
       "The pairs of discs that meet change Theta(n^2) times at worst: each two meet and part "
       "once (not in the report).",
       kFanDiscs, "external", "changes", "n(n - 1), the bound of linear motions",
       [](double n, double) { return n * (n - 1); }}));
  report.claims.back().assumptions = {
      "the upper half is not a matter of runs: the distance of two centres of linear motion, less "
      "two "
      "linear radii, is a convex function, so that two discs meet once and part once at most, all "
      "of "
      "them n(n - 1) times; this bound is checked in every run"};
  report.claims.push_back(agreement_claim(
      results, "7.14.same-changes",
      "The pairs of discs that meet are maintained by all pairs, by their boxes, and by a grid.",
      kDiscBoxes, {kAllDiscs.structure, kDiscBoxes.structure, kDiscGrid.structure}));
  std::vector<lab::Curve> curves;
  curves.push_back({"events, all pairs", means_of(results, kAllDiscs, "processed"), ""});
  curves.push_back({"events, boxes", means_of(results, kDiscBoxes, "processed"), ""});
  curves.push_back({"events, grid", means_of(results, kDiscGrid, "processed"), ""});
  curves.push_back(
      {"sides of lines, by a cutting", means_of(results, kCuttingSides, "processed"), ""});
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
