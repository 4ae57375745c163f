// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace kinex::lab {

namespace {

constexpr int kPlotHeight = 390;  // without the legend
constexpr int kRowHeight = 20;
constexpr double kCharacter = 7.6;  // pixels, of the widest font that stands in for Helvetica
constexpr double kSample = 62;      // of a legend's entry, beside its text
constexpr double kWidth = 1.5, kSymbol = 0.8;                // of a curve that covers none
constexpr double kWidthInLegend = 6, kSymbolInLegend = 1.1;  // at most, there
constexpr double kAboveData = 10;   // bounds beyond this multiple of the data leave the picture
constexpr double kHidden = 4;       // pixels: a symbol nearer to another curve is covered by it
constexpr double kAxisWidth = 540, kAxisHeight = 290;  // about

struct Range {
  double low = 1e300, high = -1e300;
  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
  bool empty() const { return low > high; }
};

// Length of a marked-up text as it is read.
std::size_t read_length(const std::string& text) {
  std::size_t length = 0;
  for (const char c : text) {
    if (c != '{' && c != '}' && c != '^' && c != '_' && c != '\\' && (c & 0xC0) != 0x80) ++length;
  }
  return length;
}

// A marked-up text in plain letters: "n^1.51".
std::string unmarked(const std::string& text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '{' || text[i] == '}') continue;
    if (text[i] == '\\' || text.compare(i, 2, "''") == 0) ++i;  // the next letter itself
    if (i < text.size()) plain += text[i];
  }
  return plain;
}

bool is_drawn(const CurvesPicture& picture, const FitPoint& point) {
  return std::isfinite(point.count) && (!picture.log_y || point.count > 0) &&
         (!picture.log_x || point.n > 0);
}

// What the legend says of points that the axis does not have.
std::string left_out(const CurvesPicture& picture, const Curve& curve) {
  std::size_t drawn = 0, zeros = 0;
  for (const FitPoint& point : curve.points) {
    drawn += is_drawn(picture, point) ? 1 : 0;
    zeros += point.count == 0 ? 1 : 0;
  }
  if (drawn == curve.points.size() || zeros == 0) return "";
  if (drawn == 0) return ": 0 throughout";
  std::string at;
  if (zeros <= 3) {
    for (const FitPoint& point : curve.points) {
      if (point.count == 0) at += fmt::format("{}{:.4g}", at.empty() ? " at " : ", ", point.n);
    }
  } else {
    at = fmt::format(" at {} sizes", zeros);
  }
  return ": 0" + at;
}

class CurvesDrawing {
 public:
  CurvesDrawing(const CurvesPicture& picture, const std::vector<Curve>& curves)
      : picture_(picture), curves_(curves) {
    measure();
  }

  void draw(Figure& figure) {
    measure_covering();
    Range numbers;
    for (const auto& [log, range] :
         {std::pair(picture_.log_x, x_), std::pair(picture_.log_y, y_)}) {
      if (!log) continue;
      numbers.add(range.low);
      numbers.add(range.high);
    }
    const TicForm form = tic_form(numbers.low, numbers.high);
    for (std::size_t i = 0; i < curves_.size(); ++i) add_curve(i);
    for (const double slope : picture_.slopes) add_guide(slope);
    const LegendPlan legend = legend_below(entries_, figure.width);
    std::string text = kFrame + legend.commands;
    text += axis('x', picture_.x, picture_.log_x, x_, form);
    text += axis('y', picture_.y, picture_.log_y, y_, form);
    if (!picture_.x_tics.empty()) {
      text += "set xtics (";
      for (std::size_t i = 0; i < picture_.x_tics.size(); ++i) {
        text += fmt::format("{}{:.6g}", i == 0 ? "" : ", ", picture_.x_tics[i]);
      }
      text += ")\n";
    }
    if (plot_.empty()) plot_ = "plot NaN notitle";  // nothing but zeros
    if (!picture_.title.empty()) text += title_command(picture_.title);
    figure.script = text + data_ + plot_ + "\n";
    figure.panel = picture_.title;
    figure.names = names_;
    figure.height = kPlotHeight + kRowHeight * legend.rows;
  }

