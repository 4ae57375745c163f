// SPDX-License-Identifier: GPL-3.0-or-later
// The scenes that metamorphic tests start from, and all images of one.
#ifndef KINEX_TESTS_STRUCTURES_METAMORPHIC_SCENES_H
#define KINEX_TESTS_STRUCTURES_METAMORPHIC_SCENES_H

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "tests/structures/metamorphic.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {

// A permutation; requires that 5 does not divide n.
inline std::vector<ObjectId> shuffled(std::size_t n) {
  std::vector<ObjectId> name;
  for (std::size_t i = 0; i < n; ++i) name.push_back(static_cast<ObjectId>((5 * i + 2) % n));
  return name;
}

inline Rational fraction(int p, int q) { return Rational(Integer(p), Integer(q)); }

inline std::vector<Image> images_of(const Scene& scene, const Key& key, bool mirror) {
  std::vector<Image> images{
      in_time(scene, key, -1, 0),
      in_time(scene, key, fraction(5, 3), fraction(-7, 2)),
      in_time(scene, key, fraction(-2, 7), fraction(1, 5)),
      scaled(scene, key, fraction(22, 7)),
      carried(scene, key, path({{1000, fraction(-17, 3)}, {-3, fraction(2, 9)}})),
      carried(scene, key, path({{0, 1, 0, fraction(-9, 7)}, {fraction(1, 3), 0, 5}})),
      permuted(scene, key, shuffled(scene.objects.size()))};
  if (mirror) {
    images.push_back(mirrored(scene, key, 0));
    images.push_back(mirrored(scene, key, 1));
    images.push_back(scaled(scene, key, -1));
  }
  if (key.kind != Key::Kind::kCoordinate) images.push_back(turned(scene, key));
  return images;
}

inline std::vector<Key> keys() {
  Key x, along, distance;
  along.kind = Key::Kind::kDirection;
  along.direction = {2, fraction(-1, 3)};
  distance.kind = Key::Kind::kSquaredDistance;
  distance.object = 1;
  return {x, along, distance};
}

// Coefficients are k / 1000 with |k| <= 3000: no ties, no two events at once (to be expected).
inline Trajectory wild_path(Random& random, int degree) {
  Trajectory result = random.small_path(2, degree, 3000);
  for (auto& axis : result.coordinates) {
    for (Rational& c : axis) c *= fraction(1, 1000);
  }
  return result;
}

inline Scene wild_scene(std::uint64_t seed, int n, int degree) {
  Random random(seed);
  std::vector<Trajectory> paths;
  for (int i = 0; i < n; ++i) paths.push_back(wild_path(random, degree));
  return scene_of(paths, fraction(-5, 7), fraction(8, 9));
}

// New motions at rational times, joined without jumps; some objects come late or leave early, but
// not object 1, which distances are measured to.
inline Scene wild_flights(std::uint64_t seed, int n, int degree) {
  Random random(seed);
  Scene scene = wild_scene(seed, n, degree);
  for (int i = 0; i < n; ++i) {
    auto& pieces = scene.objects[static_cast<std::size_t>(i)].motion.pieces;
    const Rational cut = fraction(random.between(-40, 60), 97);
    Trajectory next = continued(pieces[0].trajectory, wild_path(random, degree), cut);
    pieces[0].to = cut;
    pieces.push_back({cut, std::nullopt, std::move(next)});
    if (i != 1 && i % 3 == 0) pieces[0].from = fraction(random.between(-60, -45), 97);
    if (i != 1 && i % 4 == 0) pieces[1].to = fraction(random.between(61, 80), 97);
  }
  return scene;
}

// ---- many events at one instant, but no identical ties

// All in one place at t = 1/2, some turning back there.
inline Scene through_one_point(std::uint64_t seed, int n, int degree) {
  Random random(seed);
  std::vector<Trajectory> paths;
  for (int i = 0; i < n; ++i) {
    Trajectory p = random.small_path(2, degree, 300);
    for (auto& axis : p.coordinates) {
      axis[0] = fraction(1, 7);
      if (i % 4 == 3 && degree > 1) axis[1] = 0;  // touches only
      axis = composed(axis, 1, fraction(-1, 2));  // in powers of t - 1/2
    }
    paths.push_back(std::move(p));
  }
  return scene_of(paths, fraction(-1, 3), fraction(9, 7));
}

// On an integer lattice at t = 1, with different velocities.
inline Scene through_a_lattice(std::uint64_t seed, int side, int degree) {
  Random random(seed);
  std::vector<Trajectory> paths;
  for (int i = 0; i < side * side; ++i) {
    Trajectory p = random.small_path(2, degree, 300);
    p.coordinates[0][0] = i % side;
    p.coordinates[1][0] = i / side;
    for (auto& axis : p.coordinates) {
      for (std::size_t k = 1; k < axis.size(); ++k) axis[k] *= fraction(1, 100);
      axis = composed(axis, 1, -1);
    }
    paths.push_back(std::move(p));
  }
  return scene_of(paths, fraction(2, 3), fraction(11, 7));
}

}  // namespace kinex::test

#endif
