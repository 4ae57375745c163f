// SPDX-License-Identifier: GPL-3.0-or-later
// Generic scenes, every structure under every arithmetic: with numbers of 20 bits the instants of a
// few objects are far apart, so 200 bits are enough for the events of `exact`.
#include "tests/families/check_scene.h"
#include "tests/families/scene_text.h"

namespace kinex::families {
namespace {

std::string fraction(Random& random, int limit) {
  return std::to_string(random.between(-limit, limit)) + "/" +
         std::to_string(random.between(500000, 1000000));
}

// Convex, and no two sides are parallel.
const std::vector<Coefficients>& polygon() {
  static const std::vector<Coefficients> kPolygon{
      {"-1", "-9/10"}, {"1", "-11/10"}, {"9/10", "7/10"}, {"-1", "13/10"}};
  return kPolygon;
}

}  // namespace

void every_arithmetic(std::uint64_t seed, Tally& tally) {
  Random random(seed);
  const bool bodies = random.chance(25);
  const int dimension = bodies ? 2 : random.between(1, 3);
  const int degree = random.between(1, bodies ? 1 : 3);
  // Three points alone are collinear with three certificates at one instant.
  const int n = bodies ? random.between(2, 3) : random.between(4, degree == 3 ? 4 : 6);
  std::vector<ObjectText> objects;
  for (int i = 0; i < n; ++i) {
    ObjectText object;
    PieceText piece;
    for (int axis = 0; axis < dimension; ++axis) {
      Coefficients& list = piece.coordinates.emplace_back();
      for (int k = 0; k <= degree; ++k) {
        list.push_back(fraction(random, bodies && k == 0 ? 6000000 : 3000000));
      }
    }
    if (bodies) {
      object.polygon = polygon();
      piece.rotor = {{"1"}, {fraction(random, 500000), fraction(random, 500000)}};
    }
    object.pieces.push_back(std::move(piece));
    objects.push_back(std::move(object));
  }
  SceneCheck what;
  what.arithmetics = {"sturm", "double", "gsl", "mpfr:24"};
  what.faithful = {"mpfr:200"};
  check_scene(scene_text(dimension, "0", "2", objects), what, tally);
}

}  // namespace kinex::families