 private:
  void measure() {
    Range bound;
    for (const Curve& curve : curves_) {
      for (const FitPoint& point : curve.points) {
        if (!is_drawn(picture_, point)) continue;
        x_.add(point.n);
        Range& y = curve.is_bound ? bound : y_;
        y.add(point.count);
        const double error = 2 * point.error;
        y.add(point.count + error);
        if (!picture_.log_y || point.count - error > 0) y.add(point.count - error);
      }
    }
    if (y_.empty()) y_ = bound.empty() ? Range{1, 1} : bound;
    if (x_.empty()) x_ = {1, 1};
    if (!bound.empty()) {
      const double low = picture_.log_y ? y_.low / kAboveData : bound.low;
      y_.low = std::min(y_.low, std::max(bound.low, low));
      y_.high = std::max(y_.high, std::min(bound.high, kAboveData * y_.high));
    }
    x_ = widened(x_, picture_.log_x, 1.25, 0.04);
    y_ = widened(y_, picture_.log_y, 1.5, 0.06);
  }

  static Range widened(Range range, bool log, double factor, double share) {
    if (log) return {range.low / factor, range.high * factor};
    const double size = range.high > range.low ? range.high - range.low : 1;
    const double low = range.low - share * size;
    return {range.low >= 0 && low < 0 ? 0 : low, range.high + share * size};
  }

  static std::string axis(char name, const std::string& title, bool log, const Range& range,
                          TicForm form) {
    std::string text =
        log ? fmt::format("set logscale {}\n", name) + log_tics(name, range.low, range.high, form)
            : std::string();
    text += fmt::format("set {}range [{:.8g}:{:.8g}]\n", name, range.low, range.high);
    return text + fmt::format("set {}label {}\n", name, quoted(title));
  }

  // `name`: where the legend has no entry for it.
  void add(const std::string& item, const std::string& entry, const std::string& name = "") {
    names_.push_back(entry.empty() ? name : unmarked(entry));
    plot_ += (plot_.empty() ? "plot " : ", \\\n  ") + item;
    if (entry.empty()) {
      plot_ += " notitle";
    } else {
      plot_ += " title '" + entry + "'";
      entries_.push_back(entry);
    }
  }

  void add_curve(std::size_t i) {
    const Curve& curve = curves_[i];
    const Look& style = look(curve.look.value_or(i));
    const std::string block =
        fmt::format("${}{}", curve.is_bound ? "bound" : "curve", curve.look.value_or(i));
    std::size_t drawn = 0;
    bool bars = false;
    data_ += block + " << EOD\n";
    for (const FitPoint& point : curve.points) {
      if (!is_drawn(picture_, point)) continue;
      ++drawn;
      bars = bars || point.error > 0;
      double below = point.count - 2 * point.error;
      if (picture_.log_y && !(below > 0)) below = y_.low / 10;  // down to the edge and beyond
      data_ += fmt::format("{:.10g} {:.10g} {:.10g} {:.10g}\n", point.n, point.count, below,
                           point.count + 2 * point.error);
    }
    data_ += "EOD\n";
    std::string entry = marked(curve.name) + left_out(picture_, curve);
    if (drawn > 0 && !curve.value.empty()) entry += ": " + curve.value;
    if (curve.is_bound) {
      add_bound(curve, block, style, entry);
      return;
    }
    if (drawn == 0) {
      add(fmt::format("NaN with points pt {} ps 0.8 lc rgb '{}'", style.symbol, style.colour),
          entry);
      return;
    }
    const std::size_t over = covering_[i];
    // A line is wider than those that cover it; bars alone need not be. The widest of many stays a line.
    const double most = static_cast<double>(std::max<std::size_t>(most_covering_, 1));
    const double width =
        kWidth + (curve.joined ? std::min(4.5, 12 / most) : 0.7) * static_cast<double>(over);
    const double size = kSymbol + std::min(0.9, 2.4 / most) * static_cast<double>(over);
    if (curve.line) add_line(curve, i, style);
    const char* with = curve.joined ? (bars ? "yerrorlines" : "linespoints")
                       : bars       ? "yerrorbars"
                                    : "points";
    const auto styled = [&](const std::string& what, const char* how, double thick, double large) {
      return fmt::format("{} with {} lw {:.2g} ps {:.2g} pt {} lc rgb '{}'", what, how, thick,
                         large, over > 0 ? style.hollow : style.symbol, style.colour);
    };
    const std::string data = block + (bars ? " using 1:2:3:4" : " using 1:2");
    if (size <= kSymbolInLegend) return add(styled(data, with, width, size), entry);
    // A symbol of this size would lie over the lines of the legend above and below its own.
    add(styled(data, with, width, size), "", unmarked(entry));
    add(styled("NaN", curve.joined ? "linespoints" : "points", std::min(width, kWidthInLegend),
               kSymbolInLegend),
        entry);
  }

