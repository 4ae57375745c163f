// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/points/lines.h"

#include <stdexcept>
#include <utility>

namespace kinex::families {

std::vector<Line> lines_of(const Scene& scene, bool negated) {
  std::vector<Line> lines;
  for (const SceneObject& object : scene.objects) {
    if (object.motion.pieces.size() != 1) throw std::invalid_argument("more than one piece");
    const std::vector<Rational>& x = object.motion.pieces.front().trajectory.coordinates.at(0);
    if (x.size() > 2) throw std::invalid_argument("not linear");
    Line line;
    if (x.size() > 1) line.slope = x[1];
    line.value = (x.empty() ? Rational(0) : x[0]) + line.slope * scene.start;
    if (negated) {
      line.value = -line.value;
      line.slope = -line.slope;
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace kinex::families
