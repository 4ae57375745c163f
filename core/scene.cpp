// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene.h"

#include <algorithm>

namespace kinex {

int Scene::degree() const {
  int degree = 0;
  for (const SceneObject& object : objects) degree = std::max(degree, object.motion.degree());
  return degree;
}

}  // namespace kinex
