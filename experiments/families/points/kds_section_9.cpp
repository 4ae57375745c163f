// SPDX-License-Identifier: GPL-3.0-or-later
// Question: how many events does random motion cause, and by which law do they grow? (Guibas 1998,
//   section 9.)
// Motion: origin and destination independent and uniform in the unit square (the interval for
//   sorting and maxima), t in [0, 1].
// Parameters: n below; seeds until the standard error is 2 % of the mean, which the tables tell.
// References: n(n-1)/4 for each direction that is sorted and the expectation of the maximum's changes
//   are exact; the others are means of an independent simulation in floating point, with its standard
//   errors.
// Expected: hull changes like log^2 n, events of the kinetic hull like n, changes of the maximum
//   like log n, Delaunay events like n^1.5, in space n^(4/3); changes of the closest pair like n^(2/d);
//   events of two structures for it like n^2 and n^1.5; changes of the spanning tree like n^1.5. A law
//   with a logarithm is compared with its neighbours, other powers of the logarithm and a power of n. Of a
//   power the term of lower order is not known: a claim is confirmed only if its order does not decide.
// Left out: the report's structure with n^1.5 events, which it does not describe; octants_local is ours.
// Cost: at most half an hour of CPU time; --quick: minutes.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "experiments/families/points/experiments.h"
#include "experiments/families/points/kds_claims.h"
#include "experiments/families/points/law_figure.h"
#include "experiments/families/points/reference_means.h"
#include "experiments/families/points/uniform_lines.h"
#include "experiments/lab/claim_check.h"
#include "experiments/lab/fit.h"
#include "experiments/lab/growth_words.h"
#include "experiments/lab/neighbours.h"
#include "experiments/lab/power_verdict.h"

