// SPDX-License-Identifier: GPL-3.0-or-later
// The counts of families with n = m, over n: they grow like n^2.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "experiments/families/extent/quadratic_families.h"
#include "experiments/lab/curves.h"

namespace kinex::families {

std::vector<lab::Figure> quadratic_figures(const std::vector<lab::CellResult>& cells) {
  std::vector<lab::Curve> curves;
  for (const lab::CellResult& result : cells) {
    const lab::Cell& cell = result.cell;
    if (cell.axis.name != kBothSizes || result.trials.empty()) continue;
    for (const lab::Expectation& expectation : cell.expectations) {
      const double count = lab::mean_of(result.trials, expectation.quantity).mean();
      if (!(count > 2)) continue;  // a constant, or nearly none
      std::string label = cell.structure + ", " + cell.family;
      if (expectation.quantity.starts_with("kind.")) label += ": " + expectation.quantity.substr(5);
      auto curve = std::find_if(curves.begin(), curves.end(),
                                [&](const lab::Curve& one) { return one.name == label; });
      if (curve == curves.end()) curve = curves.insert(curves.end(), {label, {}, ""});
      curve->points.push_back({cell.axis.value, count, 0});
    }
  }
  std::erase_if(curves, [](const lab::Curve& curve) { return curve.points.size() < 3; });
  if (curves.empty()) return {};
  for (lab::Curve& curve : curves) {
    std::sort(curve.points.begin(), curve.points.end(),
              [](const auto& a, const auto& b) { return a.n < b.n; });
  }
  lab::Figure figure;
  figure.title = kQuadraticTitle;
  figure.caption =
      "Changes of the attribute, or events of the kind that is named, in families whose counts are known "
      "exactly.";
  lab::set_curves(figure, {.x = "n = m", .y = "changes", .slopes = {2}, .title = figure.title}, curves);
  return {figure};
}

}  // namespace kinex::families
