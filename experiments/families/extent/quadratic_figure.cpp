// SPDX-License-Identifier: GPL-3.0-or-later
// The counts of families with n = m, over n: they grow like n^2. A panel for each family.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "experiments/families/extent/quadratic_families.h"
#include "experiments/lab/curves.h"

namespace kinex::families {

namespace {

struct Panel {
  std::string family;
  std::vector<lab::Curve> curves;
};

std::vector<Panel> panels_of(const std::vector<lab::CellResult>& cells) {
  std::vector<Panel> panels;
  for (const lab::CellResult& result : cells) {
    const lab::Cell& cell = result.cell;
    if (cell.axis.name != kBothSizes || result.trials.empty()) continue;
    auto panel = std::find_if(panels.begin(), panels.end(),
                              [&](const Panel& one) { return one.family == cell.family; });
    if (panel == panels.end()) panel = panels.insert(panels.end(), {cell.family, {}});
    std::vector<lab::Curve>& curves = panel->curves;
    for (const lab::Expectation& expectation : cell.expectations) {
      const double count = lab::mean_of(result.trials, expectation.quantity).mean();
      if (!(count > 2)) continue;  // a constant, or nearly none
      std::string label = cell.structure;
      if (expectation.quantity.starts_with("kind.")) label += ": " + expectation.quantity.substr(5);
      auto curve = std::find_if(curves.begin(), curves.end(),
                                [&](const lab::Curve& one) { return one.name == label; });
      if (curve == curves.end()) curve = curves.insert(curves.end(), {label, {}, ""});
      curve->points.push_back({cell.axis.value, count, 0});
    }
  }
  for (Panel& panel : panels) {
    std::erase_if(panel.curves, [](const lab::Curve& curve) { return curve.points.size() < 3; });
    for (lab::Curve& curve : panel.curves) {
      std::sort(curve.points.begin(), curve.points.end(),
                [](const auto& a, const auto& b) { return a.n < b.n; });
    }
  }
  std::erase_if(panels, [](const Panel& panel) { return panel.curves.empty(); });
  return panels;
}

}  // namespace

std::vector<lab::Figure> quadratic_figures(const std::vector<lab::CellResult>& cells) {
  std::vector<lab::Figure> figures;
  for (const Panel& panel : panels_of(cells)) {
    lab::Figure figure;
    figure.title = kQuadraticTitle;
    figure.caption =
        "Changes of the attribute, or events of the kind that is named, in families whose counts "
        "are "
        "known exactly. Structures with the same counts are drawn over one another, the first one "
        "widest.";
    figure.width = 440;
    figure.joins = !figures.empty();
    lab::set_curves(figure, {.x = "n = m", .y = "changes", .slopes = {2}, .title = panel.family},
                    panel.curves);
    figures.push_back(std::move(figure));
  }
  return figures;
}

}  // namespace kinex::families
