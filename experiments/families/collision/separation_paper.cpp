// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/collision/separation_paper.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "experiments/families/collision/axes.h"
#include "experiments/families/collision/experiments.h"
#include "experiments/lab/claim_check.h"
#include "experiments/lab/law_verdict.h"
#include "experiments/lab/power_verdict.h"

namespace kinex::families {

namespace {

constexpr double kTolerance = 0.1;

// Neither many motions nor many polygons are all of them.
void leave_open(lab::PaperClaim& bound, const char* all) {
  bound.assumptions.push_back(all);
  if (bound.verdict != lab::Verdict::kConfirmed) return;
  bound.verdict = lab::Verdict::kOpen;
  bound.observed += "; consistent with the bound";
}

}  // namespace

lab::SeriesPoint separation_point(std::string structure, std::string workload, int n,
                                  std::optional<Rational> separation, int scenes) {
  lab::SeriesPoint point;
  point.key.structure = std::move(structure);
  point.key.workload = std::move(workload);
  point.key.parameters.n = n;
  point.key.parameters.separation = std::move(separation);
  point.precise = "processed";
  point.min_seeds = point.max_seeds = scenes;
  return point;
}

Rational inverse_power(int k) {
  return Rational(Integer(1), Integer::power_of_two(static_cast<unsigned long>(k)));
}

double mu_of(const lab::SeriesResult& result) {
  return known_mu(result.point.key.workload, result.point.key.parameters).value();
}

double nearness_of(const lab::SeriesResult& result) {
  return 4 / known_separation(result.point.key.workload, result.point.key.parameters).value();
}

std::vector<lab::FitPoint> points_of(const std::vector<lab::SeriesResult>& results,
                                const std::string& structure, const std::string& workload,
                                const std::function<double(const lab::SeriesResult&)>& x) {
  std::vector<lab::FitPoint> points;
  for (const lab::SeriesResult& result : results) {
    if (result.point.key.structure != structure || result.point.key.workload != workload) continue;
    const lab::RunningMean mean = result.mean("processed");
    points.push_back({x(result), mean.mean(), mean.standard_error()});
  }
  return points;
}

lab::PaperClaim power_claim(std::string id, std::string statement, const std::vector<lab::FitPoint>& points,
                       const std::string& name, double exponent) {
  lab::PaperClaim claim;
  claim.id = std::move(id);
  claim.statement = std::move(statement);
  claim.kind = "growth";
  claim.expected = fmt::format("events grow like ({})^b with b at most {}", name, exponent);
  claim.tolerance = fmt::format("{}, for all of the 95 % interval", kTolerance);
  const lab::PowerVerdict power =
      lab::judge_power(points, {exponent, kTolerance, true}, "(" + name + ")");
  claim.observed = power.observed;
  claim.verdict = power.verdict;
  if (power.fit) {
    claim.observed += fmt::format(", factor {:.3g}, {} from {:.3g} to {:.3g}", power.fit->a, name,
                                  points.front().n, points.back().n);
  }
  return claim;
}

lab::PaperClaim log_claim(lab::PartReport& report, std::string id, std::string statement,
                          const std::string& counts, const std::vector<lab::FitPoint>& points,
                          const std::string& name) {
  lab::PaperClaim claim;
  claim.id = std::move(id);
  claim.statement = std::move(statement);
  claim.kind = "growth";
  const std::string x = name.find(' ') == name.npos ? name : "(" + name + ")";
  const lab::LawVerdict law =
      lab::judge_law(points, {{0, 1}, kTolerance, true}, x);
  claim.expected = counts + " grow like " + law.expected;
  claim.tolerance = fmt::format("a bend of {:.0f} %, for all of the 95 % interval", 100 * kTolerance);
  claim.observed = law.observed;
  claim.verdict = law.verdict;
  if (!law.neighbours) return claim;
  claim.observed += "; " + lab::neighbours_text(*law.neighbours);
  report.tables += lab::markdown(lab::neighbours_table({{counts, points.size(), *law.neighbours}}));
  return claim;
}

lab::Figure curves_figure(std::string title, std::string caption, lab::CurvesPicture picture,
                          std::vector<lab::Curve> curves) {
  lab::Figure figure;
  figure.title = std::move(title);
  figure.caption = std::move(caption);
  picture.y = "events";
  for (lab::Curve& curve : curves) {
    if (!curve.value.empty() || curve.is_bound) continue;
    if (const std::optional<lab::Fit> fit = lab::fit_power(curve.points)) {
      curve.value = lab::power_value(*fit, picture.x.substr(0, picture.x.find(' ')));
    }
  }
  lab::set_curves(figure, picture, curves);
  return figure;
}

void set_small_run(lab::PaperClaim& claim, const std::vector<lab::SeriesResult>& results,
                   const std::string& structure, const std::string& workload) {
  for (const lab::SeriesResult& result : results) {
    const lab::RunKey& key = result.point.key;
    if (key.structure != structure || key.workload != workload) continue;
    claim.small_run = lab::small_run(key);
    return;
  }
  claim.no_small_run = "no run of it was made";
}

void finish(lab::PartReport& report, const std::vector<lab::SeriesResult>& results,
            const std::string& command, const char* all) {
  if (!results.empty()) {
    report.tables +=
        "| structure | workload | n | separation | turns | runs | certificate failures | standard "
        "error | certificates | signs a failure |\n"
        "| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n";
  }
  for (const lab::SeriesResult& result : results) {
    const lab::RunKey& key = result.point.key;
    const lab::RunningMean events = result.mean("processed");
    const double signs = result.mean("signs").mean();
    report.tables +=
        fmt::format("| {} | {}{} | {} | {} | {} | {} | {:.6g} | {:.2g} | {:.0f} | {} |\n",
                    key.structure, key.workload, key.parameters.m == 0 ? "" : fmt::format(" m={}", key.parameters.m),
                    key.parameters.n,
                    key.parameters.separation ? key.parameters.separation->to_string() : "-",
                    key.parameters.turns == -1 ? "-" : std::to_string(key.parameters.turns), events.count(),
                    events.mean(), events.standard_error(), result.mean("max_live").largest(),
                    events.mean() > 0 ? fmt::format("{:.1f}", signs / events.mean()) : "-");
  }
  for (lab::PaperClaim& claim : report.claims) {
    if (claim.kind == "growth" || claim.kind == "bound") leave_open(claim, all);
    claim.place = "introduction";
    claim.command = command;
  }
}

lab::Paper separation_paper() {
  return {
      "separation-sensitive-1999",
      "J. Erickson, L. J. Guibas, J. Stolfi, L. Zhang, Separation-sensitive collision detection "
      "for convex objects, 1999",
      {{"translation", "how many certificates two polygons need that do not turn", 1,
        separation_translation_points, separation_translation_report},
       {"rigid", "how many, and at what cost, when they turn", 2, separation_rigid_points,
        separation_rigid_report},
       {"features", "what closest features and tangents cost at any distance", 3,
        separation_features_points, separation_features_report},
       {"hysteresis", "certificates that last", 4, separation_hysteresis_points,
        separation_hysteresis_report},
       {"hierarchies", "outer hierarchies of one polygon", 5, separation_hierarchies_points,
        nullptr, study_outer_hierarchies, separation_hierarchies_report}}};
}

}  // namespace kinex::families
