// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/scene.h"

#include <algorithm>

namespace kinex {

int Scene::degree() const {
  int degree = 0;
  for (const SceneObject& object : objects) degree = std::max(degree, object.motion.degree());
  return degree;
}

int Scene::degree_without_weights() const {
  const int axes = axes_without_weights();
  int degree = 0;
  for (const SceneObject& object : objects) {
    for (const MotionPiece& piece : object.motion.pieces) {
      degree = std::max(degree, piece.trajectory.degree_of_axes(0, axes));
    }
  }
  return degree;
}

bool Scene::has_lines() const {
  return std::any_of(objects.begin(), objects.end(),
                     [](const SceneObject& object) { return object.line; });
}

std::vector<bool> Scene::members(const Subset& subset) const {
  if (subset.kind == Subset::Kind::kAll) return {};
  std::vector<bool> result(objects.size(), subset.kind == Subset::Kind::kAllBut);
  if (subset.kind == Subset::Kind::kColours) {
    const std::vector<std::string>& colours = subset.colours;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      result[i] = std::find(colours.begin(), colours.end(), objects[i].colour) != colours.end();
    }
  } else {
    for (const ObjectId object : subset.objects) result[object] = !result[object];
  }
  return result;
}

}  // namespace kinex
