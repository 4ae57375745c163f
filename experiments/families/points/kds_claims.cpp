// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/points/kds_claims.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "experiments/lab/claim_check.h"
#include "experiments/lab/power_verdict.h"

namespace kinex::families {

namespace {

constexpr double kTolerance = 0.05;

lab::SeriesPoint point_of(KdsRuns runs, int n, int m, int dimension, int seeds) {
  lab::SeriesPoint point;
  point.key.structure = runs.structure;
  point.key.workload = runs.workload;
  point.key.parameters.n = n;
  point.key.parameters.m = m;
  point.key.parameters.dimension = dimension;
  point.precise = "processed";
  point.min_seeds = point.max_seeds = seeds;
  return point;
}

// m of a run: that of the scene if none was asked for.
double m_of(const lab::RunKey& key) {
  return key.parameters.m == 0 ? key.parameters.n : key.parameters.m;
}

lab::FitPoint fit_point(const lab::RunKey& key, const lab::RunningMean& mean) {
  return {static_cast<double>(key.parameters.n), mean.mean(), mean.standard_error()};
}

// The verdict on "the exponent or more", by the same intervals as judge_power's.
void judge_at_least(lab::PowerVerdict& power, double exponent) {
  if (!power.fit) return;
  const double least = exponent - kTolerance;
  const bool by_term = power.corrected && lab::is_improbable(*power.fit);
  const lab::Fit& fit = by_term ? *power.corrected : *power.fit;
  const bool is_fitted = !lab::is_improbable(fit) && fit.degrees > 1;
  const bool is_below = fit.upper < least && (!power.corrected || power.corrected->upper < least);
  power.verdict = is_below                         ? lab::Verdict::kRefuted
                  : is_fitted && fit.lower >= least ? lab::Verdict::kConfirmed
                                                    : lab::Verdict::kOpen;
}

void keep_small_run(lab::PaperClaim& claim, KdsRuns runs) {
  claim.small_run.structure = runs.structure;
  claim.small_run.workload = runs.workload;
}

}  // namespace

lab::SeriesPoint kds_single(KdsRuns runs, int n, int m, int dimension) {
  return point_of(runs, n, m, dimension, 1);
}

lab::SeriesPoint kds_random(KdsRuns runs, int n, int seeds, int dimension) {
  return point_of(runs, n, 0, dimension, seeds);
}

std::vector<const lab::SeriesResult*> results_of(const std::vector<lab::SeriesResult>& results,
                                                 KdsRuns runs, int dimension) {
  std::vector<const lab::SeriesResult*> chosen;
  for (const lab::SeriesResult& result : results) {
    const lab::RunKey& key = result.point.key;
    if (key.structure == runs.structure && key.workload == runs.workload &&
        key.parameters.dimension == dimension) {
      chosen.push_back(&result);
    }
  }
  return chosen;
}

std::vector<lab::FitPoint> means_of(const std::vector<lab::SeriesResult>& results, KdsRuns runs,
                                    const std::string& quantity, int dimension) {
  std::vector<lab::FitPoint> points;
  for (const lab::SeriesResult* result : results_of(results, runs, dimension)) {
    points.push_back(fit_point(result->point.key, result->mean(quantity)));
  }
  return points;
}

std::vector<lab::FitPoint> ratios_of(const std::vector<lab::SeriesResult>& results, KdsRuns runs,
                                     const std::string& over, const std::string& under,
                                     int dimension) {
  std::vector<lab::FitPoint> points;
  for (const lab::SeriesResult* result : results_of(results, runs, dimension)) {
    lab::RunningMean mean;
    for (const lab::RunRecord& run : result->runs) {
      const double below = lab::quantity_of(run, under);
      if (below > 0) mean.add(lab::quantity_of(run, over) / below);
    }
    if (mean.count() > 0) points.push_back(fit_point(result->point.key, mean));
  }
  return points;
}

std::vector<lab::FitPoint> ratios_of(const std::vector<lab::SeriesResult>& results, KdsRuns over,
                                     KdsRuns under, const std::string& quantity) {
  std::vector<lab::FitPoint> points;
  for (const lab::SeriesResult* above : results_of(results, over)) {
    for (const lab::SeriesResult* below : results_of(results, under)) {
      if (above->point.key.parameters.n != below->point.key.parameters.n) continue;
      lab::RunningMean mean;
      for (std::size_t i = 0; i < std::min(above->runs.size(), below->runs.size()); ++i) {
        const double divisor = lab::quantity_of(below->runs[i], quantity);
        if (divisor > 0) mean.add(lab::quantity_of(above->runs[i], quantity) / divisor);
      }
      if (mean.count() > 0) points.push_back(fit_point(above->point.key, mean));
    }
  }
  return points;
}

lab::PaperClaim count_claim(const std::vector<lab::SeriesResult>& results, const KdsCount& count) {
  lab::PaperClaim claim;
  claim.id = count.id;
  claim.kind = "finding";
  claim.statement = count.statement;
  claim.expected = fmt::format("{}: {} in every run on {}", count.counted, count.formula,
                               count.runs.workload);
  claim.tolerance = "none";
  keep_small_run(claim, count.runs);
  std::size_t runs = 0;
  std::string sizes;
  for (const lab::SeriesResult& result : results) {
    const lab::RunKey& key = result.point.key;
    if (key.structure != count.runs.structure || key.workload != count.runs.workload) continue;
    const double expected = count.integer(key.parameters.n, m_of(key));
    for (const lab::RunRecord& run : result.runs) {
      ++runs;
      const double observed = lab::quantity_of(run, count.quantity);
      if (observed == expected) continue;
      claim.verdict = lab::Verdict::kRefuted;
      claim.observed += fmt::format("{}{:.0f}, not {:.0f}, in {}",
                                    claim.observed.empty() ? "" : "; ", observed, expected, run.key);
    }
    sizes += fmt::format("{}{}: {:.0f}", sizes.empty() ? "" : ", ", key.parameters.n, expected);
  }
  if (runs == 0) {
    claim.observed = "no run";
    return claim;
  }
  if (claim.verdict == lab::Verdict::kRefuted) return claim;
  claim.verdict = lab::Verdict::kConfirmed;
  claim.observed = fmt::format("exactly so in all {} runs; n = {}", runs, sizes);
  return claim;
}

lab::PaperClaim bound_claim(const std::vector<lab::SeriesResult>& results, const KdsCount& count) {
  lab::PaperClaim claim;
  claim.id = count.id;
  claim.kind = "bound";
  claim.statement = count.statement;
  claim.expected = fmt::format("{}: at most {}, in every run on {}", count.counted, count.formula,
                               count.runs.workload);
  claim.tolerance = "none";
  claim.assumptions = {"runs cannot confirm a bound on all motions"};
  keep_small_run(claim, count.runs);
  double nearest = 0;  // to the bound, as a part of it
  std::size_t runs = 0;
  for (const lab::SeriesResult* result : results_of(results, count.runs)) {
    const lab::RunKey& key = result->point.key;
    for (const lab::RunRecord& run : result->runs) {
      ++runs;
      nearest = std::max(nearest, lab::quantity_of(run, count.quantity) /
                                      count.integer(key.parameters.n, m_of(key)));
    }
  }
  if (nearest > 1) claim.verdict = lab::Verdict::kRefuted;
  claim.observed = fmt::format("{:.1f} % of it at most, in {} runs{}", 100 * nearest, runs,
                               nearest > 1 ? "" : "; consistent with the bound");
  return claim;
}

std::vector<double> other_orders(double order) {
  static constexpr double kOrders[] = {1.0 / 3, 1.0 / 2, 2.0 / 3, 1};
  std::vector<double> others;
  std::copy_if(std::begin(kOrders), std::end(kOrders), std::back_inserter(others),
               [order](double one) { return one != order; });
  return others;
}

lab::PaperClaim growth_claim(const std::vector<lab::FitPoint>& points, const KdsGrowth& growth) {
  lab::PaperClaim claim;
  claim.id = growth.id;
  claim.kind = "growth";
  claim.statement = growth.statement;
  const bool at_least = growth.kind == KdsPower::kAtLeast;
  const bool is_bound = growth.kind != KdsPower::kTheta && !at_least;
  claim.expected = fmt::format(
      "{} grow like n^{}{:.4g}", growth.counted,
      at_least ? "b, b at least " : (is_bound ? "b, b at most " : ""), growth.exponent);
  claim.tolerance = fmt::format("{}, for all of the 95 % interval", kTolerance);
  keep_small_run(claim, growth.runs);
  const std::vector<double> others = other_orders(growth.lower_order);
  lab::PowerVerdict power =
      lab::judge_power(points,
                       {growth.exponent, kTolerance, is_bound, growth.lower_order,
                        growth.kind == KdsPower::kTheta ? std::span<const double>(others)
                                                        : std::span<const double>()},
                       "n");
  if (at_least) judge_at_least(power, growth.exponent);
  claim.verdict = power.verdict;
  claim.observed = power.observed;
  if (power.fit) {
    claim.observed += fmt::format("; factor {:.3g}, n from {:.0f} to {:.0f}", power.fit->a,
                                  points.front().n, points.back().n);
  }
  if (growth.kind != KdsPower::kOnAllMotion) return claim;
  claim.assumptions = {"runs cannot confirm a bound on all motions"};
  if (claim.verdict != lab::Verdict::kConfirmed) return claim;
  claim.verdict = lab::Verdict::kOpen;
  claim.observed += "; consistent with the bound";
  return claim;
}

lab::PaperClaim open_question(std::string id, std::string question, std::string observed,
                              KdsRuns runs) {
  lab::PaperClaim claim;
  claim.id = std::move(id);
  claim.kind = "question";
  claim.statement = std::move(question);
  claim.expected = "the report leaves it open";
  claim.tolerance = "none";
  claim.observed = std::move(observed);
  keep_small_run(claim, runs);
  return claim;
}

KdsAgreement agreement_of(const std::vector<lab::SeriesResult>& results,
                          const std::vector<std::string_view>& structures) {
  std::map<std::string, std::map<std::string, double>> changes;  // by scene, by structure
  for (const lab::SeriesResult& result : results) {
    const lab::RunKey& key = result.point.key;
    if (std::find(structures.begin(), structures.end(), key.structure) == structures.end()) continue;
    for (const lab::RunRecord& run : result.runs) {
      // All but the structure, with which the key begins.
      changes[run.key.substr(key.structure.size() + 1)][key.structure] =
          lab::quantity_of(run, "external");
    }
  }
  KdsAgreement agreement;
  for (const auto& [scene, by_structure] : changes) {
    if (by_structure.size() < 2) continue;
    ++agreement.scenes;
    const auto& [first, count] = *by_structure.begin();
    for (const auto& [other, others] : by_structure) {
      if (others == count || !agreement.difference.empty()) continue;
      agreement.difference = fmt::format("{}: {:.0f} of {}, {:.0f} of {}", scene, count, first,
                                         others, other);
    }
  }
  return agreement;
}

lab::PaperClaim agreement_claim(const std::vector<lab::SeriesResult>& results, std::string id,
                                std::string statement, KdsRuns small,
                                const std::vector<std::string_view>& structures) {
  const KdsAgreement agreement = agreement_of(results, structures);
  lab::PaperClaim claim;
  claim.id = std::move(id);
  claim.kind = "finding";
  claim.statement = std::move(statement);
  claim.expected = "as many changes by each, on every scene";
  claim.tolerance = "none";
  claim.assumptions = {std::string(kAgreementAssumption)};
  keep_small_run(claim, small);
  claim.verdict = !agreement.difference.empty() ? lab::Verdict::kRefuted
                  : agreement.scenes > 0        ? lab::Verdict::kConfirmed
                                                : lab::Verdict::kOpen;
  claim.observed = agreement.difference.empty()
                       ? fmt::format("as many on all {} scenes that several have", agreement.scenes)
                       : agreement.difference;
  return claim;
}

lab::Figure growth_figure(std::string title, std::string caption, std::string y,
                          std::vector<double> slopes, std::vector<lab::Curve> curves) {
  lab::Figure figure;
  figure.title = std::move(title);
  figure.caption = std::move(caption);
  for (lab::Curve& curve : curves) {
    if (const std::optional<lab::Fit> fit = lab::fit_power(curve.points)) {
      curve.value = lab::power_value(*fit, "n");
    }
  }
  lab::CurvesPicture picture{"n", std::move(y), true, true, std::move(slopes)};
  lab::set_curves(figure, picture, curves);
  return figure;
}

std::string runs_table(const std::vector<lab::SeriesResult>& results) {
  std::string text =
      "| structure | scenes | n | runs | failures | standard error | changes of the attribute | "
      "standard error | failures per change | certificates | of one object |\n"
      "| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n";
  for (const lab::SeriesResult& result : results) {
    const lab::RunKey& key = result.point.key;
    const lab::RunningMean events = result.mean("processed"), changes = result.mean("external");
    text += fmt::format(
        "| {} | {}{}{} | {} | {} | {:.6g} | {:.2g} | {:.6g} | {:.2g} | {} | {:.0f} | {:.0f} |\n",
        key.structure, key.workload,
        key.parameters.dimension == 2 ? "" : fmt::format(", {} axes", key.parameters.dimension),
        key.parameters.m == 0 ? "" : fmt::format(", m = {}", key.parameters.m), key.parameters.n,
        events.count(), events.mean(), events.standard_error(), changes.mean(),
        changes.standard_error(),
        changes.mean() > 0 ? fmt::format("{:.2f}", events.mean() / changes.mean()) : "-",
        result.mean("max_live").largest(), result.mean("max_per_object").largest());
  }
  return text +
         "\nFailures of certificates, those of structures that are read included; certificates, of all "
         "objects and of one: the most that any run had, likewise.\n";
}

void finish_section_7(lab::PartReport& report, const std::vector<lab::SeriesResult>& results,
                      const std::string& command) {
  for (lab::PaperClaim& claim : report.claims) {
    claim.place = "section 7";
    claim.command = command;
    const KdsRuns wanted{claim.small_run.structure, claim.small_run.workload};
    const auto result =
        std::find_if(results.begin(), results.end(), [&](const lab::SeriesResult& one) {
          return one.point.key.structure == wanted.structure &&
                 one.point.key.workload == wanted.workload;
        });
    if (result == results.end()) {
      claim.small_run = {};
      claim.no_small_run = "no run of it was made";
    } else {
      claim.small_run = lab::small_run(result->point.key);
    }
  }
  report.tables += runs_table(results);
}

}  // namespace kinex::families
