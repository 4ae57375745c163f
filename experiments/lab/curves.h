// SPDX-License-Identifier: GPL-3.0-or-later
// Curves: a picture of named curves on logarithmic or linear axes, in gnuplot's commands. All
// pictures follow the same rules: one form of numbers per axis, nothing hidden, no zero on a
// logarithmic axis, room for every label.
#ifndef KINEX_EXPERIMENTS_LAB_CURVES_H
#define KINEX_EXPERIMENTS_LAB_CURVES_H

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "experiments/lab/fit.h"
#include "experiments/lab/gnuplot.h"

namespace kinex::lab {

// A curve goes through its points in their order. A standard error above 0 is drawn as a bar of two
// of them to each side.
struct Curve {
  std::string name;
  std::vector<FitPoint> points;
  std::string value;  // what was fitted, marked up; it follows the name in the legend
  std::optional<Fit> line = std::nullopt;  // drawn to the last point
  double line_from = 0;                    // from here, or from the first point
  bool is_bound = false;                   // dashed, without symbols; it may leave the picture
  bool joined = true;                      // its points, by lines
  std::optional<std::size_t> look = std::nullopt;  // nullopt: its place among the curves
};

struct CurvesPicture {
  std::string x, y;  // names of the axes, with units
  bool log_x = true, log_y = true;
  std::vector<double> slopes;       // guides n^slope, each with its own dashes; of logarithmic axes
  std::vector<double> x_tics = {};  // these instead of round numbers
  std::string title = {};           // above the picture; empty: none
};

// Sets the script, width and height of a figure. The legend mentions values that a logarithmic axis
// cannot show. A curve that later ones cover is drawn wider below them, with large hollow symbols. Bounds more
// than a decade above everything else do not stretch the picture; the legend names what is left out.
void set_curves(Figure& figure, const CurvesPicture& picture, const std::vector<Curve>& curves);

// ---- parts

// Grid, borders and tics.
inline constexpr const char* kFrame =
    "set grid lc rgb '#dddddd' lw 0.7\nset border 3 lc rgb '#444444'\nset tics nomirror\n";

// The numbers of a figure's logarithmic axes have one form: plain (200, 10000), or powers of ten (10^4) if one
// of them is a million or more, or below 10^-4.
enum class TicForm { kPlain, kPowers };
TicForm tic_form(double low, double high);  // the range of all logarithmic axes

// Numbers of a logarithmic axis ('x' or 'y') with this range: powers of ten over two decades and
// more, else 1, 2, 5, 10, ..; all of them if the range is below a factor of 4. `labelled`: with the
// numbers, not the marks alone.
std::string log_tics(char axis, double low, double high, TicForm form, bool labelled = true);

// A key below the picture that its entries fit into, in one or two columns: its rows.
struct LegendPlan {
  std::string commands;
  int rows = 0;
};
LegendPlan legend_below(const std::vector<std::string>& entries, int width);

// "n^{1.51}" and the like, marked up: a power with its 95 % interval.
std::string power_value(const Fit& fit, const std::string& variable);

// A fit that leaves nothing but rounding: all residuals below 1e-9.
bool is_exact(const Fit& fit);

}  // namespace kinex::lab

#endif
