// SPDX-License-Identifier: GPL-3.0-or-later
// A scene in the plane made of bodies.
#ifndef KINEX_TESTS_STRUCTURES_COLLISION_SCENE_OF_BODIES_H
#define KINEX_TESTS_STRUCTURES_COLLISION_SCENE_OF_BODIES_H

#include <optional>
#include <utility>
#include <vector>

#include "core/motion/scene.h"

namespace kinex::test {

// The scene "bodies" of two dimensions, from `start` to `end` (nullopt: without end).
inline Scene scene_of_bodies(std::vector<SceneObject> bodies, Rational start,
                             std::optional<Rational> end) {
  Scene scene;
  scene.name = "bodies";
  scene.dimension = 2;
  scene.start = std::move(start);
  scene.end = std::move(end);
  scene.objects = std::move(bodies);
  return scene;
}

}  // namespace kinex::test

#endif
