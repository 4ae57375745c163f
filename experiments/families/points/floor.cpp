// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/points/floor.h"

#include <algorithm>

namespace kinex::families::floors {

bool is_plain(const Scene& scene) {
  if (scene.has_bodies() || scene.objects.size() < 3 || !scene.end) return false;
  if (scene.degree() < 1 || scene.degree() > 3) return false;
  return std::all_of(scene.objects.begin(), scene.objects.end(),
                     [](const SceneObject& o) { return o.motion.pieces.size() == 1; });
}

}  // namespace kinex::families::floors
