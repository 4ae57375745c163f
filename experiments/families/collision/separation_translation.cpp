// SPDX-License-Identifier: GPL-3.0-or-later
// Question: how often does the certificate of two polygons change if they do not turn?
// Motion: past each other on a line in 16 directions; once round each other. Nearly regular
//   polygons of radius 1 at separation 2^-k.
// Expected: O(log mu) on a line, O(mu) on an algebraic path, and never fewer than the certificates
//   for convex sets of positions that the path needs.
// Cost: a minute; --quick: 6 s.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "experiments/families/collision/separation_paper.h"
#include "experiments/families/collision/turned_scene.h"

namespace kinex::families {

namespace {

constexpr const char* kMethods[] = {"separation_mixed", "separation_minkowski",
                                    "separation_hysteresis"};
constexpr const char* kLinesOnly =
    "straight lines only: the public abstract names convex curves beside them, but a circle round "
    "a disc is one and needs Omega(mu) certificates that prove convex sets of positions";

double fewest_certificates(const lab::SeriesResult& result) {
  const lab::RunKey& key = result.point.key;
  const double radius = 2 + key.parameters.separation.value().to_double();
  const double rho = 2 * std::cos(std::numbers::pi / key.parameters.n);
  return std::ceil(std::numbers::pi / std::acos(rho / radius) - 1e-9);
}

lab::PaperClaim lower_bound(const std::vector<lab::SeriesResult>& results) {
  lab::PaperClaim claim;
  claim.id = "translation.optimal";
  claim.kind = "expectation";
  claim.statement = "In the worst case an algebraic translation needs Omega(mu) certificates.";
  claim.expected =
      "certificates of every run at least ceil(pi / arccos(rho / R)), and that at least mu";
  claim.tolerance = "none";
  claim.assumptions = {
      "a certificate proves a convex set of positions free", "certificates are events + 1",
      "that all methods need as many is a theorem under the first assumption; runs show that it is "
      "at least mu here, and that three methods keep to it"};
  double least = INFINITY, least_over_mu = INFINITY, most_over_mu = 0;
  for (const lab::SeriesResult& result : results) {
    if (result.point.key.workload != "polygon-orbit") continue;
    const double fewest = fewest_certificates(result);
    least = std::min(least, (result.mean("processed").smallest() + 1) / fewest);
    least_over_mu = std::min(least_over_mu, fewest / mu_of(result));
    most_over_mu = std::max(most_over_mu, fewest / mu_of(result));
  }
  if (!std::isfinite(least)) {
    claim.observed = "no run";
    return claim;
  }
  claim.verdict =
      least >= 1 && least_over_mu >= 1 ? lab::Verdict::kConfirmed : lab::Verdict::kRefuted;
  claim.observed = fmt::format(
      "{:.3g} times the bound at least; the bound is {:.3g} to {:.3g} times mu, and falls where "
      "the "
      "separation comes near the sagitta of the polygons' edges",
      least, least_over_mu, most_over_mu);
  return claim;
}

// Where events reach the number of edges, the polygon bounds them, and no law of mu shows: the sizes before.
std::vector<lab::FitPoint> below_edges(const std::vector<lab::SeriesResult>& results,
                                       const std::string& method) {
  std::vector<lab::SeriesResult> below;
  std::copy_if(results.begin(), results.end(), std::back_inserter(below),
               [](const lab::SeriesResult& result) {
                 return result.mean("processed").mean() < result.point.key.parameters.n;
               });
  return points_of(below, method, "polygon-orbit", mu_of);
}

}  // namespace

std::vector<lab::SeriesPoint> separation_translation_points(bool quick) {
  std::vector<lab::SeriesPoint> points;
  const int n = quick ? 128 : 1024;
  for (const char* method : kMethods) {
    for (int k = 3; k <= (quick ? 11 : 18); ++k) {
      points.push_back(separation_point(method, "polygon-orbit", n, inverse_power(k)));
      points.back().cost = quick ? 0.2 : 2;
    }
  }
  for (const char* method : kMethods) {
    for (int k = 2; k <= (quick ? 14 : 20); k += 2) {
      points.push_back(
          separation_point(method, "polygon-line", quick ? 64 : 512, inverse_power(k), 16));
      points.back().key.change = &kTurned;
      points.back().cost = quick ? 1 : 8;
    }
  }
  return points;
}

lab::PartReport separation_translation_report(const std::vector<lab::SeriesResult>& results,
                                              const std::string& command) {
  lab::PartReport report;
  const auto log_mu = [](const lab::SeriesResult& result) { return std::log2(mu_of(result)); };
  lab::PaperClaim line = log_claim(
      report, "translation.line", "A linear translation changes the certificate O(log mu) times.",
      "events", points_of(results, "separation_minkowski", "polygon-line", mu_of), "mu");
  line.assumptions = {
      kLinesOnly, "hierarchy of the Minkowski sum; every run also keeps to 2 events a level + 8"};
  set_small_run(line, results, "separation_minkowski", "polygon-line");
  report.claims.push_back(std::move(line));
  std::vector<lab::Curve> rounds, lines;
  for (const char* method : kMethods) {
    const auto round = points_of(results, method, "polygon-orbit", mu_of);
    const bool is_hysteresis = std::string(method) == "separation_hysteresis";
    const auto fitted = is_hysteresis ? below_edges(results, method) : round;
    lab::PaperClaim claim =
        power_claim(std::string("translation.algebraic.") + method,
                    "A translation along an algebraic path changes the certificate O(mu) times.",
                    fitted, "mu", 1);
    claim.assumptions = {"the path: once round the other polygon"};
    if (is_hysteresis) {
      claim.assumptions.push_back("the wedges and their bound are worked out here");
      claim.assumptions.push_back(
          "fitted where events are fewer than the edges of a polygon: no more wedges are passed on "
          "a round, so that the counts stay there");
    }
    set_small_run(claim, results, method, "polygon-orbit");
    report.claims.push_back(std::move(claim));
    rounds.push_back({method, round, ""});
    if (const std::optional<lab::Fit> fit = lab::fit_power(fitted)) {
      rounds.back().value = lab::power_value(*fit, "mu");
    }
    lines.push_back({method, points_of(results, method, "polygon-line", mu_of), ""});
    const auto by_log = points_of(results, method, "polygon-line", log_mu);
    if (const std::optional<lab::Fit> fit = lab::fit_power(by_log)) {
      lines.back().value = lab::power_value(*fit, "(log mu)");
    }
  }
  report.claims.push_back(lower_bound(results));
  set_small_run(report.claims.back(), results, kMethods[0], "polygon-orbit");
  lab::Curve least{"lower bound", {}, ""};
  for (const lab::SeriesResult& result : results) {
    const lab::RunKey& key = result.point.key;
    if (key.structure != kMethods[0] || key.workload != "polygon-orbit") continue;
    least.points.push_back({mu_of(result), fewest_certificates(result), 0});
  }
  least.is_bound = true;
  least.look = 3;
  rounds.push_back(std::move(least));
  const std::string mu = "mu = min(n, sqrt(D / separation))";
  report.figures = {
      curves_figure(
          "Once round: events against mu",
          "Separation falls from left to right. Dashed: the least number of certificates. "
          "The legend has the power that fits, with its 95 % interval; of separation_hysteresis "
          "where "
          "events are fewer than the edges of a polygon.",
          {mu, "", true, true, {1}}, std::move(rounds)),
      curves_figure("Past on a line: events against mu",
                    "Means over 16 directions with bars of two standard errors; the legend has the "
                    "power of log mu that fits, with its 95 % interval.",
                    {mu, "", true, false, {}}, std::move(lines))};
  report.figure_names = {"translation-round", "translation-line"};
  finish(report, results, command);
  return report;
}

}  // namespace kinex::families
