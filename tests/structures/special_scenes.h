// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes that every structure for points of the plane should pass: numbers beyond doubles, points
// that come one by one and go one by one, points that jump, all points on one line for an instant.
#ifndef KINEX_TESTS_STRUCTURES_SPECIAL_SCENES_H
#define KINEX_TESTS_STRUCTURES_SPECIAL_SCENES_H

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "tests/structures/test_scenes.h"

namespace kinex::test {

// Units in which coordinates, or their products, are too large or too small for doubles.
inline constexpr std::array<const char*, 4> kExtremeUnits{"1e150", "1e-150", "1e400", "1e-400"};

// The scene R(n) of small remainders, 0 < t < end: x = (37 i^2 + 11 i mod 101) + t ((17 i^2 + 5 i + 3
// mod 21) - 10), y = (53 i^2 + 29 i + 7 mod 103) + t ((19 i^2 + 7 i + 1 mod 23) - 11).
inline Scene remainders(int n, int end = 12) {
  std::vector<Trajectory> t;
  for (int i = 0; i < n; ++i) {
    t.push_back(path({{(37 * i * i + 11 * i) % 101, (17 * i * i + 5 * i + 3) % 21 - 10},
                      {(53 * i * i + 29 * i + 7) % 103, (19 * i * i + 7 * i + 1) % 23 - 11}}));
  }
  return scene_of(t, 0, Rational(end));
}

// n points whose coordinates and velocities are small multiples of the unit, 0 < t < 9.
inline Scene in_units_of(const char* size, int n = 7) {
  const Rational unit = *Rational::parse(size);
  std::vector<Trajectory> t;
  for (int i = 0; i < n; ++i) {
    t.push_back(path({{unit * Rational((i * 5) % 7), unit * Rational(3 - i)},
                      {unit * Rational((i * 3) % 7), unit * Rational((i * i) % 5)}}));
  }
  return scene_of(t, 0, Rational(9));
}

// From `at` on the object is on `to`, where it was not before. Requires a motion of one piece.
inline void jump(Scene& scene, ObjectId object, const Rational& at, Trajectory to) {
  auto& pieces = scene.objects[object].motion.pieces;
  const auto end = pieces[0].to;
  pieces[0].to = at;
  pieces.push_back({at, end, std::move(to)});
}

// Four points at rest; at 1 the third one jumps from (9, 3) to this place. 0 < t < 4.
inline Scene one_jumps(int x, int y) {
  Scene scene = scene_of({path({{0}, {0}}), path({{4}, {1}}), path({{9}, {3}}), path({{2}, {8}})},
                         0, Rational(4));
  jump(scene, 2, 1, path({{x}, {y}}));
  return scene;
}

// Seven points that come one by one and leave one by one: before 1 and after 19 there is none.
inline Scene from_nothing_to_nothing() {
  std::vector<Trajectory> t;
  for (int i = 0; i < 7; ++i) t.push_back(path({{(i * 3) % 7, i - 3}, {(i * 5) % 7, 1}}));
  Scene scene = scene_of(t, 0, Rational(20));
  for (int i = 0; i < 7; ++i) {
    MotionPiece& piece = scene.objects[static_cast<std::size_t>(i)].motion.pieces[0];
    piece.from = Rational(i + 1);
    piece.to = Rational(19 - 2 * ((i * 4) % 7));
  }
  return scene;
}

// n points that are on one line at t = 0 and pass through it, within `reach` of each other then.
inline Scene on_a_line_for_an_instant(std::uint64_t seed, int n, int reach) {
  Random random(seed);
  std::vector<Trajectory> t;
  for (int i = 0; i < n; ++i) {
    const int slope = random.between(-9, 9);
    t.push_back(path({{random.between(-reach, reach), random.between(-9, 9)}, {0, slope}}));
  }
  return scene_of(t, -1, Rational(1));
}

}  // namespace kinex::test

#endif
