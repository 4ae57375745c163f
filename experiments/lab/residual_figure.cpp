// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/residual_figure.h"

#include <fmt/format.h>

#include <cmath>

#include "experiments/lab/curves.h"

namespace kinex::lab {

namespace {

constexpr int kResidualsHeight = 380, kLegendRow = 20;
constexpr double kBeside = 1.03;  // where references are drawn, over the size

std::string size_text(double n) {
  return n == std::floor(n) ? fmt::format("{:.6g}", n) : fmt::format("{:.3g}", n);
}

// A tic at every size; of many sizes at those that are well apart.
std::string size_tics(const std::vector<FitPoint>& points) {
  constexpr double kApart = 1.25;
  std::string text;
  double last = 0;
  for (const FitPoint& point : points) {
    const bool labelled = point.n >= kApart * last;
    text += fmt::format("{}'{}' {:.10g}{}", text.empty() ? "" : ", ", labelled ? size_text(point.n) : "",
                        point.n, labelled ? "" : " 1");
    if (labelled) last = point.n;
  }
  return "set xtics (" + text + ")\n";
}

std::string data_block(const char* name, const Fit& fit, const std::vector<FitPoint>& points,
                       double beside) {
  std::string text = fmt::format("${} << EOD\n", name);
  for (const FitPoint& point : points) {
    const double fitted = fit.at(point.n);
    text += fmt::format("{:.17g} {:.17g} {:.17g}\n", point.n * beside, 100 * (point.count / fitted - 1),
                        200 * point.error / fitted);
  }
  return text + "EOD\n";
}

}  // namespace

void set_residuals(Figure& figure, const Fit& fit, const std::vector<FitPoint>& points,
                   const std::vector<FitPoint>& references, const ResidualWords& words) {
  std::vector<std::string> legend{"95% interval of the exponent", "observed"};
  std::string data = data_block("seen", fit, points, 1), more;
  const auto bars = [&](const std::string& name, const std::string& title, std::size_t style) {
    return fmt::format(", \\\n  ${} using 1:2:3 with yerrorbars pt {} ps 0.9 lw 1.2 lc rgb '{}' title '{}'",
                       name, look(style).symbol, look(style).colour, title);
  };
  if (!references.empty()) {
    legend.push_back("reference");
    data += data_block("reference", fit, references, kBeside);
    more = bars("reference", "reference", 1);
  }
  const LegendPlan plan = legend_below(legend, figure.width);
  // With the exponents at the ends of the interval, through the centre of the fit.
  figure.script =
      kFrame + plan.commands + "set logscale x\nset ylabel 'count / fit - 1, in %'\nset samples 200\n" +
      title_command(words.structure + ": residuals of the fit", words.family) + "set xlabel " +
      quoted(words.x) +
      fmt::format("\nset xrange [{:.6g}:{:.6g}]\n", points.front().n * 0.8, points.back().n * 1.25) +
      size_tics(points) + data +
      fmt::format("plot '+' using 1:(100*(($1/{0:.17g})**{1:.17g}-1)):(100*(($1/{0:.17g})**{2:.17g}-1)) "
                  "with filledcurves fc rgb '#dcdcdc' title '{3}', \\\n"
                  "  0 with lines lw 1.2 lc rgb '#444444' notitle",
                  fit.centre, fit.lower - fit.b, fit.upper - fit.b, legend.front()) +
      bars("seen", "observed", 0) + more + "\n";
  figure.height = kResidualsHeight + kLegendRow * plan.rows;
}

}  // namespace kinex::lab
