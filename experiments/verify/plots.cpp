// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "experiments/lab/curves.h"
#include "experiments/lab/family.h"
#include "experiments/lab/residual_figure.h"
#include "experiments/verify/shared_bound.h"

namespace kinex::verify {

namespace {

constexpr std::size_t kFewestSizes = 3;

struct Size {
  lab::FitPoint point;
  double bound;  // on the events that are drawn; 0: none
};
struct Family {
  std::string name, workload;
  int degree;
  std::vector<Size> sizes;  // ascending n

  std::vector<lab::FitPoint> points() const {
    std::vector<lab::FitPoint> all;
    for (const Size& size : sizes) all.push_back(size.point);
    return all;
  }
  // The hard bounds checked in the family's own runs, as a curve over n; empty if a size has none
  // or several: they are then no function of n.
  std::vector<lab::FitPoint> bounds() const {
    std::vector<lab::FitPoint> curve;
    for (const Size& size : sizes) {
      if (!(size.bound > 0)) return {};
      const bool again = !curve.empty() && curve.back().n == size.point.n;
      if (again && curve.back().count != size.bound) return {};
      if (!again) curve.push_back({size.point.n, size.bound, 0});
    }
    return curve;
  }
};

// The smallest hard bound on the events checked in a run of the cell; 0: none.
double least_bound(const lab::CellResult& cell) {
  double least = 0;
  for (const lab::Trial& trial : cell.trials) {
    const std::optional<Integer> bound = lab::bound_on_processed(trial.measurement);
    if (!bound) return 0;
    const double value = bound->to_double();
    least = least == 0 ? value : std::min(least, value);
  }
  return least;
}

// All families of one structure over n, one for each workload, in the order of the cells.
std::vector<Family> families_of(const std::vector<lab::CellResult>& cells,
                                const std::string& structure) {
  std::vector<Family> families;
  for (const lab::CellResult& cell : cells) {
    if (cell.cell.structure != structure || cell.trials.empty()) continue;
    const lab::RunningMean mean = lab::mean_of(cell.trials, "processed");
    if (!cell.cell.axis.is_objects()) continue;  // its family draws it
    if (!(mean.mean() > 0)) continue;            // cannot be drawn on a logarithmic axis
    const int degree = cell.cell.parameters.degree;
    auto found = std::find_if(families.begin(), families.end(), [&](const Family& family) {
      return family.name == cell.cell.family && family.workload == cell.cell.workload &&
             family.degree == degree;
    });
    if (found == families.end()) found = families.insert(found, {cell.cell.family, cell.cell.workload, degree, {}});
    const auto n = static_cast<double>(cell.trials.front().measurement.objects);
    found->sizes.push_back({{n, mean.mean(), mean.standard_error()}, least_bound(cell)});
  }
  std::erase_if(families, [](const Family& family) { return family.sizes.size() < kFewestSizes; });
  for (Family& family : families) {
    std::sort(family.sizes.begin(), family.sizes.end(),
              [](const Size& a, const Size& b) { return a.point.n < b.point.n; });
  }
  return families;
}

// The growth that was fitted to the family, or nullptr.
const lab::GrowthResult* growth_of(const VerifyResult& result, const std::string& structure,
                                   const std::string& family) {
  for (const lab::GrowthResult& growth : result.growths) {
    if (growth.claim.structure == structure && growth.claim.family == family && growth.fit)
      return &growth;
  }
  return nullptr;
}

// The exponents that are claimed of the events that are drawn, ascending.
std::vector<double> claimed_slopes(const VerifyResult& result, const std::string& structure) {
  std::set<double> slopes;
  for (const lab::GrowthResult& growth : result.growths) {
    const lab::GrowthClaim& claim = growth.claim;
    const bool drawn =
        claim.structure == structure && growth.axis.empty() && !growth.points.empty();
    if (drawn && claim.quantity == "processed" && claim.logs == 0 && claim.exponent > 0)
      slopes.insert(claim.exponent);
  }
  return {slopes.begin(), slopes.end()};
}

// A family with its workload, so that a picture tells where its counts come from: "uniform (uniform-square)".
std::string with_workload(const std::string& family, const std::string& workload) {
  return family.find(workload) == family.npos ? fmt::format("{} ({})", family, workload) : family;
}

std::string counts_title(const std::string& structure) { return structure + ": events over n"; }

std::string residuals_title(const lab::GrowthClaim& claim) {
  return claim.structure + ": residuals of the fit, " + claim.family;
}

lab::Figure counts_figure(const VerifyResult& result, const std::string& structure) {
  const std::vector<Family> families = families_of(result.cells, structure);
  lab::Figure figure;
  if (families.empty()) return figure;
  figure.title = counts_title(structure);
  figure.caption =
      "Points: observed events (mean over seeds, bars of two standard errors where they can be "
      "seen). Lines: fitted powers, with their 95 % intervals. Dashed, in the colour of the "
      "family: the "
      "hard bounds that were checked in its runs, which none may exceed; families with the same "
      "bound have one line. Grey: slopes that are claimed.";
  // Several families may differ only in the degree of the motion.
  const auto name_of = [&](const Family& family) {
    const bool alone = std::count_if(families.begin(), families.end(), [&](const Family& other) {
                         return other.name == family.name && other.workload == family.workload;
                       }) == 1;
    const std::string name = with_workload(family.name, family.workload);
    return alone ? name : fmt::format("{}, degree {}", name, family.degree);
  };
  std::vector<lab::Curve> curves;
  std::set<std::string> fitted;  // families whose line is drawn: of several workloads one
  for (std::size_t i = 0; i < families.size(); ++i) {
    const Family& family = families[i];
    lab::Curve curve{name_of(family), family.points(), ""};
    curve.look = i;
    curve.joined = false;
    const lab::GrowthResult* const growth = growth_of(result, structure, family.name);
    if (growth != nullptr && fitted.insert(family.name).second) {
      curve.line = growth->fit;
      curve.line_from = growth->points.front().n;
      curve.value = lab::power_value(*growth->fit, "n");
    }
    curves.push_back(std::move(curve));
  }
  std::vector<std::vector<lab::FitPoint>> bounds;
  for (const Family& family : families) bounds.push_back(family.bounds());
  for (const SharedBound& bound : shared_bounds(bounds)) {
    std::string names;
    for (const std::size_t i : bound.families)
      names += (names.empty() ? "" : " and ") + name_of(families[i]);
    const bool all = bound.families.size() == families.size() && families.size() > 1;
    curves.push_back({"hard bound, " + (all ? "all families" : names), bound.points, ""});
    curves.back().is_bound = true;
    curves.back().look = bound.families.front();
  }
  lab::CurvesPicture picture{"objects n", "events", true, true, claimed_slopes(result, structure)};
  picture.title = figure.title;
  lab::set_curves(figure, picture, curves);
  return figure;
}

// The references of the family's cells.
std::vector<lab::FitPoint> references_of(const VerifyResult& result,
                                         const lab::GrowthResult& growth) {
  std::vector<lab::FitPoint> references;
  for (const lab::CellResult& cell : result.cells) {
    if (cell.cell.structure != growth.claim.structure || cell.cell.family != growth.claim.family ||
        cell.trials.empty() || !growth.axis.empty()) {
      continue;
    }
    const auto n = static_cast<double>(cell.trials.front().measurement.objects);
    if (n < growth.claim.smallest) continue;
    for (const lab::Expectation& expectation : cell.cell.expectations) {
      if (expectation.kind != lab::ExpectationKind::kMean ||
          expectation.quantity != growth.claim.quantity) {
        continue;
      }
      references.push_back({n, expectation.reference, expectation.reference_error});
    }
  }
  return references;
}

lab::Figure residual_figure(const VerifyResult& result, const lab::GrowthResult& growth) {
  lab::Figure figure;
  figure.title = residuals_title(growth.claim);
  figure.caption = fmt::format(
      "Expected {}, fitted {}: {}. {} A trend in the residuals is a departure from a pure power.",
      growth.check.expected, growth.check.observed, lab::check_word(growth.check.verdict),
      growth.fit->weighted
          ? fmt::format("chi^2 = {:.1f} on {} degrees of freedom. Bars: two standard errors.",
                        growth.fit->chi_square, growth.fit->degrees)
          : "The counts have no standard errors: the interval is that of their scatter.");
  const auto cell = std::find_if(result.cells.begin(), result.cells.end(), [&](const lab::CellResult& one) {
    return one.cell.structure == growth.claim.structure && one.cell.family == growth.claim.family;
  });
  const std::string workload = cell == result.cells.end() ? growth.claim.family : cell->cell.workload;
  lab::set_residuals(figure, *growth.fit, growth.points, references_of(result, growth),
                     {growth.claim.structure, with_workload(growth.claim.family, workload),
                      growth.axis.empty() ? "objects n" : growth.axis});
  return figure;
}

}  // namespace

std::vector<lab::Figure> verify_figures(const VerifyResult& result) {
  std::vector<std::string> structures;
  for (const lab::CellResult& cell : result.cells) {
    if (std::find(structures.begin(), structures.end(), cell.cell.structure) == structures.end()) {
      structures.push_back(cell.cell.structure);
    }
  }
  std::vector<lab::Figure> figures = lab::family_figures(result.cells);
  for (const std::string& structure : structures) {
    lab::Figure figure = counts_figure(result, structure);
    if (!figure.script.empty()) figures.push_back(std::move(figure));
    for (const lab::GrowthResult& growth : result.growths) {
      if (growth.claim.structure == structure && growth.fit && !lab::is_exact(*growth.fit)) {
        figures.push_back(residual_figure(result, growth));
      }
    }
  }
  return figures;
}

std::vector<std::string> possible_titles(const lab::Catalogue& catalogue) {
  std::vector<std::string> titles = lab::family_figure_titles(catalogue.cells);
  for (const lab::Cell& cell : catalogue.cells) titles.push_back(counts_title(cell.structure));
  for (const lab::GrowthClaim& claim : catalogue.growths) titles.push_back(residuals_title(claim));
  std::sort(titles.begin(), titles.end());
  titles.erase(std::unique(titles.begin(), titles.end()), titles.end());
  return titles;
}

}  // namespace kinex::verify
