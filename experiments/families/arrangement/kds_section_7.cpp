// SPDX-License-Identifier: GPL-3.0-or-later
// Question: how large is the proof of a whole arrangement of moving lines by its vertical decomposition, in how
//   many certificates is a line, and how many events are there? (Guibas 1998, section 7: Theta(n^2),
//   Theta(n), nearly n^3.)
// Scenes: random chords of the unit square; three-bundles, where (n/3)^3 triples of lines meet.
// Expected: the integer, in every run; certificates like n^2, those of a line like n. The bound on the events
//   of all motions runs can only contradict.
// Cost: about a minute; --quick: seconds.
#include <string>
#include <utility>
#include <vector>

#include "experiments/families/arrangement/experiments.h"
#include "experiments/families/points/kds_claims.h"

namespace kinex::families {

namespace {

constexpr KdsRuns kWalls{"trapezoids_2", "random-lines"},
    kOrders{"line_arrangement_2", "random-lines"}, kBundles{"line_arrangement_2", "three-bundles"},
    kWallsOfBundles{"trapezoids_2", "three-bundles"};

}  // namespace

std::vector<lab::SeriesPoint> kds_section_7_arrangements_points(bool quick) {
  std::vector<lab::SeriesPoint> points;
  for (const int n : {6, 8, 11, 16, 22, 32, 45}) {
    if (quick && n > 16) continue;
    for (const KdsRuns& runs : {kWalls, kOrders}) {
      points.push_back(kds_random(runs, n, quick ? 4 : 8));
      points.back().cost = n * n * n / 5000.0;
    }
  }
  for (const int n : {6, 9, 12, 15, 18, 24, 30}) {
    if (quick && n > 18) continue;
    for (const KdsRuns& runs : {kBundles, kWallsOfBundles}) {
      points.push_back(kds_single(runs, n));
      points.back().cost = n * n * n / 20000.0;
    }
  }
  return points;
}

lab::PartReport kds_section_7_arrangements_report(const std::vector<lab::SeriesResult>& results,
                                                  const std::string& command) {
  lab::PartReport report;
  report.claims.push_back(bound_claim(
      results,
      {"7.13.proof", "The vertical decomposition of n lines has a proof of size Theta(n^2).",
       kWalls, "max_live", "certificates, those of the order of crossings included",
       "2n^2 - 2n - 1", [](double n, double) { return 2 * n * n - 2 * n - 1; }}));
  if (const auto fit = lab::fit_power(means_of(results, kWalls, "max_live"))) {
    report.claims.back().observed += "; " + lab::fit_text(*fit);
  }
  report.claims.push_back(growth_claim(means_of(results, kWalls, "max_per_object"),
                                       {"7.13.local", "A line is in Theta(n) certificates of it.",
                                        kWalls, "certificates of one line", 1}));
  report.claims.push_back(count_claim(
      results, {"7.13.lower", "The arrangement of lines of linear motion changes Omega(n^3) times.",
                kBundles, "external", "triples that turn over", "(n/3)^3",
                [](double n, double) { return n * n * n / 27; }}));
  for (const bool random : {true, false}) {
    const KdsRuns runs = random ? kWalls : kWallsOfBundles;
    report.claims.push_back(growth_claim(
        means_of(results, runs, "processed"),
        {random ? "7.13.events" : "7.13.events-bundles",
         random ? "The vertical decomposition has nearly n^3 events at most; of random motion:"
                : "The vertical decomposition has nearly n^3 events at most; of lines in three "
                  "bundles:",
         runs, "events", 3, KdsPower::kOnAllMotion}));
  }
  std::vector<lab::Curve> curves;
  curves.push_back(
      {"events of trapezoids, random motion", means_of(results, kWalls, "processed"), ""});
  curves.push_back(
      {"events of trapezoids, three bundles", means_of(results, kWallsOfBundles, "processed"), ""});
  curves.push_back(
      {"changes of the arrangement, random motion", means_of(results, kOrders, "external"), ""});
  curves.push_back(
      {"changes of the arrangement, three bundles", means_of(results, kBundles, "external"), ""});
  curves.push_back({"certificates, random motion", means_of(results, kWalls, "max_live"), ""});
  report.figures.push_back(growth_figure("Arrangements of moving lines, and their trapezoids",
                                         "Events and certificates of a run; of random motion means "
                                         "with bars of two standard errors; the power of n "
                                         "that fits all sizes, with its 95 % interval.",
                                         "events", {2, 3}, std::move(curves)));
  report.figure_names = {"section-7-arrangements"};
  finish_section_7(report, results, command);
  return report;
}

}  // namespace kinex::families
