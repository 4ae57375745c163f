// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/extremes/crowds.h"

#include <functional>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

#include "experiments/lab/workload.h"
#include "tests/structures/test_scenes.h"

namespace kinex::extremes {

namespace {

using test::path;
using test::Random;

Rational half(int numerator) { return Rational(Integer(numerator), Integer(2)); }

// Pairs (one at rest at `base`, one that differs from it by `curve`).
void add_pair(std::vector<Trajectory>& paths, int base, std::vector<Rational> curve) {
  paths.push_back(path({{base}}));
  curve[0] += Rational(base);
  paths.push_back(path({std::move(curve)}));
}

Scene pairs(int k) {
  std::vector<Trajectory> paths;
  for (int i = 0; i < k; ++i) add_pair(paths, 2 * k * i, {half(-i - 1), i + 1});
  return test::scene_of(paths, 0, Rational(1));
}

Scene curves(int k) {
  std::vector<Trajectory> paths;
  for (int i = 0; i < k; ++i) {
    const int j = i + 1;
    add_pair(paths, 8 * (k + 4) * i, {-2 * j, 0, j - 2, 0, 1});
  }
  return test::scene_of(paths, -2, Rational(2));
}

// Through the origin; the speeds, 0 .. n - 1, are in no order.
Scene pencil(int n) {
  int step = 7;
  while (n % step == 0) step += 2;
  std::vector<Trajectory> paths;
  for (int i = 0; i < n; ++i) {
    const int speed = static_cast<int>(static_cast<long>(step) * i % n);
    paths.push_back(path({{Rational(Integer(-speed), Integer(3)), speed}}));
  }
  return test::scene_of(paths, 0, Rational(1));
}

// x = i + j (t - 1) / 4, y = j: up to a quarter to either side, so a cell is never far from square.
Scene shear(int m) {
  std::vector<Trajectory> paths;
  for (int j = 0; j < m; ++j) {
    for (int i = 0; i < m; ++i) {
      const Rational slant(Integer(j), Integer(4));
      paths.push_back(path({{Rational(i) - slant, slant}, {j}}));
    }
  }
  return test::scene_of(paths, 0, Rational(2));
}

// Directions at random; all at (3, 5) at t = 1/2.
Scene through(int n) {
  Random random(11);
  std::vector<Trajectory> paths;
  for (int i = 0; i < n; ++i) {
    const int vx = random.between(-1000000, 1000000), vy = random.between(-1000000, 1000000);
    paths.push_back(path({{Rational(3) - half(vx), vx}, {Rational(5) - half(vy), vy}}));
  }
  return test::scene_of(paths, 0, Rational(1));
}

Scene reflection(int n) {
  Random random(12);
  std::vector<Trajectory> paths;
  for (int i = 0; i < n; ++i) {
    const int vy = random.between(-1000, 1000);
    paths.push_back(path({{random.between(0, 1000000)}, {half(-vy), vy}}));
  }
  return test::scene_of(paths, 0, Rational(1));
}

// Objects 2i and 2i + 1 are at one place at t = 1/2, with opposite velocities.
Scene exchange(int n) {
  Random random(13);
  std::vector<Trajectory> paths;
  for (int i = 0; i + 1 < n; i += 2) {
    const int x = random.between(0, 1000000), y = random.between(0, 1000000);
    const int vx = random.between(-300000, 300000), vy = random.between(-300000, 300000);
    for (const int side : {-1, 1}) {
      paths.push_back(path({{Rational(x) - half(side * vx), side * vx},
                            {Rational(y) - half(side * vy), side * vy}}));
    }
  }
  return test::scene_of(paths, 0, Rational(1));
}

// (i, j) + (t - 1)^2 v for random v.
Scene touching_lattice(int m) {
  Random random(14);
  std::vector<Trajectory> paths;
  for (int j = 0; j < m; ++j) {
    for (int i = 0; i < m; ++i) {
      const Rational vx(Integer(random.between(-300, 300)), Integer(1009));
      const Rational vy(Integer(random.between(-300, 300)), Integer(1009));
      paths.push_back(path(
          {{Rational(i) + vx, Rational(-2) * vx, vx}, {Rational(j) + vy, Rational(-2) * vy, vy}}));
    }
  }
  return test::scene_of(paths, 0, Rational(2));
}

}  // namespace

Scene make_crowd(const std::string& description) {
  static const std::map<std::string, std::function<Scene(int)>> kFamilies{
      {"pairs k", pairs},       {"curves k", curves},
      {"pencil n", pencil},     {"shear m", shear},
      {"through n", through},   {"reflection n", reflection},
      {"exchange n", exchange}, {"touching-lattice m", touching_lattice}};
  const std::size_t equals = description.find('=');
  const std::string family = description.substr(0, equals);
  if (equals == std::string::npos) throw std::runtime_error("no size in " + description);
  const int size = std::stoi(description.substr(equals + 1));
  Scene scene;
  if (const auto found = kFamilies.find(family); found != kFamilies.end()) {
    scene = found->second(size);
    const std::string structure = scene.dimension == 1 ? "sorted_list" : "delaunay_2";
    scene.maintain.push_back({structure, structure, {}});
  } else {
    const lab::Workload* workload = lab::find_workload(family.substr(0, family.find(' ')));
    if (workload == nullptr) throw std::runtime_error("no family of " + description);
    lab::WorkloadParameters parameters;
    parameters.n = size;
    scene = lab::generate_scene(*workload, parameters);
  }
  scene.name = description;
  return scene;
}

}  // namespace kinex::extremes
