// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/arrangement/line_bounds.h"

namespace kinex {

std::vector<bool> lines_of(const Scene& scene) {
  std::vector<bool> result;
  for (const SceneObject& object : scene.objects) result.push_back(object.line);
  return result;
}

LinesAndPoints::LinesAndPoints(const BoundContext& context, const std::vector<bool>& is_line) {
  for (std::size_t i = 0; i < context.pieces.size(); ++i) {
    const std::size_t object = context.members.empty() ? i : context.members[i];
    (is_line[object] ? lines : points).push_back(context.pieces[i]);
  }
}

// Of all pairs, those of two lines and of two points are too many.
Integer side_changes(const LinesAndPoints& both, int degree) {
  std::vector<int> all = both.lines;
  all.insert(all.end(), both.points.begin(), both.points.end());
  return pair_sign_changes(all, degree) - pair_sign_changes(both.lines, degree) -
         pair_sign_changes(both.points, degree);
}

}  // namespace kinex
