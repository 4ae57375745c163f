// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "experiments/lab/family.h"

namespace kinex::verify {

namespace {

constexpr std::size_t kFewestSizes = 3;

struct Point {
  double n, count, error;
  double bound;  // 0: none
};

constexpr const char* kCommon =
    "set logscale x\nset grid lc rgb '#dddddd' lw 0.7\nset border 3 lc rgb '#444444'\n"
    "set tics nomirror\nset xlabel \"objects n\\n \"\n"
    "set key outside below center horizontal Left reverse samplen 2.5 maxcols 2 width 2\n";

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

std::string fit_title(const lab::GrowthResult& growth) {
  return fmt::format("fit n^{{{:.3f}}}, 95% in [{:.3f}, {:.3f}]", growth.fit->b, growth.fit->lower,
                     growth.fit->upper);
}

lab::Figure counts_figure(const VerifyResult& result, const std::string& structure) {
  const std::vector<Family> families = families_of(result.cells, structure);
  lab::Figure figure;
  if (families.empty()) return figure;
  figure.title = structure + ": events over n";
  figure.caption =
      "Points: observed events (mean over seeds, bars of two standard errors where they can be "
      "seen). Dashed, in the colour of the family: the hard bounds that were checked in its runs, "
      "which none may exceed.";
  std::string& script = figure.script;
  script = kCommon;
  script += "set logscale y\nset format y '10^{%L}'\nset ylabel 'events'\n";
  // Several families may differ only in the degree of the motion.
  const auto name_of = [&](const Family& family) {
    const bool alone = std::count_if(families.begin(), families.end(), [&](const Family& other) {
                         return other.name == family.name;
                       }) == 1;
    return alone ? family.name : fmt::format("{}, degree {}", family.name, family.degree);
  };
  double low = families.front().points.front().n, high = low, most = 0, fewest = 1e300;
  std::string plot;
  const auto add = [&](const std::string& item) {
    plot += (plot.empty() ? "plot " : ", \\\n  ") + item;
  };
  std::size_t curves = 0;
  for (std::size_t i = 0; i < families.size(); ++i) {
    const Family& family = families[i];
    low = std::min(low, family.points.front().n);
    high = std::max(high, family.points.back().n);
    for (const Point& point : family.points) {
      most = std::max({most, point.count, point.bound});
      fewest = std::min(fewest, point.count);
    }
    script += data_block("family" + std::to_string(i), family.points);
    if (const std::vector<Point> curve = bound_curve(family); !curve.empty()) {
      script += data_block("bound" + std::to_string(i), curve);
      add(fmt::format("$bound{} using 1:2 with lines lw 1.5 dt 2 lc rgb '{}' title {}", i,
                      lab::look(i).colour, lab::quoted("hard bound, " + name_of(family))));
      ++curves;
    }
    for (const lab::GrowthResult& growth : result.growths) {
      if (growth.claim.structure != structure || growth.claim.family != family.name) continue;
      if (!growth.fit) continue;
      add(fmt::format("[{:.6g}:{:.6g}] {:.17g}*x**{:.17g} with lines lw 1.5 lc rgb '{}' title '{}'",
                      growth.points.front().n, growth.points.back().n, growth.fit->a, growth.fit->b,
                      lab::look(i).colour, fit_title(growth)));
    }
    add(fmt::format(
        "$family{} using 1:2:3 with yerrorbars pt {} ps 0.9 lw 1.2 lc rgb '{}' title {}", i,
        lab::look(i).symbol, lab::look(i).colour, lab::quoted(name_of(family))));
  }
  script += x_range(low, high);
  script += fmt::format("set yrange [{:.6g}:{:.6g}]\n", fewest / 2, most * 3) + plot + "\n";
  figure.height = 440 + 20 * static_cast<int>((families.size() + curves + 2) / 2);
  return figure;
}

// A tic at every size.
std::string size_tics(const std::vector<Point>& points) {
  std::string text;
  for (const Point& point : points)
    text += fmt::format("{}{:.6g}", text.empty() ? "" : ", ", point.n);
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
  figure.script = std::string(kCommon) + "set ylabel 'count / fit - 1, in %'\n" +
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
  figure.height = 380;
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
      if (growth.claim.structure == structure && growth.fit) {
        figures.push_back(residual_figure(result, growth));
      }
    }
  }
  return figures;
}

}  // namespace kinex::verify