namespace kinex::families {

namespace {

enum class Law { kLogSquared, kLinear, kLog, kPower };

struct Family {
  const char* id;
  const char* structure;
  const char* quantity;
  int dimension;
  const char* statement;
  Law law;
  double exponent;         // of kPower
  std::vector<int> sizes;  // the last ones are left out in a quick run
  int largest_quick;
  double seconds_per_run;  // at the largest size
  double growth;           // of that, as a power of n
  const char* references;  // reference_means; empty: there are none, or formulas
  double lower_order = 1;  // of kPower and kLinear: lab::ClaimedPower
  const char* assumption = "";
};

const std::vector<Family>& families() {
  static const std::vector<Family> kFamilies{
      {"9.hull",
       "convex_hull_2",
       "external",
       2,
       "The hull changes Theta(log^2 n) times.",
       Law::kLogSquared,
       0,
       // doubling from 25 on, and what the references have
       {10, 25, 50, 100, 200, 400, 800, 1000, 1600, 3000, 3200, 6400, 10000, 12800, 25600, 51200,
        102400},
       1000,
       2,
       1,
       "hull"},
      {"9.hull-events",
       "convex_hull_2",
       "processed",
       2,
       "The kinetic hull has Theta(n) events.",
       Law::kLinear,
       1,
       {100, 200, 400, 800, 1600, 3200, 6400, 12800, 25600, 51200, 102400},
       3200,
       3,
       1,
       ""},
      {"9.maximum",
       "maximum_tournament",
       "external",
       1,
       "The maximum changes Theta(log n) times (not in the report).",
       Law::kLog,
       0,
       {16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192, 16384, 32768, 65536},
       4096,
       0.1,
       1,
       ""},
      {"9.sorting",
       "sorted_list",
       "processed",
       1,
       "Sorting has Theta(n^2) events, even in expectation.",
       Law::kPower,
       2,
       {16, 32, 64, 128, 256, 512, 1024, 2048, 4096},
       512,
       1.5,
       2,
       ""},
      {"9.delaunay",
       "delaunay_2",
       "processed",
       2,
       "The Delaunay triangulation has Theta(n^(3/2)) events.",
       Law::kPower,
       1.5,
       {10, 50, 100, 200, 400, 800, 1600, 3200, 6400},
       800,
       2,
       1.5,
       "delaunay"},
      {"9.pair",
       "closest_pair_local",
       "external",
       2,
       "The closest pair changes Theta(n) times.",
       Law::kPower,
       1,
       {25, 35, 50, 70, 100, 200, 400, 800, 1600},
       200,
       0.6,
       1.5,
       ""},
      {"9.pair-line",
       "closest_pair_all",
       "external",
       1,
       "On a line the closest pair changes Theta(n^2) times (n^(2/d), preliminary).",
       Law::kPower,
       2,
       {8, 12, 16, 24, 32, 48, 64, 96},
       32,
       1,
       3,
       ""},
      {"9.pair-space",
       "closest_pair_delaunay",
       "external",
       3,
       "In space the closest pair changes Theta(n^(2/3)) times (n^(2/d), preliminary).",
       Law::kPower,
       2.0 / 3,
       {12, 25, 50, 75, 100, 200, 400},
       75,
       1,
       1.4,
       ""},
      {"9.delaunay-space",
       "delaunay_3",
       "processed",
       3,
       "In space the Delaunay triangulation has Theta(n^(4/3)) events (n^(1 + 1/d), preliminary).",
       Law::kPower,
       4.0 / 3,
       {25, 35, 50, 70, 100, 200, 400, 800, 1600},
       200,
       5,
       1.4,
       "",
       1.0 / 3},
      {"9.sorted-pairs",
       "octants_listed",
       "processed",
       2,
       "The closest pair by sorting has Theta(n^2) events, even in expectation.",
       Law::kPower,
       2,
       {16, 32, 64, 128, 256, 512},
       128,
       1.5,
       2,
       "",
       1,
       "counted: swaps in the sorted lists of octants_listed, which closest_pair_cones reads; its "
       "own "
       "failures, of a tournament over pairs, are not counted"},
      {"9.unsorted-pairs",
       "octants_local",
       "processed",
       2,
       "A structure for the closest pair that does not sort has roughly n^(3/2) events.",
       Law::kPower,
       1.5,
       {25, 35, 50, 70, 100, 200, 400, 800, 1600},
       200,
       1,
       1.5,
       "",
       1,
       "the report does not describe its structure. Counted: failures of octants_local, which is "
       "ours and "
       "which closest_pair_local reads; its own, of a tournament over pairs, are not counted"},
      {"9.tree",
       "emst_cycles",
       "external",
       2,
       "The minimum spanning tree changes Theta(n^(3/2)) times (a conjecture from runs: of such "
       "motion the "
       "report knows O(n^(5/2))).",
       Law::kPower,
       1.5,
       {25, 35, 50, 70, 100, 200, 400, 800},
       100,
       3,
       1.7,
       ""}};
  return kFamilies;
}

constexpr const char* kWorkload = "uniform-square";
constexpr double kExponentTolerance = 0.05;
constexpr double kPreciseEnough = 0.05;  // standard error of a mean, relative
std::vector<lab::FitPoint> points_of(const std::vector<lab::SeriesResult>& results, const Family& family) {
  std::vector<lab::FitPoint> points;
  for (const lab::SeriesResult& result : results) {
    if (result.point.key.structure != family.structure || result.point.precise != family.quantity) {
      continue;
    }
    const lab::RunningMean mean = result.mean(family.quantity);
    points.push_back({static_cast<double>(result.point.key.parameters.n), mean.mean(), mean.standard_error()});
  }
  return points;
}

std::vector<lab::Fit> fits_of(const Family& family, const std::vector<lab::FitPoint>& points) {
  std::vector<lab::Fit> fits;
  const auto log = [](double n) { return std::log(n); };
  switch (family.law) {
    case Law::kLogSquared:
      fits.push_back(lab::fit_law("a + b ln^2 n", points, [](double n) {
                       return std::log(n) * std::log(n);
                     }).value());
      break;
    case Law::kLog:
      fits.push_back(lab::fit_law("a + b ln n", points, log).value());
      break;
    case Law::kLinear:
      fits.push_back(lab::fit_law("a + b n", points, [](double n) { return n; }).value());
      break;
    case Law::kPower:
      break;
  }
  fits.push_back(lab::fit_power(points).value());
  return fits;
}

lab::Law law_of(const Family& family) {
  switch (family.law) {
    case Law::kLogSquared:
      return {0, 2};
    case Law::kLog:
      return {0, 1};
    case Law::kLinear:
    case Law::kPower:
      break;
  }
  return {family.exponent, 0};
}

void judge_power(const Family& family, const std::vector<lab::FitPoint>& points,
                 lab::PaperClaim& claim) {
  claim.expected = fmt::format("exponent {:.4g}", family.exponent);
  claim.tolerance = fmt::format("{}, for all of the 95 % interval", kExponentTolerance);
  const std::vector<double> others = other_orders(family.lower_order);
  const lab::PowerVerdict power = lab::judge_power(
      points, {family.exponent, kExponentTolerance, false, family.lower_order, others}, "n");
  claim.observed += "; " + power.observed;
  claim.verdict = power.verdict;
}

// Against all neighbours. Chance must explain what is left, or, for ln^2 n, what a multiple of ln n
// leaves. A law that fits with this term is not refuted by a neighbour.
void judge_logarithm(const Family& family, const std::vector<lab::FitPoint>& points,
                     const std::vector<lab::Fit>& fits, lab::PaperClaim& claim) {
  const lab::Fit& law = fits.front();
  claim.expected = law.law + " fits better than its neighbours";
  claim.tolerance = fmt::format(
      "chi^2 of as many parameters, smaller by {} (times what is left for each degree of "
      "freedom)",
      lab::kDecisive);
  const auto neighbours = lab::neighbours_of(points, law_of(family), "n");
  if (!neighbours) {
    claim.observed += "; too few sizes";
    return;
  }
  claim.verdict = neighbours->beats_all()   ? lab::Verdict::kConfirmed
                  : neighbours->is_beaten() ? lab::Verdict::kRefuted
                                            : lab::Verdict::kOpen;
  claim.observed += "; " + lab::neighbours_text(*neighbours);
  claim.observed += "; at a power the local exponent would stay: " + lab::local_exponents(points);
  const bool is_improbable = lab::is_improbable(law);
  if (!is_improbable && claim.verdict != lab::Verdict::kRefuted) return;
  std::optional<lab::Fit> corrected;
  if (family.law == Law::kLogSquared) {
    corrected = lab::fit_law_with(law.law + " + c ln n", points, law.g,
                                  [](double n) { return std::log(n); });
  }
  if (corrected) claim.observed += "; " + lab::fit_text(*corrected);
  const bool is_explained = corrected && !lab::is_improbable(*corrected);
  if (!(is_explained && corrected->lower > 0) && claim.verdict == lab::Verdict::kConfirmed) {
    claim.verdict = lab::Verdict::kOpen;
  }
  // A neighbour fits better than the law alone, but the law with its term fits, too.
  if (is_explained && corrected->lower > 0 && claim.verdict == lab::Verdict::kRefuted) {
    claim.verdict = lab::Verdict::kOpen;
  }
}

lab::PaperClaim growth_claim(const Family& family, const std::vector<lab::FitPoint>& points,
                             const std::vector<lab::Fit>& fits) {
  lab::PaperClaim claim;
  claim.id = std::string(family.id) + ".growth";
  claim.kind = "growth";
  claim.statement = family.statement;
  for (const lab::Fit& fit : fits) {
    claim.observed += (claim.observed.empty() ? "" : "; ") + lab::fit_text(fit);
  }
  claim.assumptions = {"origin and destination independent and uniform, t in [0, 1]"};
  if (family.assumption[0] != 0) claim.assumptions.emplace_back(family.assumption);
  if (family.law == Law::kPower || family.law == Law::kLinear) {
    judge_power(family, points, claim);
  } else {
    judge_logarithm(family, points, fits, claim);
  }
  return claim;
}

std::vector<ReferenceMean> references_of(const Family& family, const std::vector<lab::FitPoint>& points) {
  std::vector<ReferenceMean> references = reference_means(family.references);
  for (const lab::FitPoint& point : points) {
    const int n = static_cast<int>(point.n);
    if (family.law == Law::kLog) references.push_back({"", n, 0, expected_envelope_changes(n), 0});
    // n(n - 1)/4 for each direction.
    if (std::string(family.structure) == "sorted_list") {
      references.push_back({"", n, 0, n * (n - 1.0) / 4, 0});
    }
    if (std::string(family.structure) == "octants_listed") {
      references.push_back({"", n, 0, n * (n - 1.0), 0});
    }
  }
  return references;
}

// Means against known ones, all sizes together (see allowed_errors).
bool add_constant_claim(const Family& family, const std::vector<lab::FitPoint>& points,
                        std::vector<lab::PaperClaim>& claims) {
  const std::vector<ReferenceMean> references = references_of(family, points);
  lab::PaperClaim claim;
  double farthest = 0;
  int compared = 0;
  bool precise = true;  // a mean of too few runs agrees with any reference
  std::vector<std::string> sources;
  for (const lab::FitPoint& point : points) {
    for (const ReferenceMean& reference : references) {
      if (reference.n != static_cast<int>(point.n)) continue;
      ++compared;
      if (reference.error > 0) sources.push_back(reference.source());
      precise = precise && point.error <= kPreciseEnough * point.count;
      const double apart =
          lab::distance_in_errors(point.count, point.error, reference.mean, reference.error, 0);
      farthest = std::max(farthest, apart);
      claim.expected += fmt::format("{}n = {}: {:.5g}", claim.expected.empty() ? "" : ", ",
                                    reference.n, reference.mean) +
                        (reference.error > 0 ? fmt::format(" +- {:.3g}", reference.error) : "");
      claim.observed += fmt::format("{}{:.5g} +- {:.2g}", claim.observed.empty() ? "" : ", ",
                                    point.count, point.error);
    }
  }
  if (compared == 0) return false;
  const double allowed = lab::allowed_errors(compared);
  claim.id = std::string(family.id) + ".means";
  claim.kind = "expectation";
  claim.statement = "Means of the numbers of events.";
  claim.tolerance = fmt::format("{:.2f} standard errors, for {} means together", allowed, compared);
  claim.observed += fmt::format("; the farthest is {:.2f} standard errors off", farthest);
  claim.verdict = farthest > allowed ? lab::Verdict::kRefuted
                  : precise          ? lab::Verdict::kConfirmed
                                     : lab::Verdict::kOpen;
  claim.assumptions = {std::string(family.references).empty()
                           ? "the expectation is exact"
                           : fmt::format("references: an independent simulation in doubles, {}",
                                         fmt::join(sources, ", "))};
  claims.push_back(std::move(claim));
  return true;
}

}  // namespace

std::vector<lab::SeriesPoint> kds_section_9_points(bool quick) {
  std::vector<lab::SeriesPoint> points;
  for (const Family& family : families()) {
    for (const int n : family.sizes) {
      if (quick && n > family.largest_quick) continue;
      lab::SeriesPoint point;
      point.key.structure = family.structure;
      point.key.workload = kWorkload;
      point.key.parameters.n = n;
      point.key.parameters.dimension = family.dimension;
      point.precise = family.quantity;
      point.relative_error = quick ? 0.04 : 0.02;
      point.cost = 20 * family.seconds_per_run *
                   std::pow(static_cast<double>(n) / family.sizes.back(), family.growth);
      points.push_back(std::move(point));
    }
  }
  return points;
}

lab::PartReport kds_section_9_report(const std::vector<lab::SeriesResult>& results,
                                const std::string& command) {
  lab::PartReport report;
  report.tables =
      "| structure | counted | n | seeds | mean | standard error |\n| --- | --- | ---: | ---: | "
      "---: | ---: |\n";
  for (const lab::SeriesResult& result : results) {
    const lab::RunningMean mean = result.mean(result.point.precise);
    report.tables += fmt::format(
        "| {} | {} | {} | {} | {:.6g} | {:.3g} |\n", result.point.key.structure,
        result.point.precise, result.point.key.parameters.n, mean.count(), mean.mean(), mean.standard_error());
  }
  for (const Family& family : families()) {
    const std::vector<lab::FitPoint> points = points_of(results, family);
    if (points.size() < 4) continue;
    const std::vector<lab::Fit> fits = fits_of(family, points);
    const std::size_t first = report.claims.size();
    report.claims.push_back(growth_claim(family, points, fits));
    add_constant_claim(family, points, report.claims);
    for (std::size_t i = first; i < report.claims.size(); ++i) {
      lab::RunKey run;
      run.structure = family.structure;
      run.workload = kWorkload;
      run.parameters.dimension = family.dimension;
      report.claims[i].small_run = lab::small_run(std::move(run));
    }
    report.figures.push_back(
        law_figure({fmt::format("{}: {} of {}", family.id, family.quantity, family.structure),
                    family.statement,
                    family.quantity == std::string("external") ? "external events of a run"
                                                               : "events of a run",
                    family.law == Law::kPower || family.law == Law::kLinear ? family.exponent : 0},
                   points, fits));
    report.figure_names.push_back("section-" + std::string(family.id));
    std::replace(report.figure_names.back().begin(), report.figure_names.back().end(), '.', '-');
  }
  for (lab::PaperClaim& claim : report.claims) {
    claim.place = "section 9";
    claim.command = command;
  }
  return report;
}

lab::Paper kds_report(std::vector<lab::PaperPart> parts) {
  return {"kds-report-1998",
          "L. J. Guibas, Kinetic data structures: a state of the art report, 1998",
          std::move(parts)};
}

}  // namespace kinex::families
