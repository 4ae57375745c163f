// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/points/law_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/lab/curves.h"

namespace kinex::families {

namespace {

// Of a statement that is too long for the width of the picture, without what it says in brackets; the
// page has all of it.
std::string title_of(const std::string& statement) {
  constexpr std::size_t kWidest = 84;
  const std::size_t bracket = statement.rfind(" (");
  if (statement.size() <= kWidest || bracket == statement.npos) return statement;
  return statement.substr(0, bracket) + ".";
}

constexpr int kSteps = 100;  // of a drawn law

// Columns: n, mean, two errors, and what each fit leaves.
std::string data_of(const std::vector<lab::FitPoint>& points, const std::vector<lab::Fit>& fits) {
  std::string text = "$means << EOD\n";
  for (std::size_t i = 0; i < points.size(); ++i) {
    text +=
        fmt::format("{:.10g} {:.10g} {:.10g}", points[i].n, points[i].count, 2 * points[i].error);
    for (const lab::Fit& fit : fits) {
      text += fmt::format(" {:.6g}", fit.weighted ? fit.in_errors[i] : 100 * fit.residuals[i]);
    }
    text += "\n";
  }
  text += "EOD\n";
  const double low = std::log(points.front().n), high = std::log(points.back().n);
  for (std::size_t k = 0; k < fits.size(); ++k) {
    text += fmt::format("$fit{} << EOD\n", k);
    for (int i = 0; i <= kSteps; ++i) {
      const double n = std::exp(low + (high - low) * i / kSteps);
      text += fmt::format("{:.8g} {:.8g}\n", n, fits[k].at(n));
    }
    text += "EOD\n";
  }
  return text;
}

// "a + b ln^2 n, b = 2.07 [2.05, 2.09]", marked up.
std::string legend_of(const lab::Fit& fit) {
  return lab::formula(fit.law) +
         fmt::format(", b = {:.4g} [{:.4g}, {:.4g}]", fit.b, fit.lower, fit.upper);
}

struct CountRange {
  double low, high;
};

// Of the axis of counts; a power is drawn on a logarithmic one.
CountRange range_of(const LawNames& names, const std::vector<lab::FitPoint>& points) {
  double low = points.front().count, high = low;
  for (const lab::FitPoint& point : points) {
    low = std::min(low, point.count - 2 * point.error);
    high = std::max(high, point.count + 2 * point.error);
  }
  if (names.exponent > 0) return {std::max(low, 0.5) / 2, high * 2};
  return {0, 1.2 * high};
}

std::string counts_part(const LawNames& names, const std::vector<lab::FitPoint>& points,
                        const std::vector<lab::Fit>& fits, const CountRange& range,
                        lab::TicForm form) {
  std::string text = "set tmargin at screen 0.93\nset bmargin at screen 0.43\n";
  const bool is_power = names.exponent > 0;
  if (is_power) {
    text += "set logscale y\n" + lab::log_tics('y', range.low, range.high, form) +
            fmt::format("set yrange [{:.8g}:{:.8g}]\n", range.low, range.high);
  } else {
    text += fmt::format("set yrange [0:{:.8g}]\n", range.high);
  }
  text += "set key left top Left reverse samplen 2.5\nset title '" + lab::formula(title_of(names.statement)) +
          "'\nset ylabel " + lab::quoted(names.counted) +
          "\nplot $means using 1:2:3 with yerrorbars lw 1.4 ps 0.8 pt 7 lc rgb '#222222' title "
          "'mean, two standard errors'";
  for (std::size_t k = 0; k < fits.size(); ++k) {
    text += fmt::format(", $fit{} using 1:2 with lines lw {} lc rgb '{}' title '{}'", k,
                        k + 1 < fits.size() ? 3 : 1.4, lab::look(k).colour, legend_of(fits[k]));
  }
  if (is_power) {  // half as high as the last mean, so that it is seen beside the fit
    const double factor = points.back().count / 2 / std::pow(points.back().n, names.exponent);
    text += fmt::format(
        ", {:.10g}*x**{:.6g} with lines lw 1.2 dt 3 lc rgb '#777777' title 'slope {:.4g}'", factor,
        names.exponent, names.exponent);
  }
  return text + "\n";
}

std::string rest_part(const std::vector<lab::Fit>& fits) {
  const bool weighted =
      std::all_of(fits.begin(), fits.end(), [](const lab::Fit& f) { return f.weighted; });
  std::string text =
      "set tmargin at screen 0.37\nset bmargin at screen 0.11\nunset title\nunset logscale y\nset "
      "format y "
      "'%g'\nset ytics autofreq\nset yrange [*:*]\nset offsets graph 0, 0, 0.05, 0.05\n";
  text += "set xlabel 'objects n'\nset ylabel " +
          std::string(weighted ? "'residual / standard error'" : "'residual, %'") +
          "\nunset key\nplot ";
  if (weighted) text += "'+' using 1:(-2):(2) with filledcurves fc rgb '#e6e6e6', ";
  text += "0 with lines lc rgb '#888888'";
  for (std::size_t k = 0; k < fits.size(); ++k) {
    text += fmt::format(", $means using 1:{} with linespoints lw 1.2 ps 0.7 pt {} lc rgb '{}'",
                        k + 4, lab::look(k).symbol, lab::look(k).colour);
  }
  return text + "\n";
}

}  // namespace

lab::Figure law_figure(const LawNames& names, const std::vector<lab::FitPoint>& points,
                       const std::vector<lab::Fit>& fits) {
  lab::Figure figure;
  figure.title = names.title;
  figure.caption =
      "Means with two standard errors, the fits with their 95 % intervals, and below what is left "
      "of each; grey: two standard errors.";
  figure.height = 620;
  const double low = points.front().n * 0.8, high = points.back().n * 1.25;
  const CountRange counts = range_of(names, points);
  const bool is_power = names.exponent > 0;
  const lab::TicForm form =
      is_power ? lab::tic_form(std::min(low, counts.low), std::max(high, counts.high))
               : lab::tic_form(low, high);
  const std::string tics = lab::log_tics('x', low, high, form);
  figure.script = data_of(points, fits) + "set multiplot\nset logscale x\n" + lab::kFrame +
                  "set lmargin at screen 0.16\nset rmargin at screen 0.96\n" +
                  fmt::format("set xrange [{:.6g}:{:.6g}]\n", low, high) +
                  lab::log_tics('x', low, high, form, false) +
                  counts_part(names, points, fits, counts, form) + tics + rest_part(fits) +
                  "unset multiplot\n";
  return figure;
}

}  // namespace kinex::families
