// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/trade/plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "experiments/lab/curves.h"
#include "experiments/trade/labels.h"
#include "experiments/trade/report.h"
#include "experiments/trade/standings.h"

namespace kinex::trade {

namespace {

struct StandingLook {
  const char* style;
  const char* title;
  double place;  // in the legend, from the left
};
constexpr StandingLook kStandingLooks[] = {
    {"pt 7 ps 0.6 lc rgb '#009E73'", "same events", 0.32},
    {"pt 9 ps 0.8 lc rgb '#E69F00'", "other events, states valid", 0.51},
    {"pt 2 ps 0.8 lw 2.5 lc rgb '#D55E00'", "wrong", 0.86}};
constexpr const char* kMedianStyle = "pt 6 ps 1.6 lw 2 lc rgb '#222222'";
constexpr double kMedianPlace = 0.17, kLegendHeight = 0.03;

// ---- the plane of speed and accuracy

// Larger errors are drawn here: 2^53 ulps are the time itself.
constexpr double kLargestError = 1e16;
constexpr int kPlaneWidth = 640, kPlaneHeight = 560;
// Of the picture, from the left and from below.
constexpr double kLeft = 0.15, kRight = 0.97, kBelow = 0.17, kAbove = 0.97;

struct PlanePoint {
  double x, ulps;
  Standing standing;
};
struct Cluster {
  std::string arithmetic;
  std::vector<PlanePoint> points;  // by case
  int valid = 0;                   // cases in which every state was valid
  int cases = 0;
  double x = 0, ulps = 0;  // medians
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : std::sqrt(values[middle - 1] * values[middle]);
}

std::vector<Cluster> clusters_of(const TradeResult& result, const std::string& structure) {
  std::vector<Cluster> clusters;
  for (const CaseResult& one : result.cases) {
    if (one.which.structure != structure) continue;
    for (const TradeRun& run : one.runs) {
      auto found = std::find_if(clusters.begin(), clusters.end(), [&](const Cluster& cluster) {
        return cluster.arithmetic == run.arithmetic;
      });
      if (found == clusters.end()) {
        clusters.push_back({run.arithmetic, {}, 0, 0, 0, 0});
        found = clusters.end() - 1;
      }
      ++found->cases;
      found->valid += run.standing() == Standing::kWrong ? 0 : 1;
      const std::optional<double> ratio = one.time_ratio(run);
      if (ratio) found->points.push_back({*ratio, run.deviation.error_ulps, run.standing()});
    }
  }
  clusters.erase(std::remove_if(clusters.begin(), clusters.end(),
                                [](const Cluster& cluster) { return cluster.points.empty(); }),
                 clusters.end());
  for (Cluster& cluster : clusters) {
    std::vector<double> x, ulps;
    for (const PlanePoint& point : cluster.points) {
      x.push_back(point.x);
      ulps.push_back(std::min(point.ulps, kLargestError));
    }
    cluster.x = median(std::move(x));
    cluster.ulps = median(std::move(ulps));
  }
  return clusters;
}

struct Decades {
  int low, high;  // powers of ten
};

// From the axis of zero error to the top.
Decades error_decades(const std::vector<Cluster>& clusters) {
  double least = 1, most = 0;
  for (const Cluster& cluster : clusters) {
    for (const PlanePoint& point : cluster.points) {
      if (point.ulps > 0) least = std::min(least, point.ulps);
      most = std::max(most, std::min(point.ulps, kLargestError));
    }
  }
  const int top = most > 0 ? static_cast<int>(std::ceil(std::log10(most))) : 0;
  const int lowest = static_cast<int>(std::floor(std::log10(least)));
  const int room = std::max(2, (top - lowest) / 12);  // below the smallest error
  return {std::min(lowest, top - 4) - room, top + 1};
}

std::string error_tics(const Decades& decades) {
  int step = 1;
  for (const int candidate : {1, 2, 5, 10, 20, 50, 100, 200}) {
    step = candidate;
    if ((decades.high - decades.low) / step <= 10) break;
  }
  std::string tics = fmt::format("set ytics ('none' 1e{}", decades.low);
  for (int k = decades.high - (decades.high % step + step) % step; k > decades.low + step / 2;
       k -= step) {
    tics += fmt::format(", '10^{{{0}}}' 1e{0}", k);
  }
  // No error is no number of this axis: a line parts it from those that are.
  return tics + fmt::format(
                    ")\nset arrow from graph 0, first {0:.6g} to graph 1, first {0:.6g} nohead dt "
                    "2 lw 1 lc rgb "
                    "'#888888'\n",
                    std::pow(10, decades.low + (decades.high - decades.low) / 28.0));
}

// One line below the plane.
std::string legend() {
  constexpr const char* kEntry = "set label {} at screen {},{} left point {} offset 1.1,-0.35\n";
  std::string text =
      fmt::format(kEntry, lab::quoted("median"), kMedianPlace, kLegendHeight, kMedianStyle);
  for (const StandingLook& one : kStandingLooks) {
    text += fmt::format(kEntry, lab::quoted(one.title), one.place, kLegendHeight, one.style);
  }
  return text;
}

lab::Figure plane_figure(const TradeResult& result, const std::string& structure) {
  const std::vector<Cluster> clusters = clusters_of(result, structure);
  lab::Figure figure;
  if (clusters.size() < 2) return figure;
  figure.width = kPlaneWidth;
  figure.height = kPlaneHeight;
  figure.title = structure + ": speed and accuracy";
  figure.caption =
      "Large: an arithmetic, medians over all scenes, with the number of scenes in which every "
      "state was valid. Small: its single scenes that could be timed; a run that did not reach its "
      "end has no time. Down and to the left is better; exact arithmetics are on the axis of no "
      "error. An ulp is the distance between two neighbouring doubles at the time of the event.";
  const Decades decades = error_decades(clusters);
  const double zero = std::pow(10, decades.low);
  double low = 1, high = 1;
  for (const Cluster& cluster : clusters) {
    for (const PlanePoint& point : cluster.points) {
      low = std::min(low, point.x);
      high = std::max(high, point.x);
    }
  }
  low /= 1.6;
  high *= 2;
  const auto height_of = [&](double error) {
    return error > 0 ? std::min(error, kLargestError) : zero;
  };
  std::string& script = figure.script;
  script = lab::kFrame;
  script += fmt::format(
      "set lmargin at screen {}\nset rmargin at screen {}\nset bmargin at screen {}\nset tmargin "
      "at screen {}\n",
      kLeft, kRight, kBelow, kAbove);
  script += "unset key\n" + legend();
  script += "set logscale xy\n" + lab::log_tics('x', low, high) +
            "set xlabel 'time of the whole run / time in double'\n";
  script += "set ylabel 'largest error of an event time, in ulps of a double' offset 1,0\n";
  script += fmt::format("set xrange [{:.6g}:{:.6g}]\nset yrange [1e{}:1e{}]\n", low, high,
                        decades.low, decades.high);
  script += error_tics(decades);

  // What labels must not cover, and the area for them.
  const auto pixel_x = [&](double x) {
    return kPlaneWidth * (kLeft + (kRight - kLeft) * std::log(x / low) / std::log(high / low));
  };
  const auto pixel_y = [&](double y) {
    return kPlaneHeight * (kBelow + (kAbove - kBelow) * (std::log10(y) - decades.low) /
                                        (decades.high - decades.low));
  };
  LabelPlacer placer(
      {kPlaneWidth * kLeft, kPlaneHeight * kBelow, kPlaneWidth * kRight, kPlaneHeight * kAbove});
  std::vector<std::string> blocks(3);
  std::string medians;
  for (const Cluster& cluster : clusters) {
    for (const PlanePoint& point : cluster.points) {
      const double y = height_of(point.ulps);
      blocks[static_cast<std::size_t>(point.standing)] +=
          fmt::format("{:.6g} {:.6g}\n", point.x, y);
      placer.add_point(pixel_x(point.x), pixel_y(y), 3);
    }
    medians += fmt::format("{:.6g} {:.6g}\n", cluster.x, height_of(cluster.ulps));
    placer.add_point(pixel_x(cluster.x), pixel_y(height_of(cluster.ulps)), 7);
  }
  for (const Cluster& cluster : clusters) {
    const std::string text =
        fmt::format("{} {}/{}", cluster.arithmetic, cluster.valid, cluster.cases);
    const LabelPlacer::Label label =
        placer.place(text, pixel_x(cluster.x), pixel_y(height_of(cluster.ulps)));
    script += fmt::format("set label {} at screen {:.5f},{:.5f} {} front\n", lab::quoted(text),
                          label.x / kPlaneWidth, label.y / kPlaneHeight, label.align);
    if (label.far) {
      script += fmt::format(
          "set arrow from screen {:.5f},{:.5f} to screen {:.5f},{:.5f} nohead lc rgb '#888888' lw "
          "0.7\n",
          label.anchor_x / kPlaneWidth, label.anchor_y / kPlaneHeight, label.from_x / kPlaneWidth,
          label.from_y / kPlaneHeight);
    }
  }
  script += "$medians << EOD\n" + medians + "EOD\n";
  script += fmt::format("plot $medians using 1:2 with points {}", kMedianStyle);
  std::string data;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    data += fmt::format("$standing{} << EOD\n{}EOD\n", i,
                        blocks[i].empty() ? std::string("NaN NaN\n") : blocks[i]);
    script +=
        fmt::format(", \\\n  $standing{} using 1:2 with points {}", i, kStandingLooks[i].style);
  }
  script += "\n";
  script.insert(script.find("plot $medians"), data);
  return figure;
}

// ---- bits over n

constexpr int kDoubleBits = 53;

std::string bits_block(const std::string& name, const std::vector<const BitsResult*>& family) {
  std::string text = "$" + name + " << EOD\n";
  for (const BitsResult* one : family) {
    text += fmt::format("{} {:.6g} {:.6g} {:.6g}\n", one->which.parameters.n, one->most.mean(),
                        2 * one->most.standard_error(), one->percentile_99.mean());
  }
  return text + "EOD\n";
}

lab::Figure bits_figure(const TradeResult& result, const std::string& structure) {
  lab::Figure figure;
  figure.title = structure + ": bits needed to tell its instants apart";
  figure.caption =
      "The significant bits that a number needs to tell two neighbouring instants of a run apart: "
      "at most, mean over scenes with bars of two standard errors, and what 99 % of the pairs of "
      "neighbours need (small, dotted). Lines: fits; the slope is the number of bits for every "
      "doubling of n.";
  std::string data, plot, tics;
  std::vector<std::string> legend;
  double low = 1e300, high = 0;
  double most = kDoubleBits;
  std::size_t colour = 0;
  for (const BitsGrowth& growth : result.growths) {
    if (growth.structure != structure || !growth.most) continue;
    std::vector<const BitsResult*> family;
    for (const BitsResult& one : result.bits) {
      if (one.which.structure != structure || one.which.family != growth.family) continue;
      if (one.most.count() == 0) continue;
      family.push_back(&one);
      const double n = one.which.parameters.n;
      low = std::min(low, n);
      high = std::max(high, n);
      most = std::max(most, one.most.mean() + 2 * one.most.standard_error());
    }
    const std::string name = "family" + std::to_string(colour);
    data += bits_block(name, family);
    const lab::Look& style = lab::look(colour++);
    plot += fmt::format("{}{:.10g}*log(x)/log(2)+{:.10g} with lines lw 1.5 lc rgb '{}' notitle",
                        plot.empty() ? "plot " : ", \\\n  ", growth.most->b,
                        std::log2(growth.most->a), style.colour);
    legend.push_back(fmt::format("{}: {:.2f} bits a doubling, 95% in [{:.2f}, {:.2f}]",
                                 growth.family, growth.most->b, growth.most->lower,
                                 growth.most->upper));
    plot += fmt::format(
        ", \\\n  ${} using 1:2:3 with yerrorbars pt {} ps 0.9 lw 1.2 lc rgb '{}' title {}", name,
        style.symbol, style.colour, lab::quoted(legend.back()));
    plot += fmt::format(
        ", \\\n  ${0} using 1:4 with linespoints dt 3 pt {1} ps 0.4 lw 1.3 lc rgb '{2}' notitle",
        name, style.symbol, style.colour);
    if (tics.empty()) {
      for (const BitsResult* one : family) {
        tics += fmt::format("{}{}", tics.empty() ? "" : ", ", one->which.parameters.n);
      }
    }
  }
  if (plot.empty()) return figure;
  const lab::LegendPlan plan = lab::legend_below(legend, figure.width);
  figure.script = lab::kFrame + plan.commands + "set logscale x 2\n" +
                  fmt::format("set xrange [{:.6g}:{:.6g}]\nset yrange [0:{:.6g}]\n", low / 1.3,
                              high * 1.3, std::ceil(most / 10) * 10 + 5) +
                  "set xtics (" + tics + ")\nset xlabel 'objects n'\nset ylabel 'bits'\n";
  figure.script += fmt::format(
      "set arrow from graph 0, first {0} to graph 1, first {0} nohead dt 2 lw 1.3 lc rgb "
      "'#444444'\nset label 'a double has {0}' at graph 0.985, first {0} right offset 0,0.6 tc rgb "
      "'#444444'\n",
      kDoubleBits);
  figure.script += data + plot + "\n";
  figure.height = 400 + 20 * plan.rows;
  return figure;
}

}  // namespace

std::vector<lab::Figure> trade_figures(const TradeResult& result) {
  std::vector<lab::Figure> figures;
  const std::vector<std::string> structures = structures_of(result);
  for (const auto make : {plane_figure, bits_figure}) {
    for (const std::string& structure : structures) {
      lab::Figure figure = make(result, structure);
      if (!figure.script.empty()) figures.push_back(std::move(figure));
    }
  }
  return figures;
}

}  // namespace kinex::trade
