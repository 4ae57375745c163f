// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/scene.h"

#include <algorithm>

namespace kinex {

int Scene::degree() const {
  int degree = 0;
  for (const SceneObject& object : objects) degree = std::max(degree, object.motion.degree());
  return degree;
}

bool Scene::has_weights() const {
  return std::any_of(objects.begin(), objects.end(),
                     [](const SceneObject& object) { return object.weight.has_value(); });
}

Trajectory Scene::weighted(ObjectId object, const Trajectory& motion) const {
  Trajectory result = motion;
  const std::optional<Rational>& weight = objects[object].weight;
  if (weight) result.coordinates.push_back({*weight});
  return result;
}

}  // namespace kinex
