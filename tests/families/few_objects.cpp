// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes of 0 to 3 objects, points or bodies, which come and go; small integers, so that ties and
// degenerate starts are frequent.
#include "tests/families/check_scene.h"
#include "tests/families/lattice_bodies.h"
#include "tests/families/scene_text.h"

namespace kinex::families {
namespace {

// Objects that exist on [from, to), either of which may be the scene's end.
PieceText life(Random& random) {
  PieceText piece;
  if (random.chance(25)) piece.from = std::to_string(random.between(0, 2));
  if (random.chance(25)) piece.to = std::to_string(random.between(3, 4));
  return piece;
}

}  // namespace

void few_objects(std::uint64_t seed, Tally& tally) {
  Random random(seed);
  const bool bodies = random.chance(30);
  const int dimension = bodies ? 2 : random.between(1, 3);
  const int n = random.between(0, 3);
  const int degree = random.between(0, bodies ? 1 : 3);
  std::vector<ObjectText> objects;
  for (int i = 0; i < n; ++i) {
    ObjectText object;
    PieceText piece = life(random);
    for (int axis = 0; axis < dimension; ++axis) {
      Coefficients& list = piece.coordinates.emplace_back();
      for (int k = 0; k <= degree; ++k) list.push_back(std::to_string(random.between(-2, 2)));
    }
    if (bodies) {
      list_scale(piece.coordinates, 3);
      object.polygon = lattice_polygon(random);
      if (random.chance(50)) piece.rotor = lattice_rotor(random);
    }
    object.pieces.push_back(std::move(piece));
    objects.push_back(std::move(object));
  }
  const std::string end = random.chance(80) ? "4" : "";
  check_scene(scene_text(dimension, "0", end, objects), {}, tally);
}

}  // namespace kinex::families
