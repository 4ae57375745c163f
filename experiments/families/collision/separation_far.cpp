// SPDX-License-Identifier: GPL-3.0-or-later
// Questions: do certificates last for a constant fraction of the separation, on paths that are not
//   smooth? Do outer hierarchies have few vertices far from their polygon?
// Expected: no wedge fails before 0.23 of the separation at which it was made; the events of an
//   approach grow like the number of halvings of the distance; trembling causes none. Bounds on all
//   motions and on all polygons stay open.
// Cost: 5 s; --quick: 2 s.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "experiments/families/collision/experiments.h"
#include "experiments/families/collision/separation_paper.h"
#include "experiments/lab/measures.h"

namespace kinex::families {

std::vector<lab::SeriesPoint> separation_hysteresis_points(bool quick) {
  std::vector<lab::SeriesPoint> points;
  for (const char* method : {"separation_hysteresis", "separation_mixed"}) {
    for (int k = 2; k <= (quick ? 14 : 24); ++k) {
      points.push_back(separation_point(method, "polygon-approach", 64, inverse_power(k)));
    }
    for (const int m : {16, 64, 256}) {
      if (quick && m > 64) continue;
      points.push_back(separation_point(method, "polygon-jitter", 16, std::nullopt));
      points.back().key.parameters.m = m;
      points.push_back(
          separation_point(method, "polygon-kinks", 16, Rational(1) / Rational(10), quick ? 4 : 16));
      points.back().key.parameters.m = m;
    }
  }
  return points;
}

lab::PartReport separation_hysteresis_report(const std::vector<lab::SeriesResult>& results,
                                        const std::string& command) {
  lab::PartReport report;
  const auto halvings = [](const lab::SeriesResult& result) { return std::log2(nearness_of(result)); };
  const std::string own = "separation_hysteresis";
  lab::PaperClaim lasting;
  lasting.id = "hysteresis.lasting";
  lasting.kind = "bound";
  lasting.statement =
      "A new certificate cannot fail before the objects have moved by a constant fraction of their "
      "separation.";
  lasting.expected = "0.23 of the separation at least";
  lasting.tolerance = "none";
  lasting.assumptions = {"certificate, metric and constant are worked out here"};
  std::size_t runs = 0, broken = 0, trembles = 0;
  double trembling = 0;
  for (const lab::SeriesResult& result : results) {
    if (result.point.key.structure != own) continue;
    for (const lab::RunRecord& run : result.runs) {
      ++runs;
      broken += run.trouble.find("displacement") == std::string::npos ? 0 : 1;
    }
    if (result.point.key.workload == "polygon-jitter") {
      trembles += result.runs.size();
      trembling = std::max(trembling, result.mean("processed").largest());
    }
  }
  lasting.observed = fmt::format("in all wedges of {} of {} runs", runs - broken, runs);
  lasting.verdict = broken != 0 ? lab::Verdict::kRefuted
                    : runs == 0 ? lab::Verdict::kOpen
                                : lab::Verdict::kConfirmed;
  set_small_run(lasting, results, own, "polygon-approach");
  report.claims.push_back(std::move(lasting));

  lab::PaperClaim calm;
  calm.id = "hysteresis.trembling";
  calm.kind = "expectation";
  calm.statement = "Far apart, a wiggly motion costs no more than a smooth one.";
  calm.expected = "no event while a polygon trembles across the side of a tile";
  calm.tolerance = "none";
  calm.assumptions = {"the scene: a polygon trembles across the side of a tile"};
  calm.observed = fmt::format("at most {:.0f} in {} runs", trembling, trembles);
  calm.verdict = trembling != 0  ? lab::Verdict::kRefuted
                 : trembles == 0 ? lab::Verdict::kOpen
                                 : lab::Verdict::kConfirmed;
  set_small_run(calm, results, own, "polygon-jitter");
  report.claims.push_back(std::move(calm));

  const auto approach = points_of(results, own, "polygon-approach", halvings);
  lab::PaperClaim cover = log_claim(
      report, "hysteresis.cover",
      "Worked out from the bound by a cover of the path by balls, which needs no smoothness (and "
      "which `kinex verify collision` counts ball by ball): an approach costs as many events as the "
      "times by which the distance is halved.",
      "events of an approach", points_of(results, own, "polygon-approach", nearness_of),
      "4 / separation");
  cover.assumptions = {"the path: straight from side to side, twice as near each time"};
  set_small_run(cover, results, own, "polygon-approach");
  report.claims.push_back(std::move(cover));
  const auto kinks = [](const lab::SeriesResult& result) { return 1.0 * result.point.key.parameters.m; };
  report.figures = {curves_figure(
      "Paths that are not smooth: events",
      "Means over random walks with kinks, with bars of two standard errors; trembling: a polygon "
      "trembles across the side of a tile. The legend has the power that fits, with its 95 % "
      "interval.",
      {"x = halvings of the distance, or kinks", "", true, true, {1}},
      {{"hysteresis, approach", approach, ""},
       {"mixed, approach", points_of(results, "separation_mixed", "polygon-approach", halvings),
        ""},
       {"hysteresis, kinks", points_of(results, own, "polygon-kinks", kinks), ""},
       {"mixed, kinks", points_of(results, "separation_mixed", "polygon-kinks", kinks), ""},
       {"hysteresis, trembling", points_of(results, own, "polygon-jitter", kinks), ""},
       {"mixed, trembling", points_of(results, "separation_mixed", "polygon-jitter", kinks), ""}})};
  report.figure_names = {"hysteresis"};
  finish(report, results, command);
  return report;
}

std::vector<lab::SeriesPoint> separation_hierarchies_points(bool) { return {}; }

lab::PartReport separation_hierarchies_report(const lab::StudyResult& study,
                                              const std::string& command) {
  lab::PartReport report;
  for (const lab::Check& check : study.checks) {
    lab::PaperClaim claim;
    claim.id = "hierarchies." + check.claim.substr(check.claim.find('.') + 1);
    claim.kind = "bound";
    claim.statement = check.source + ".";
    if (check.claim == "outer_hierarchy.nodes") {
      claim.statement =
          "The Dudley hierarchy has O(sqrt(D / s)) vertices at distance s or more: nodes over "
          "min(n, sqrt(D / s)).";
    }
    claim.expected = check.expected;
    claim.tolerance = "none";
    claim.observed = check.observed;
    claim.verdict = check.verdict == lab::Verdict::kGaveUp ? lab::Verdict::kOpen : check.verdict;
    claim.assumptions = {"policies of cuts and constants are worked out here"};
    claim.no_small_run = "a hierarchy is built once and nothing of it moves: there is no log";
    report.claims.push_back(std::move(claim));
  }
  report.tables = lab::markdown(study.table).substr(1);
  finish(report, {}, command, "polygons cannot confirm a bound on all polygons");
  return report;
}

}  // namespace kinex::families
