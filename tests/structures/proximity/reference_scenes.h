// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes for all proximity structures: pseudorandom ones of small integers, whose counts were found
// by brute force in exact arithmetic, and tiny lattices, full of degenerate instants.
#ifndef KINEX_TESTS_STRUCTURES_PROXIMITY_REFERENCE_SCENES_H
#define KINEX_TESTS_STRUCTURES_PROXIMITY_REFERENCE_SCENES_H

#include <cstdint>
#include <utility>
#include <vector>

#include "tests/structures/test_scenes.h"

namespace kinex::test {

// s := (1103515245 s + 12345) mod 2^31; the result is s / 2^16, rounded down.
class ReferenceNumbers {
 public:
  explicit ReferenceNumbers(std::uint64_t seed) : state_(seed) {}
  int next() {
    state_ = (1103515245 * state_ + 12345) % (std::uint64_t{1} << 31);
    return static_cast<int>(state_ >> 16);
  }

 private:
  std::uint64_t state_;
};

// S(n, d, seed): positions in 0 .. 99, velocities in -20 .. 20, 0 < t < 10.
inline Scene reference_scene(int n, int dimension, std::uint64_t seed) {
  ReferenceNumbers numbers(seed);
  std::vector<Trajectory> t;
  for (int i = 0; i < n; ++i) {
    std::vector<std::vector<Rational>> axes;
    for (int axis = 0; axis < dimension; ++axis) {
      const int position = numbers.next() % 100, velocity = numbers.next() % 41 - 20;
      axes.push_back({position, velocity});
    }
    t.push_back(path(std::move(axes)));
  }
  return scene_of(t, 0, Rational(10));
}

// n points of {0, 1, 2}^d, velocities in {-1, 0, 1}^d, -3 < t < 3.
inline Scene lattice_scene(std::uint64_t seed, int n, int dimension) {
  Random random(seed);
  std::vector<Trajectory> t;
  for (int i = 0; i < n; ++i) {
    std::vector<std::vector<Rational>> axes;
    for (int axis = 0; axis < dimension; ++axis) {
      axes.push_back({random.between(0, 2), random.between(-1, 1)});
    }
    t.push_back(path(std::move(axes)));
  }
  return scene_of(t, -3, Rational(3));
}

}  // namespace kinex::test

#endif