  // How many curves lie above each at most, each covering the one below it.
  void measure_covering() {
    covering_.assign(curves_.size(), 0);
    for (std::size_t i = curves_.size(); i-- > 0;) {
      if (curves_[i].is_bound) continue;
      for (std::size_t j = i + 1; j < curves_.size(); ++j) {
        if (curves_[j].is_bound || !runs_along(curves_[i], curves_[j])) continue;
        covering_[i] = std::max(covering_[i], 1 + covering_[j]);
      }
      most_covering_ = std::max(most_covering_, covering_[i]);
    }
  }

  // True if a third of the points of `a`, or more, would be hidden by `b`.
  bool runs_along(const Curve& a, const Curve& b) const {
    const auto hidden = static_cast<std::size_t>(std::count_if(
        a.points.begin(), a.points.end(), [&](const FitPoint& p) { return is_hidden(p, b); }));
    return hidden > 0 && 3 * hidden >= a.points.size();
  }

  bool is_hidden(const FitPoint& point, const Curve& by) const {
    if (!is_drawn(picture_, point)) return false;
    const Place p = place(point);
    const Place* last = nullptr;
    Place here, before;
    for (const FitPoint& q : by.points) {
      if (!is_drawn(picture_, q)) continue;
      here = place(q);
      if (distance(p, here, last != nullptr && by.joined ? *last : here) <= kHidden) return true;
      before = here;
      last = &before;
    }
    return false;
  }

  struct Place {
    double x = 0, y = 0;  // pixels
  };
  Place place(const FitPoint& p) const {
    return {kAxisWidth * share(p.n, x_, picture_.log_x),
            kAxisHeight * share(p.count, y_, picture_.log_y)};
  }
  static double share(double value, const Range& range, bool log) {
    return log ? std::log(value / range.low) / std::log(range.high / range.low)
               : (value - range.low) / (range.high - range.low);
  }
  // From a place to the straight line between two.
  static double distance(const Place& p, const Place& a, const Place& b) {
    const double x = b.x - a.x, y = b.y - a.y, length = x * x + y * y;
    const double along =
        length > 0 ? std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / length, 0.0, 1.0) : 0;
    return std::hypot(p.x - a.x - along * x, p.y - a.y - along * y);
  }

  void add_line(const Curve& curve, std::size_t i, const Look& style) {
    const double low = std::log(std::max(curve.points.front().n, curve.line_from)),
                 high = std::log(curve.points.back().n);
    data_ += fmt::format("$line{} << EOD\n", i);
    for (int k = 0; k <= 60; ++k) {
      const double n = std::exp(low + (high - low) * k / 60);
      data_ += fmt::format("{:.8g} {:.8g}\n", n, curve.line->at(n));
    }
    data_ += "EOD\n";
    add(fmt::format("$line{} using 1:2 with lines lw 1.4 lc rgb '{}'", i, style.colour), "",
        curve.name + ", fitted");
  }

  void add_bound(const Curve& curve, const std::string& block, const Look& style,
                 std::string entry) {
    const FitPoint* first_above = nullptr;
    bool below = false;
    for (const FitPoint& point : curve.points) {
      below = below || point.count <= y_.high;
      if (point.count > y_.high && first_above == nullptr) first_above = &point;
    }
    if (first_above != nullptr) {
      entry += below ? fmt::format(", above from {:.4g} on", first_above->n)
                     : fmt::format(", above: {:.2g} at {:.4g}", curve.points.front().count,
                                   curve.points.front().n);
    }
    add(fmt::format("{} using 1:2 with lines lw 1.5 dt {} lc rgb '{}'", block, dash(bounds_++),
                    style.colour),
        entry);
  }

  // Below the last point of the curve that rises most like it; none if no curve does.
  void add_guide(double slope) {
    constexpr double kFarthestSlope = 0.9;
    const FitPoint* last = nullptr;
    double nearest = 0;
    for (const Curve& curve : curves_) {
      const FitPoint *from = nullptr, *to = nullptr;
      for (const FitPoint& point : curve.points) {
        if (!is_drawn(picture_, point)) continue;
        if (from == nullptr) from = &point;
        to = &point;
      }
      if (curve.is_bound || from == to) continue;
      const double own = std::log(to->count / from->count) / std::log(to->n / from->n);
      if (last != nullptr && std::fabs(own - slope) >= nearest) continue;
      nearest = std::fabs(own - slope);
      last = to;
    }
    if (last == nullptr || nearest > kFarthestSlope) return;
    const double factor = 0.6 * last->count / std::pow(last->n, slope);
    add(fmt::format("{:.10g}*x**{:.6g} with lines lw 1.2 dt {} lc rgb '#555555'", factor, slope,
                    guide_dash(guides_++)),
        fmt::format("slope {:.4g}", slope));
  }

  const CurvesPicture& picture_;
  const std::vector<Curve>& curves_;
  Range x_, y_;
  std::string data_, plot_;
  std::vector<std::string> entries_, names_;
  std::size_t bounds_ = 0, guides_ = 0;
  std::vector<std::size_t> covering_;
  std::size_t most_covering_ = 0;
};

}  // namespace

