// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/curves.h"
#include "experiments/peers/tables.h"

namespace kinex::peers {

lab::Figure figure_of(const std::string& title, const std::string& caption,
                      const std::string& x_label, const std::string& y_label,
                      const std::vector<PeerCurve>& curves, bool log_y) {
  lab::Figure figure;
  figure.title = title;
  figure.caption = caption;
  std::vector<lab::Curve> drawn;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (curves[i].points.empty()) continue;
    lab::Curve curve{curves[i].name, {}, ""};
    curve.look = i;
    for (const auto& [x, y] : curves[i].points) curve.points.push_back({x, y, 0});
    drawn.push_back(std::move(curve));
  }
  lab::set_curves(figure, {x_label, y_label, true, log_y, {}}, drawn);
  return figure;
}

}  // namespace kinex::peers
