// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/trade/plots.h"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

#include "experiments/lab/curves.h"
#include "experiments/lab/scatter.h"
#include "experiments/trade/standings.h"

namespace kinex::trade {

namespace {

// ---- the plane of speed and accuracy

// By standing. 2^53 ulps are the time itself: larger errors are drawn there.
const lab::ScatterPicture& plane() {
  static const lab::ScatterPicture kPlane{
      "time of the whole run / time in double",
      "largest error of an event time, in ulps of a double",
      1e16,
      0.17,
      {{"pt 7 ps 0.6 lc rgb '#009E73'", "same events", 0.32},
       {"pt 9 ps 0.8 lc rgb '#E69F00'", "other events, states valid", 0.51},
       {"pt 2 ps 0.8 lw 2.5 lc rgb '#D55E00'", "wrong", 0.86}}};
  return kPlane;
}

lab::Figure plane_figure(const TradeResult& result, const std::string& structure) {
  std::vector<lab::ScatterGroup> groups;
  for (const ArithmeticStandings& arithmetic : standings_of(result)) {
    int valid = 0, cases = 0;  // those in which every state was valid
    lab::ScatterGroup group;
    for (const CaseResult& one : result.cases) {
      const TradeRun* run = one.run_in(arithmetic.arithmetic);
      if (one.which.structure != structure || run == nullptr) continue;
      ++cases;
      valid += run->standing() == Standing::kWrong ? 0 : 1;
      const std::optional<double> ratio = one.time_ratio(*run);
      if (!ratio) continue;
      group.points.push_back(
          {*ratio, run->deviation.error_ulps, static_cast<std::size_t>(run->standing())});
    }
    group.label = fmt::format("{} {}/{}", arithmetic.arithmetic, valid, cases);
    if (!group.points.empty()) groups.push_back(std::move(group));
  }
  lab::Figure figure;
  if (groups.size() < 2) return figure;
  figure.title = structure + ": speed and accuracy";
  figure.caption =
      "Large: an arithmetic, medians over all scenes, with the number of scenes in which every state "
      "was valid. Small: its single scenes that could be timed; a run that did not reach its end has "
      "no time. Down and to the left is better; exact arithmetics are on the axis of no error. An ulp "
      "is the distance between two neighbouring doubles at the time of the event.";
  lab::set_scatter(figure, plane(), groups);
  return figure;
}

// ---- bits over n

constexpr double kDoubleBits = 53;

// Of 2^bits a power, of the bits a + b log2 n.
lab::Fit line_of(const lab::Fit& power) {
  lab::Fit line = power;
  line.a = std::log2(power.a);
  line.g = [](double n) { return std::log2(n); };
  return line;
}

lab::Figure bits_figure(const TradeResult& result, const std::string& structure) {
  std::vector<lab::Curve> curves, small;
  std::vector<double> sizes;
  for (const BitsGrowth& growth : result.growths) {
    if (growth.structure != structure || !growth.most) continue;
    lab::Curve most{growth.family, {}, ""}, pairs{growth.family + ", 99 % of the pairs", {}, ""};
    for (const BitsResult& one : result.bits) {
      if (one.which.structure != structure || one.which.family != growth.family) continue;
      if (one.most.count() == 0) continue;
      const double n = one.which.parameters.n;
      most.points.push_back({n, one.most.mean(), one.most.standard_error()});
      pairs.points.push_back({n, one.percentile_99.mean(), 0});
      if (curves.empty()) sizes.push_back(n);
    }
    most.value = fmt::format("{:.2f} bits a doubling, 95% in [{:.2f}, {:.2f}]", growth.most->b,
                             growth.most->lower, growth.most->upper);
    most.line = line_of(*growth.most);
    most.joined = false;
    curves.push_back(std::move(most));
    small.push_back(std::move(pairs));
  }
  lab::Figure figure;
  if (curves.empty()) return figure;
  figure.title = structure + ": bits needed to tell its instants apart";
  figure.caption =
      "The significant bits that a number needs to tell two neighbouring instants of a run apart: at "
      "most, mean over scenes with bars of two standard errors, and what 99 % of the pairs of "
      "neighbours need. Straight lines: fits; the slope is the number of bits for every doubling of n.";
  curves.insert(curves.end(), small.begin(), small.end());
  curves.push_back(
      {"a double has 53", {{sizes.front(), kDoubleBits, 0}, {sizes.back(), kDoubleBits, 0}}, ""});
  curves.back().is_bound = true;
  lab::set_curves(figure, {"objects n", "bits", true, false, {}, sizes}, curves);
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