void set_curves(Figure& figure, const CurvesPicture& picture, const std::vector<Curve>& curves) {
  CurvesDrawing(picture, curves).draw(figure);
}

TicForm tic_form(double low, double high) {
  return low > 1e-4 && high < 1e6 ? TicForm::kPlain : TicForm::kPowers;
}

std::string log_tics(char axis, double low, double high, TicForm form, bool labelled) {
  const double decades = std::log10(high / low);
  const bool long_axis = decades >= 2;              // only powers of ten have labels
  const bool short_axis = decades < std::log10(4);  // 1, 2 and 5 alone would name one place, or none
  const int step = std::max(1, static_cast<int>(std::ceil(decades / 8)));
  const auto name = [&](int digit, int k) {
    if (form == TicForm::kPlain) return fmt::format("{:.10g}", digit * std::pow(10, k));
    return fmt::format("{}10^{{{}}}", digit == 1 ? "" : fmt::format("{}\u00b7", digit), k);
  };
  std::string text;
  // Every place is written out: gnuplot's own steps begin at the end of the range, wherever that is.
  for (int k = static_cast<int>(std::floor(std::log10(low))); k <= std::log10(high); ++k) {
    for (int digit = 1; digit < 10; ++digit) {
      const double value = digit * std::pow(10, k);
      if (value < low || value > high) continue;
      if (long_axis && digit > 1 && step > 1) continue;
      const bool round = digit == 1 || digit == 2 || digit == 5 || short_axis;
      const bool named = long_axis ? digit == 1 && k % step == 0 : round;
      text += fmt::format("{}'{}' {}e{}{}", text.empty() ? "" : ", ",
                          named && labelled ? name(digit, k) : "", digit, k, named ? "" : " 1");
    }
  }
  return fmt::format("set {}tics ({})\n", axis, text);
}

LegendPlan legend_below(const std::vector<std::string>& entries, int width) {
  std::size_t longest = 0;
  for (const std::string& entry : entries) longest = std::max(longest, read_length(entry));
  const double needed = kSample + kCharacter * static_cast<double>(longest);
  const int columns = 2 * needed <= width - 140 && entries.size() > 1 ? 2 : 1;
  LegendPlan plan;
  plan.rows = (static_cast<int>(entries.size()) + columns - 1) / columns;
  // A line of its own lies between the axis's name and the key.
  plan.commands = fmt::format(
      "set key at screen 0.5, screen 0.02 center bottom horizontal Left reverse samplen 2.5 "
      "maxcols "
      "{} width 2\nset bmargin {}\n",
      columns, 3.2 + plan.rows * 1.13);
  return plan;
}

std::string power_value(const Fit& fit, const std::string& variable) {
  if (is_exact(fit) && std::fabs(fit.b) < 1e-9) return "constant";
  if (fit.upper - fit.lower < 1e-3) return fmt::format("{}^{{{:.3f}}}", variable, fit.b);
  return fmt::format("{}^{{{:.3f}}} [{:.3f}, {:.3f}]", variable, fit.b, fit.lower, fit.upper);
}

bool is_exact(const Fit& fit) {
  constexpr double kRounding = 1e-9;
  return std::all_of(fit.residuals.begin(), fit.residuals.end(),
                     [](double residual) { return std::fabs(residual) < kRounding; });
}

}  // namespace kinex::lab
