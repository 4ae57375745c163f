// SPDX-License-Identifier: GPL-3.0-or-later
// Question: what do three structures for a convex hull cost, as the sum over the polynomial
//   equations that they solve, weighted by degree? (Guibas 1998, section 11, figure 3.)
// Motion: linear, from a random origin to a random destination, which is reached at t = 1; the run
//   continues until no event is left. Workloads: uniform square, uniform disk, Gaussian.
// Parameters: n and seeds below. Weights: the report gives none. Used: d^2, and measured ones.
// Expected: the kinetic structure is cheaper than brute force from some n < 100 on, and always
//   cheaper than the Delaunay triangulation.
// Cost: about 5 minutes; --quick: seconds.
#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "experiments/families/hull/experiments.h"
#include "experiments/families/hull/polynomial_weights.h"
#include "experiments/lab/claim_check.h"
#include "experiments/lab/curves.h"

namespace kinex::families {

namespace {

struct Method {
  const char* structure;
  const char* title;
};
constexpr Method kMethods[] = {{"convex_hull_2", "kinetic hull (section 6)"},
                               {"convex_hull_2_brute_force", "brute force"},
                               {"convex_hull_2_delaunay", "Delaunay triangulation"}};
constexpr const char* kWorkloads[] = {"uniform-square", "uniform-disk", "gaussian"};
constexpr double kClaimedCrossing = 100;

struct Costs {
  double kinetic = 0, brute = 0, delaunay = 0;
};
// costs[workload][n]
using CostTable = std::map<std::string, std::map<int, Costs>>;

CostTable cost_table(const std::vector<lab::SeriesResult>& results, const PolynomialWeights& weights) {
  CostTable table;
  for (const lab::SeriesResult& result : results) {
    lab::RunningMean mean;
    for (const lab::RunRecord& run : result.runs) mean.add(cost_of(run, weights));
    const lab::RunKey& key = result.point.key;
    Costs& costs = table[key.workload][key.parameters.n];
    (key.structure == kMethods[0].structure   ? costs.kinetic
     : key.structure == kMethods[1].structure ? costs.brute
                                              : costs.delaunay) = mean.mean();
  }
  return table;
}

// The n beyond which the kinetic structure is cheaper than brute force, interpolated between two
// sizes on logarithms. 0: at all sizes; nullopt: not at the largest.
std::optional<double> crossing(const std::map<int, Costs>& costs) {
  std::optional<double> from;
  const std::pair<const int, Costs>* before = nullptr;
  for (const auto& entry : costs) {
    const bool cheaper = entry.second.kinetic < entry.second.brute;
    if (cheaper && !from) {
      if (before == nullptr) {
        from = 0;
      } else {
        const double a = std::log(before->second.kinetic / before->second.brute);
        const double b = std::log(entry.second.kinetic / entry.second.brute);
        const double share = a / (a - b);
        from = std::exp(std::log(before->first) +
                        share * std::log(static_cast<double>(entry.first) / before->first));
      }
    }
    if (!cheaper) from.reset();
    before = &entry;
  }
  return from;
}

std::string crossing_text(const std::optional<double>& n, const std::map<int, Costs>& costs) {
  if (!n) return fmt::format("not up to n = {}", costs.rbegin()->first);
  if (*n == 0) return fmt::format("from n = {} on", costs.begin()->first);
  return fmt::format("from n = {:.0f} on", *n);
}

lab::PaperClaim claim_on_brute_force(const CostTable& table, const PolynomialWeights& weights) {
  lab::PaperClaim claim;
  claim.id = "figure-3.brute-force." + std::string(weights.name == "d^2" ? "squares" : "measured");
  claim.kind = "finding";
  claim.statement =
      "The kinetic structure is cheaper than brute force from some n below 100 on "
      "(weights: " +
      weights.name + ").";
  claim.expected = "from n < 100 on, for all three distributions";
  claim.verdict = lab::Verdict::kConfirmed;
  for (const auto& [workload, costs] : table) {
    const std::optional<double> n = crossing(costs);
    if (!n || *n >= kClaimedCrossing) claim.verdict = lab::Verdict::kRefuted;
    claim.observed +=
        (claim.observed.empty() ? "" : "; ") + workload + ": " + crossing_text(n, costs);
  }
  return claim;
}

constexpr double kMuch = 2;  // cheaper, by our reading

lab::PaperClaim claim_on_delaunay(const CostTable& table, const PolynomialWeights& weights) {
  lab::PaperClaim claim;
  claim.id = "figure-3.delaunay." + std::string(weights.name == "d^2" ? "squares" : "measured");
  claim.kind = "finding";
  claim.statement =
      "The kinetic structure is always much cheaper than the triangulation (weights: " +
      weights.name + ").";
  claim.expected = fmt::format("at least {} times cheaper for every n and distribution", kMuch);
  claim.verdict = lab::Verdict::kConfirmed;
  for (const auto& [workload, costs] : table) {
    double least = 0, at_least = 0;
    for (const auto& [n, cost] : costs) {
      const double ratio = cost.delaunay / cost.kinetic;
      if (least == 0 || ratio < least) least = ratio, at_least = n;
    }
    if (least < kMuch) claim.verdict = lab::Verdict::kRefuted;
    const auto& [largest, cost] = *costs.rbegin();
    claim.observed += fmt::format("{}{}: {:.2f} times at least (n = {:.0f}), {:.2f} at n = {}",
                                  claim.observed.empty() ? "" : "; ", workload, least, at_least,
                                  cost.delaunay / cost.kinetic, largest);
  }
  return claim;
}

// On every scene, that is, for equal workloads, sizes and seeds.
lab::PaperClaim claim_on_changes(const std::vector<lab::SeriesResult>& results, const std::string& command) {
  lab::PaperClaim claim;
  claim.id = "figure-3.same-changes";
  claim.place = "section 11";
  claim.kind = "finding";
  claim.statement = "The three methods see as many changes of the hull.";
  claim.command = command;
  claim.expected = "as many on every scene";
  claim.tolerance = "none";
  claim.verdict = lab::Verdict::kConfirmed;
  std::map<std::string, std::map<std::string, std::set<std::uint64_t>>> changes;  // scene, method
  for (const lab::SeriesResult& result : results) {
    const lab::RunKey& key = result.point.key;
    for (std::size_t i = 0; i < result.runs.size(); ++i) {
      const std::string scene = fmt::format("{} n={}, scene {}", key.workload, key.parameters.n, i + 1);
      changes[scene][key.structure].insert(result.runs[i].external);
    }
  }
  std::size_t compared = 0;
  for (const auto& [scene, by_method] : changes) {
    std::set<std::uint64_t> counts;
    for (const auto& [method, values] : by_method) counts.insert(values.begin(), values.end());
    if (by_method.size() < 2) continue;
    ++compared;
    if (counts.size() == 1) continue;
    claim.verdict = lab::Verdict::kRefuted;
    claim.observed += fmt::format("{}differ on {}", claim.observed.empty() ? "" : "; ", scene);
  }
  if (claim.observed.empty()) claim.observed = fmt::format("as many on all {} scenes", compared);
  return claim;
}

std::string table_text(const std::vector<lab::SeriesResult>& results,
                       const std::vector<PolynomialWeights>& weights) {
  std::string text =
      "| workload | n | method | seeds | certificate failures | hull changes | degree 1 | degree 2 "
      "| degree 4 |";
  for (const PolynomialWeights& one : weights) text += " cost, " + one.name + " |";
  text += "\n| --- | ---: | --- | ---: | ---: | ---: | ---: | ---: | ---: |";
  for (std::size_t i = 0; i < weights.size(); ++i) text += " ---: |";
  text += "\n";
  for (const lab::SeriesResult& result : results) {
    text += fmt::format("| {} | {} | {} | {} | {:.0f} | {:.1f} | {:.0f} | {:.0f} | {:.0f} |",
                        result.point.key.workload, result.point.key.parameters.n, result.point.key.structure,
                        result.runs.size(), result.mean("processed").mean(),
                        result.mean("external").mean(), result.mean("solved.1").mean(),
                        result.mean("solved.2").mean(), result.mean("solved.4").mean());
    for (const PolynomialWeights& one : weights) {
      lab::RunningMean mean;
      for (const lab::RunRecord& run : result.runs) mean.add(cost_of(run, one));
      text += fmt::format(" {:.4g} |", mean.mean());
    }
    text += "\n";
  }
  return text;
}

lab::Figure figure(const std::string& workload, const std::vector<lab::SeriesResult>& results,
                   const PolynomialWeights& weights) {
  lab::Figure figure;
  figure.title = "Cost of the kinetic convex hull: " + workload;
  figure.caption =
      "Equations solved, weighted by d^2, until no event is left; linear motion from random "
      "origins to random destinations. Means over seeds, with bars of two standard errors; the "
      "power "
      "that fits the larger half of the sizes, with its 95 % interval.";
  std::vector<lab::Curve> curves;
  for (const Method& method : kMethods) {
    lab::Curve curve{method.title, {}, ""};
    for (const lab::SeriesResult& result : results) {
      const lab::RunKey& key = result.point.key;
      if (key.workload != workload || key.structure != method.structure) continue;
      lab::RunningMean mean;
      for (const lab::RunRecord& run : result.runs) mean.add(cost_of(run, weights));
      curve.points.push_back({static_cast<double>(key.parameters.n), mean.mean(), mean.standard_error()});
    }
    const auto half = static_cast<std::ptrdiff_t>(curve.points.size() / 2);
    std::vector<lab::FitPoint> larger(curve.points.begin() + half, curve.points.end());
    // The largest sizes have one seed: unweighted.
    for (lab::FitPoint& point : larger) point.error = 0;
    if (const std::optional<lab::Fit> fit = lab::fit_power(larger)) {
      curve.value = lab::power_value(*fit, "n");
    }
    curves.push_back(std::move(curve));
  }
  lab::CurvesPicture picture{"points n", "cost: equations solved, times d^2", true, true, {1, 2}};
  picture.title = workload;
  lab::set_curves(figure, picture, curves);
  return figure;
}

}  // namespace

std::vector<lab::SeriesPoint> kds_figure_3_points(bool quick) {
  std::vector<lab::SeriesPoint> points;
  for (const char* workload : kWorkloads) {
    for (const int n : {10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000}) {
      if (quick && n > 200) continue;
      for (const Method& method : kMethods) {
        lab::SeriesPoint point;
        point.key.structure = method.structure;
        point.key.workload = workload;
        point.key.parameters.n = n;
        point.key.forever = true;
        point.min_seeds = point.max_seeds = n <= 200 ? 10 : n <= 2000 ? 4 : 1;
        point.cost = point.min_seeds * 3e-6 * n * std::sqrt(n);
        points.push_back(std::move(point));
      }
    }
  }
  return points;
}

lab::PartReport kds_figure_3_report(const std::vector<lab::SeriesResult>& results,
                               const std::string& command) {
  const std::vector<PolynomialWeights> weights{square_weights(), measured_weights("exact"),
                                               measured_weights("sturm")};
  lab::PartReport report;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const CostTable table = cost_table(results, weights[i]);
    if (table.empty()) return report;
    for (lab::PaperClaim claim :
         {claim_on_brute_force(table, weights[i]), claim_on_delaunay(table, weights[i])}) {
      if (i > 0) claim.id += "-" + weights[i].name.substr(std::string("measured in ").size());
      claim.place = "section 11, figure 3";
      claim.command = command;
      claim.tolerance = "none";
      claim.assumptions = {"weights of the degrees: the report gives none",
                           "every failure time that is asked for is an equation that is solved"};
      report.claims.push_back(std::move(claim));
    }
    if (i > 0) continue;
    for (const auto& [workload, costs] : table) {
      report.figures.push_back(figure(workload, results, weights[i]));
      report.figure_names.push_back("figure-3-" + workload);
    }
  }
  report.claims.push_back(claim_on_changes(results, command));
  // One of each method: the claims compare them.
  for (lab::PaperClaim& claim : report.claims) {
    const bool brute = claim.id.find("brute-force") != std::string::npos;
    const bool delaunay = claim.id.find("delaunay") != std::string::npos;
    claim.small_run.structure = kMethods[brute ? 1 : delaunay ? 2 : 0].structure;
    claim.small_run.workload = kWorkloads[0];
    claim.small_run.forever = true;
    claim.small_run = lab::small_run(std::move(claim.small_run));
  }
  report.tables = "Weights by degree 1, 2, 4: ";
  for (std::size_t i = 0; i < weights.size(); ++i) {
    report.tables +=
        fmt::format("{}{} ({:.3g}, {:.3g}, {:.3g})", i == 0 ? "" : "; ", weights[i].name,
                    weights[i].by_degree[1], weights[i].by_degree[2], weights[i].by_degree[4]);
  }
  report.tables += ".\n\n" + table_text(results, weights);
  return report;
}

}  // namespace kinex::families
