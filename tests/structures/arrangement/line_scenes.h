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

// y = i, y = (x - k j) / 2 and y = x + k^2 q - t for i, j, q < k: three of them, one of each kind, meet
// at t = i + k j + k^2 q, at which no other three do.
inline Scene three_bundles(int k) {
  const Rational half(Integer(1), Integer(2));
  std::vector<Trajectory> t;
  for (int i = 0; i < k; ++i) t.push_back(path({{0}, {i}}));
  for (int j = 0; j < k; ++j) t.push_back(path({{half}, {Rational(-k * j) * half}}));
  for (int q = 0; q < k; ++q) t.push_back(path({{1}, {k * k * q, -1}}));
  return lined(scene_of(t, -half, Rational(k * k * k) - half), LineUse::kAlone);
}

// y = (i^2 + i t) x + i + i^2 t, 1 <= i <= n: as a point (a, b) it is a matrix of determinant t^2 - 1 times
// (i, i^2), so all triples turn over at t = -1 and at t = 1; the slopes of i and j are equal at
// t = -(i + j).
inline Scene most_crossings(int n) {
  std::vector<Trajectory> t;
  for (int i = 1; i <= n; ++i) t.push_back(path({{i * i, i}, {i, i * i}}));
  return lined(scene_of(t, -2 * n, 2), LineUse::kAlone);
}

}  // namespace kinex::test

#endif
