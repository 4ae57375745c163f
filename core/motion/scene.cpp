// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/scene.h"

#include <algorithm>

#include "core/motion/derived_objects.h"

namespace kinex {

int Scene::degree() const {
  int degree = 0;
  for (const SceneObject& object : objects) degree = std::max(degree, object.motion.degree());
  return degree;
}

int Scene::held_axes() const { return has_bodies() ? kMostDerivedAxes : dimension; }

// The position of one body as seen from another, with the denominators of both rotations cleared,
// has the degree of the positions plus twice that of both rotors.
int Scene::held_degree() const {
  if (!has_bodies()) return degree();
  int centre = 0, first = 0, second = 0;  // the two largest degrees of rotors
  for (const SceneObject& object : objects) {
    int rotor = 0;
    for (const MotionPiece& piece : object.motion.pieces) {
      centre = std::max(centre, piece.trajectory.degree_of_axes(0, 2));
      rotor = std::max(rotor, piece.trajectory.degree_of_axes(2, kBodyAxes));
    }
    second = std::max(second, std::min(first, rotor));
    first = std::max(first, rotor);
  }
  return centre + 2 * (first + second);
}

}  // namespace kinex
