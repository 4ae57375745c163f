// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "experiments/lab/curves.h"
#include "experiments/lab/family.h"

namespace kinex::verify {

namespace {

constexpr std::size_t kFewestSizes = 3;

struct Point {
  double n, count, error;
  double bound;  // 0: none
};

// "set xrange" a little beyond the points.
std::string x_range(double low, double high) {
  return fmt::format("set xrange [{:.6g}:{:.6g}]\n", low * 0.8, high * 1.25);
}

struct Family {
  std::string name;
  int degree;
  std::vector<Point> points;  // ascending n
};

// The smallest hard bound on the events checked in a run of the cell; 0: none.
double least_bound(const lab::CellResult& cell) {
  double least = 0;
  for (const lab::Trial& trial : cell.trials) {
    const BoundCheck* bound = lab::event_bound(trial.measurement);
    if (bound == nullptr) return 0;
    const double value = bound->bound.to_double();
    least = least == 0 ? value : std::min(least, value);
  }
  return least;
}

// All families of one structure, in the order of the cells.
std::vector<Family> families_of(const std::vector<lab::CellResult>& cells,
                                const std::string& structure) {
  std::vector<Family> families;
  for (const lab::CellResult& cell : cells) {
    if (cell.cell.structure != structure || cell.trials.empty()) continue;
    const lab::RunningMean mean = lab::mean_of(cell.trials, "processed");
    if (cell.cell.variable != lab::Variable::kObjects) continue;  // its family draws it
    if (!(mean.mean() > 0)) continue;  // cannot be drawn on a logarithmic axis
    const lab::Measurement& run = cell.trials.front().measurement;
    auto found = std::find_if(families.begin(), families.end(), [&](const Family& family) {
      return family.name == cell.cell.family && family.degree == cell.cell.parameters.degree;
    });
    if (found == families.end()) {
      families.push_back({cell.cell.family, cell.cell.parameters.degree, {}});
      found = families.end() - 1;
    }
    found->points.push_back(
        {static_cast<double>(run.objects), mean.mean(), mean.standard_error(), least_bound(cell)});
  }
  families.erase(
      std::remove_if(families.begin(), families.end(),
                     [](const Family& family) { return family.points.size() < kFewestSizes; }),
      families.end());
  for (Family& family : families) {
    std::sort(family.points.begin(), family.points.end(),
              [](const Point& a, const Point& b) { return a.n < b.n; });
  }
  return families;
}

std::string data_block(const std::string& name, const std::vector<Point>& points) {
  std::string text = "$" + name + " << EOD\n";
  for (const Point& point : points) {
    text += fmt::format("{:.17g} {:.17g} {:.17g} {:.17g}\n", point.n, point.count, 2 * point.error,
                        point.bound);
  }
  return text + "EOD\n";
}

// The hard bounds checked in the family's own runs, as a curve over n; empty if a size has none or
// several: they are then no function of n.
std::vector<Point> bound_curve(const Family& family) {
  std::vector<Point> curve;
  for (const Point& point : family.points) {
    if (!(point.bound > 0)) return {};
    if (!curve.empty() && curve.back().n == point.n) {
      if (curve.back().bound != point.bound) return {};
      continue;
    }
    curve.push_back({point.n, point.bound, 0, point.bound});
  }
  return curve;
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

std::vector<lab::FitPoint> drawn(const std::vector<Point>& points) {
  std::vector<lab::FitPoint> result;
  for (const Point& point : points) result.push_back({point.n, point.count, point.error});
  return result;
}

lab::Figure counts_figure(const VerifyResult& result, const std::string& structure) {
  const std::vector<Family> families = families_of(result.cells, structure);
  lab::Figure figure;
  if (families.empty()) return figure;
  figure.title = structure + ": events over n";
  figure.caption =
      "Points: observed events (mean over seeds, bars of two standard errors where they can be "
      "seen). Lines: fitted powers, with their 95 % intervals. Dashed, in the colour of the "
      "family: the "
      "hard bounds that were checked in its runs, which none may exceed.";
  // Several families may differ only in the degree of the motion.
  const auto name_of = [&](const Family& family) {
    const bool alone = std::count_if(families.begin(), families.end(), [&](const Family& other) {
                         return other.name == family.name;
                       }) == 1;
    return alone ? family.name : fmt::format("{}, degree {}", family.name, family.degree);
  };
  std::vector<lab::Curve> curves;
  for (std::size_t i = 0; i < families.size(); ++i) {
    const Family& family = families[i];
    lab::Curve curve{name_of(family), drawn(family.points), ""};
    curve.look = i;
    curve.joined = false;
    if (const lab::GrowthResult* growth = growth_of(result, structure, family.name)) {
      curve.line = growth->fit;
      curve.line_from = growth->points.front().n;
      curve.value = lab::power_value(*growth->fit, "n");
    }
    curves.push_back(std::move(curve));
    if (const std::vector<Point> bound = bound_curve(family); !bound.empty()) {
      curves.push_back({"hard bound, " + name_of(family), drawn(bound), ""});
      curves.back().is_bound = true;
      curves.back().look = i;
    }
  }
  lab::set_curves(figure, {"objects n", "events", true, true, {}}, curves);
  return figure;
}

// A tic at every size; of many sizes at those that are well apart.
std::string size_tics(const std::vector<Point>& points) {
  constexpr double kApart = 1.25;
  std::string text;
  double last = 0;
  for (const Point& point : points) {
    const bool labelled = point.n >= kApart * last;
    text += fmt::format("{}{}{:.6g}{}", text.empty() ? "" : ", ", labelled ? "" : "'' ", point.n,
                        labelled ? "" : " 1");
    if (labelled) last = point.n;
  }
  return "set xtics (" + text + ")\n";
}

// The references of the family's cells, as departures from the fit.
std::vector<Point> references_of(const VerifyResult& result, const lab::GrowthResult& growth) {
  std::vector<Point> references;
  for (const lab::CellResult& cell : result.cells) {
    if (cell.cell.structure != growth.claim.structure || cell.cell.family != growth.claim.family ||
        cell.trials.empty()) {
      continue;
    }
    const auto n = static_cast<double>(cell.trials.front().measurement.objects);
    if (growth.claim.variable != lab::Variable::kObjects || n < growth.claim.smallest) continue;
    for (const lab::Expectation& expectation : cell.cell.expectations) {
      if (expectation.kind != lab::ExpectationKind::kMean ||
          expectation.quantity != growth.claim.quantity) {
        continue;
      }
      const double fitted = growth.fit->at(n);
      references.push_back({n * 1.03, 100 * (expectation.reference / fitted - 1),
                            100 * expectation.reference_error / fitted, 0});
    }
  }
  return references;
}

lab::Figure residual_figure(const VerifyResult& result, const lab::GrowthResult& growth) {
  lab::Figure figure;
  figure.title = growth.claim.structure + ": residuals of the fit, " + growth.claim.family;
  figure.caption = fmt::format(
      "Expected {}, fitted {}: {}. {} A trend in the residuals is a departure from a pure power.",
      growth.check.expected, growth.check.observed, lab::check_word(growth.check.verdict),
      growth.fit->weighted
          ? fmt::format("chi^2 = {:.1f} on {} degrees of freedom. Bars: two standard errors.",
                        growth.fit->chi_square, growth.fit->degrees)
          : "The counts have no standard errors: the interval is that of their scatter.");
  std::vector<Point> points;
  for (std::size_t i = 0; i < growth.points.size(); ++i) {
    const lab::FitPoint& point = growth.points[i];
    points.push_back(
        {point.n, 100 * growth.fit->residuals[i], 100 * point.error / growth.fit->at(point.n), 0});
  }
  const std::vector<Point> references = references_of(result, growth);
  std::vector<std::string> legend{"95% interval of the exponent", "observed"};
  if (!references.empty()) legend.push_back("reference");
  const lab::LegendPlan plan = lab::legend_below(legend, figure.width);
  figure.script =
      lab::kFrame + plan.commands + "set logscale x\nset ylabel 'count / fit - 1, in %'\n" +
      "set samples 200\nset xlabel " + lab::quoted(lab::variable_name(growth.claim.variable)) +
      "\n" + x_range(points.front().n, points.back().n) + size_tics(points) +
      data_block("seen", points);
  if (!references.empty()) figure.script += data_block("reference", references);
  // With the exponents at the ends of the interval, through the centre of the fit.
  const double centre = growth.fit->centre;
  const double below = growth.fit->lower - growth.fit->b;
  const double above = growth.fit->upper - growth.fit->b;
  figure.script += fmt::format(
      "plot '+' using 1:(100*(($1/{0:.17g})**{1:.17g}-1)):(100*(($1/{0:.17g})**{2:.17g}-1)) "
      "with filledcurves fc rgb '#dcdcdc' title '95% interval of the exponent', \\\n"
      "  0 with lines lw 1.2 lc rgb '#444444' notitle, \\\n"
      "  $seen using 1:2:3 with yerrorbars pt {3} ps 0.9 lw 1.2 lc rgb '{4}' title 'observed'",
      centre, below, above, lab::look(std::size_t{0}).symbol, lab::look(std::size_t{0}).colour);
  if (!references.empty()) {
    figure.script += fmt::format(
        ", \\\n  $reference using 1:2:3 with yerrorbars pt {} ps 0.9 lw 1.2 lc rgb '{}' title "
        "'reference'",
        lab::look(std::size_t{1}).symbol, lab::look(std::size_t{1}).colour);
  }
  figure.script += "\n";
  figure.height = 340 + 20 * plan.rows;
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
  std::vector<lab::Figure> figures;
  for (const lab::FamilyExperiments& family : lab::experiment_families()) {
    if (family.figures == nullptr) continue;
    for (lab::Figure& figure : family.figures(result.cells)) figures.push_back(std::move(figure));
  }
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

}  // namespace kinex::verify
