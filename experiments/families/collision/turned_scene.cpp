// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/collision/turned_scene.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace kinex::families {
namespace {

struct Turn {
  Rational cos, sin;
};

// u = tan(angle / 2) is k + 1 in binary, mirrored at the point: 1/2, 1/4, 3/4, 1/8, ..
Turn turn_of(int k) {
  Rational u, place = 1;
  for (int rest = k + 1; rest > 0; rest /= 2) {
    place /= Rational(2);
    if (rest % 2 != 0) u += place;
  }
  const Rational scale = Rational(1) / (Rational(1) + u * u);
  return {scale * (Rational(1) - u * u), scale * Rational(2) * u};
}

void turn(const Turn& by, Rational& x, Rational& y) {
  Rational turned = by.cos * x - by.sin * y;
  y = by.sin * x + by.cos * y;
  x = std::move(turned);
}

}  // namespace

void turn_scene(Scene& scene, int k) {
  const Turn by = turn_of(k);
  for (SceneObject& object : scene.objects) {
    for (Vertex2& vertex : object.polygon) turn(by, vertex[0], vertex[1]);
    for (MotionPiece& piece : object.motion.pieces) {
      std::vector<Rational>& x = piece.trajectory.coordinates[0];
      std::vector<Rational>& y = piece.trajectory.coordinates[1];
      const std::size_t terms = std::max(x.size(), y.size());
      x.resize(terms);
      y.resize(terms);
      for (std::size_t i = 0; i < terms; ++i) turn(by, x[i], y[i]);
      piece.trajectory.normalise();
    }
  }
}

}  // namespace kinex::families
