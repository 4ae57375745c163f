// SPDX-License-Identifier: GPL-3.0-or-later
// Questions: how often does the certificate change when the polygons turn, what does a change cost,
//   and what do methods that follow features cost?
// Motion: mu orbits during one turn, at separation 2 / mu^2; a turn in front of a fan of edges.
// Expected: O(mu^2) events of O(log mu) signs each; n (3n + 2) changes of closest features, at any
//   separation, and n (2n + 2) of tangents; of the mixed hierarchy as many for every n, far apart.
// Cost: 12 s; --quick: 3 s.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include "experiments/families/collision/separation_paper.h"

namespace kinex::families {

namespace {

// The least separation of the turns before a fan.
Rational nearest_turn() { return Rational(Integer(1), Integer(10)); }

// Those at which the polygons are far apart.
std::array<Rational, 2> far_turns() { return {Rational(2), Rational(29)}; }

double events(const lab::SeriesResult& result) { return result.mean("processed").mean(); }

lab::PaperClaim far_claim(const std::vector<lab::SeriesResult>& results) {
  lab::PaperClaim claim;
  claim.id = "features.separation-sensitive";
  claim.kind = "finding";
  claim.statement = "Far apart, the mixed hierarchy does not see the features.";
  claim.expected = "as many events for every n, in these turns at separation 2 and 29";
  claim.tolerance = "none";
  bool differ = false, compared = true;
  for (const Rational& separation : far_turns()) {
    double least = INFINITY, most = 0;
    std::set<int> sizes;
    for (const lab::SeriesResult& result : results) {
      const lab::RunKey& key = result.point.key;
      if (key.structure != "separation_mixed" || key.parameters.separation != separation) continue;
      if (result.runs.empty()) continue;
      least = std::min(least, events(result));
      most = std::max(most, events(result));
      sizes.insert(key.parameters.n);
    }
    compared = compared && sizes.size() > 1;
    if (sizes.empty()) continue;
    differ = differ || least != most;
    claim.observed +=
        fmt::format("{}{:.6g} to {:.6g} at separation {}", claim.observed.empty() ? "" : ", ",
                    least, most, separation.to_string());
  }
  if (claim.observed.empty()) claim.observed = "no run";
  claim.verdict = differ     ? lab::Verdict::kRefuted
                  : compared ? lab::Verdict::kConfirmed
                             : lab::Verdict::kOpen;
  set_small_run(claim, results, "separation_mixed", "polygon-fan");
  return claim;
}

}  // namespace

std::vector<lab::SeriesPoint> separation_rigid_points(bool quick) {
  std::vector<lab::SeriesPoint> points;
  for (const char* method : {"separation_mixed", "separation_hysteresis"}) {
    for (const int mu : {2, 3, 4, 6, 8, 12, 16, 24, 32}) {
      if (quick && mu > 12) continue;
      points.push_back(separation_point(method, "polygon-spin-orbit", quick ? 32 : 128,
                                        Rational(2) / Rational(mu * mu)));
      points.back().key.parameters.turns = mu;
      points.back().cost = 0.01 * mu * mu;
    }
  }
  return points;
}

lab::PartReport separation_rigid_report(const std::vector<lab::SeriesResult>& results,
                                   const std::string& command) {
  lab::PartReport report;
  const auto mixed = points_of(results, "separation_mixed", "polygon-spin-orbit", mu_of);
  lab::PaperClaim claim =
      power_claim("rigid.mu", "An algebraic rigid motion changes the certificate O(mu^2) times.",
                  mixed, "mu", 2);
  claim.assumptions = {
      "the motion: mu rounds in one turn, so its degree grows with mu; of constant degree none is "
      "known here that needs mu^2"};
  set_small_run(claim, results, "separation_mixed", "polygon-spin-orbit");
  report.claims.push_back(std::move(claim));

  std::vector<lab::FitPoint> signs;
  double most = 0, certificates = 0;
  for (const lab::SeriesResult& result : results) {
    if (result.point.key.structure != "separation_mixed") continue;
    const double mu = mu_of(result), each = result.mean("signs").mean() / events(result);
    signs.push_back({mu, each, 0});
    most = std::max(most, each / (1 + std::log2(mu)));
    certificates = std::max(certificates, result.mean("max_live").largest());
  }
  lab::PaperClaim update = log_claim(
      report, "rigid.update", "A change takes O(log min(n, sqrt(D / s))) time.", "signs an event", signs,
      "mu");
  update.observed += fmt::format("; at most {:.2f} (1 + log2 mu) signs an event", most);
  update.assumptions = {"time: signs asked for",
                        "s is at least the least separation of the motion"};
  set_small_run(update, results, "separation_mixed", "polygon-spin-orbit");
  report.claims.push_back(std::move(update));

  lab::PaperClaim compact;
  compact.id = "rigid.compact";
  compact.kind = "bound";
  compact.statement = "The structure is compact and local: one certificate, a single tile.";
  compact.expected = "at most 6 polynomials while the bodies are apart";
  compact.tolerance = "none";
  compact.observed = signs.empty() ? "no run" : fmt::format("at most {:.0f}", certificates);
  compact.verdict = signs.empty()       ? lab::Verdict::kOpen
                    : certificates <= 6 ? lab::Verdict::kConfirmed
                                        : lab::Verdict::kRefuted;
  set_small_run(compact, results, "separation_mixed", "polygon-spin-orbit");
  report.claims.push_back(std::move(compact));
  report.figures = {curves_figure(
      "mu rounds in a turn: events against mu",
      "Separation 2 / mu^2. The legend has the power that fits, with its 95 % interval.",
      {"mu = sqrt(D / separation)", "", true, true, {2}},
      {{"separation_mixed", mixed, ""},
       {"separation_hysteresis",
        points_of(results, "separation_hysteresis", "polygon-spin-orbit", mu_of), ""}})};
  report.figure_names = {"rigid"};
  finish(report, results, command);
  return report;
}

std::vector<lab::SeriesPoint> separation_features_points(bool quick) {
  const Rational near = nearest_turn();
  std::vector<lab::SeriesPoint> points;
  for (const char* workload : {"polygon-fan", "polygon-tangents"}) {
    for (const char* method : {"closest_features", "inner_tangents", "separation_mixed"}) {
      for (const int n : {8, 16, 32, 64, 128, 256}) {
        if (quick && n > 32) continue;
        for (const Rational& separation : {near, far_turns()[0], far_turns()[1]}) {
          // The tangent fan has no room so near to the polygon.
          if (separation == near && std::string_view(workload) == "polygon-tangents") continue;
          points.push_back(separation_point(method, workload, n, separation));
          points.back().cost = 1e-5 * n * n;
        }
      }
    }
  }
  return points;
}

lab::PartReport separation_features_report(const std::vector<lab::SeriesResult>& results,
                                      const std::string& command) {
  lab::PartReport report;
  std::vector<lab::Curve> curves;
  const auto size = [](const lab::SeriesResult& result) { return 1.0 * result.point.key.parameters.n; };
  for (const bool tangents : {false, true}) {
    const std::string workload = tangents ? "polygon-tangents" : "polygon-fan";
    const std::string method = tangents ? "inner_tangents" : "closest_features";
    lab::PaperClaim claim;
    claim.id = tangents ? "features.tangents" : "features.closest";
    claim.kind = "expectation";
    claim.statement = tangents ? "Inner common tangents can change Omega(n^2) times."
                               : "The closest pair of features can change Omega(n^2) times, no "
                                 "matter what the separation is.";
    claim.expected = tangents ? "n (2n + 2) events in a turn, at separation 2 and 29"
                              : "n (3n + 2) events in a turn, at separation 1/10, 2 and 29";
    claim.tolerance = "none";
    claim.assumptions = {"the scene: a regular polygon turns before a fan of n edges"};
    int right = 0, runs = 0;
    for (const lab::SeriesResult& result : results) {
      const lab::RunKey& key = result.point.key;
      if (key.structure != method || key.workload != workload) continue;
      const double expected = key.parameters.n * (tangents ? 2.0 * key.parameters.n + 2 : 3.0 * key.parameters.n + 2);
      ++runs;
      right += events(result) == expected ? 1 : 0;
    }
    claim.observed = fmt::format("right in {} of {}", right, runs);
    claim.verdict = runs == 0       ? lab::Verdict::kOpen
                    : right == runs ? lab::Verdict::kConfirmed
                                    : lab::Verdict::kRefuted;
    set_small_run(claim, results, method, workload);
    report.claims.push_back(std::move(claim));
  }
  report.claims.push_back(far_claim(results));

  std::vector<lab::SeriesResult> middle;
  for (const lab::SeriesResult& result : results) {
    if (result.point.key.parameters.separation == Rational(2)) middle.push_back(result);
  }
  for (const char* method : {"separation_mixed", "closest_features", "inner_tangents"}) {
    curves.push_back(
        {std::string(method) + ", fan", points_of(middle, method, "polygon-fan", size), ""});
    curves.push_back({std::string(method) + ", tangent fan",
                      points_of(middle, method, "polygon-tangents", size), ""});
  }
  report.figures = {curves_figure(
      "A turn before a fan: events against n",
      "Separation 2, that is as much as the diameter. Curves that run along each other are "
      "drawn one inside the other. The legend has the power that fits, with its "
      "95 % interval.",
      {"n vertices", "", true, true, {1, 2}}, std::move(curves))};
  report.figure_names = {"features"};
  finish(report, results, command);
  return report;
}

}  // namespace kinex::families
