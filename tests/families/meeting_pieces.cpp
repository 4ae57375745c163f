// SPDX-License-Identifier: GPL-3.0-or-later
// Flight plans whose pieces meet where events are: points and bodies on a lattice that change their
// velocities at integer times, at which they stand on each other, in lines, on circles or side by
// side. Some jump, some are away for a while.
#include <algorithm>
#include <array>

#include "tests/families/check_scene.h"
#include "tests/families/lattice_bodies.h"
#include "tests/families/scene_text.h"

namespace kinex::families {
namespace {

// Lattice positions at the integer times 0 .. kEnd; straight in between.
constexpr int kEnd = 3;

struct Walk {
  std::array<std::array<int, 2>, kEnd + 1> at{};
};

Walk random_walk(Random& random, int size) {
  Walk walk;
  for (int axis = 0; axis < 2; ++axis) {
    int x = random.between(0, size);
    for (int t = 0; t <= kEnd; ++t) {
      walk.at[static_cast<std::size_t>(t)][static_cast<std::size_t>(axis)] = x;
      x = std::clamp(x + random.between(-1, 1), 0, size);
    }
  }
  return walk;
}

// The piece on [t, t + 1]: (p - v t) + v t.
PieceText step(const Walk& walk, int t, int dimension, int unit) {
  PieceText piece;
  piece.from = std::to_string(t);
  piece.to = std::to_string(t + 1);
  for (int axis = 0; axis < dimension; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const int p = walk.at[static_cast<std::size_t>(t)][a];
    const int v = walk.at[static_cast<std::size_t>(t) + 1][a] - p;
    piece.coordinates.push_back({std::to_string(unit * (p - v * t)), std::to_string(unit * v)});
  }
  return piece;
}

}  // namespace

void meeting_pieces(std::uint64_t seed, Tally& tally) {
  Random random(seed);
  const bool bodies = random.chance(30);
  const int dimension = bodies || random.chance(80) ? 2 : 1;
  const int n = random.between(2, bodies ? 3 : 6);
  const bool jumps = random.chance(10);
  std::vector<ObjectText> objects;
  for (int i = 0; i < n; ++i) {
    ObjectText object;
    const Walk walk = random_walk(random, bodies ? 3 : 2);
    const int away = random.chance(20) ? random.between(0, kEnd - 1) : -1;
    for (int t = 0; t < kEnd; ++t) {
      if (t == away) continue;
      object.pieces.push_back(step(walk, t, dimension, bodies ? 2 : 1));
      if (jumps && random.chance(30)) object.pieces.back().coordinates[0][0] = "1";
    }
    if (bodies) object.polygon = lattice_polygon(random);
    objects.push_back(std::move(object));
  }
  const std::string more = jumps ? "\"jumps\": true," : "";
  check_scene(scene_text(dimension, "0", std::to_string(kEnd), objects, more), {}, tally);
}

}  // namespace kinex::families
