// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes of discs and boxes for the tests of box_pairs and disc_pairs_...
#ifndef KINEX_TESTS_STRUCTURES_PROXIMITY_MEETINGS_SUPPORT_H
#define KINEX_TESTS_STRUCTURES_PROXIMITY_MEETINGS_SUPPORT_H

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tests/structures/proximity/reference_scenes.h"
#include "tests/structures/proximity/twin_run.h"

namespace kinex::test {

inline const std::vector<Extents> kBothExtents{Extents::kRadius, Extents::kHalfExtents};

// All structures for the scene's pairs that report the same events.
inline std::vector<Request> meetings_in(const Scene& scene) {
  if (scene.extents == Extents::kHalfExtents) return {ask("box_pairs")};
  std::vector<Request> requests{ask("disc_pairs_all"), ask("disc_pairs_boxes")};
  if (scene.end) requests.push_back(ask("disc_pairs_grid"));
  if (scene.dimension == 1) requests.push_back(ask("box_pairs"));  // intervals are both
  return requests;
}

// Objects of these paths, whose last axes are extents.
inline Scene extended_scene(const std::vector<Trajectory>& paths, Extents extents, Rational start,
                            Rational end) {
  Scene scene = scene_of(paths, std::move(start), std::move(end));
  scene.extents = extents;
  const int axes = paths.front().dimension();
  scene.dimension = extents == Extents::kRadius ? axes - 1 : axes / 2;
  return scene;
}

// S(n, d, seed) with the extra draws 1 + next() mod 12, a radius or one half extent an axis.
inline Scene extended_reference(int n, int dimension, std::uint64_t seed, Extents extents) {
  ReferenceNumbers numbers(seed);
  std::vector<Trajectory> t;
  for (int i = 0; i < n; ++i) {
    std::vector<std::vector<Rational>> axes;
    for (int axis = 0; axis < dimension; ++axis) {
      const int position = numbers.next() % 100, velocity = numbers.next() % 41 - 20;
      axes.push_back({position, velocity});
    }
    const int more = extents == Extents::kRadius ? 1 : dimension;
    for (int axis = 0; axis < more; ++axis) axes.push_back({1 + numbers.next() % 12});
    t.push_back(path(std::move(axes)));
  }
  return extended_scene(t, extents, 0, Rational(10));
}

// As lattice_scene; extents 0, 1/2 or 1, a third of them growing or shrinking by 1/8.
inline Scene extended_lattice(std::uint64_t seed, int n, int dimension, Extents extents) {
  Scene scene = lattice_scene(seed, n, dimension);
  Random random(seed + 1000);
  scene.extents = extents;
  for (SceneObject& object : scene.objects) {
    auto& axes = object.motion.pieces[0].trajectory.coordinates;
    for (int axis = 0; axis < scene.extent_axes(); ++axis) {
      const int size = random.between(0, 2), grows = random.between(-1, 1);
      std::vector<Rational> extent{Rational(Integer(size), Integer(2))};
      if (size > 0 && random.chance(33)) extent.emplace_back(Integer(grows), Integer(8));
      axes.push_back(std::move(extent));
    }
  }
  for (SceneObject& object : scene.objects) object.motion.pieces[0].trajectory.normalise();
  return scene;
}

// p_i = (i t, i^2 t, ..), extents 1/2, -2 < t < 2: each two meet and part once.
inline Scene fan(int n, int dimension, Extents extents) {
  std::vector<Trajectory> t;
  for (int i = 0; i < n; ++i) {
    std::vector<std::vector<Rational>> axes;
    int speed = 1;
    for (int axis = 0; axis < dimension; ++axis) axes.push_back({0, speed *= i});
    const Rational half(Integer(1), Integer(2));
    for (int axis = 0; axis < (extents == Extents::kRadius ? 1 : dimension); ++axis) {
      axes.push_back({half});
    }
    t.push_back(path(std::move(axes)));
  }
  return extended_scene(t, extents, -2, Rational(2));
}

// Flights with extents: constants, and in every third object some that grow.
inline Scene extended_flights(std::uint64_t seed, int n, int dimension, int degree, bool lives,
                              Extents extents, PlanInstants instants = PlanInstants::kQuarters) {
  Scene scene = random_flights(seed, n, dimension, degree, lives, instants);
  Random random(seed + 77);
  scene.extents = extents;
  for (SceneObject& object : scene.objects) {
    for (int axis = 0; axis < scene.extent_axes(); ++axis) {
      std::vector<Rational> extent{Rational(Integer(random.between(0, 4)), Integer(2))};
      if (random.chance(33)) extent.emplace_back(Integer(random.between(1, 3)), Integer(4));
      for (MotionPiece& piece : object.motion.pieces) {
        piece.trajectory.coordinates.push_back(extent);
      }
    }
  }
  return scene;
}

}  // namespace kinex::test

#endif
