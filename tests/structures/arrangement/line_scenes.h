// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes of lines y = a x + b, and of lines and points.
#ifndef KINEX_TESTS_STRUCTURES_ARRANGEMENT_LINE_SCENES_H
#define KINEX_TESTS_STRUCTURES_ARRANGEMENT_LINE_SCENES_H

#include <cstdint>
#include <utility>
#include <vector>

#include "tests/structures/proximity/reference_scenes.h"
#include "tests/structures/proximity/twin_run.h"

namespace kinex::test {

// The objects of the scene as lines: all of them, or every second one.
inline Scene lined(Scene scene, LineUse lines) {
  with_lines(scene, lines);
  return scene;
}

// S(n, 2, seed), with (a, b) in the place of (x, y).
inline Scene line_reference(int n, std::uint64_t seed, LineUse lines) {
  return lined(reference_scene(n, 2, seed), lines);
}

// Lines y = t x - j, j = 1 .. m, and points (t, i / (n + 1)), i < n: each point is on each line twice.
inline Scene points_through_lines(int n, int m) {
  std::vector<Trajectory> t;
  for (int j = 1; j <= m; ++j) t.push_back(path({{0, 1}, {-j}}));
  for (int i = 0; i < n; ++i) t.push_back(path({{0, 1}, {Rational(Integer(i), Integer(n + 1))}}));
  Scene scene = scene_of(t, -m - 1, Rational(m + 1));
  for (int j = 0; j < m; ++j) scene.objects[static_cast<std::size_t>(j)].line = true;
  return scene;
}

}  // namespace kinex::test

#endif
