// SPDX-License-Identifier: GPL-3.0-or-later
// Points of the plane with weights: scenes in which a known number of points show and hide, small
// integers for counts that another program can repeat, and random motion.
#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "experiments/families/triangulation/experiments.h"
#include "experiments/lab/grid_root.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

using lab::fraction;

// Heavy points A_j = (2j, 1) and B_j = (2j + 1, -1), j < m, of weight 3/2 - eps^2, eps = 1/(8n), and n
// light ones of weight 0, p_i = (1/2 + (2i + 1)/(4n) + t, 0); 0 <= t <= 2m - 5/2.
//
//   A_0     A_1     A_2        The circumcentres of the strip are at x = 1, 2, .., 2m - 2. A light
//     \    /   \    /   .      point shows exactly while it is nearer than eps to one of them, and never
//   --- * --- * --- * -- ->    do two at once: 4n(m - 1) events.
//        \  /     \  /
//        B_0       B_1
void generate_show_and_hide(const lab::WorkloadParameters& parameters, Scene& scene) {
  const std::int64_t n = parameters.n, m = parameters.m;
  scene.start = 0;
  scene.end = Rational(2 * m) - fraction(5, 2);
  scene.extents = Extents::kWeight;
  const Rational heavy = fraction(3, 2) - fraction(1, 64) / Rational(n) / Rational(n);
  for (std::int64_t j = 0; j < m; ++j) {
    const std::string number = std::to_string(j);
    lab::add_object(scene, "a" + number, {{Rational(2 * j)}, {Rational(1)}, {heavy}});
    lab::add_object(scene, "b" + number, {{Rational(2 * j + 1)}, {Rational(-1)}, {heavy}});
  }
  for (std::int64_t i = 0; i < n; ++i) {
    const Rational start = fraction(1, 2) + fraction(2 * i + 1, 4 * n);
    lab::add_object(scene, "p" + std::to_string(i), {{start, Rational(1)}, {Rational(0)}, {}});
  }
}

// The simplex of the origin and of 6 on each axis, of weight 0, and (2, 1) or (2, 1, 1) of weight
// theta + (t - 1)(t - 2)..(t - n): theta is where it lies in the plane of the simplex, all lifted: 5 - 18
// in the plane, 6 - 24 in space. It shows and hides in turn, at t = 1, .., n.
void generate_breathing(const lab::WorkloadParameters& parameters, Scene& scene) {
  scene.start = 0;
  scene.end = Rational(parameters.n + 1);
  scene.extents = Extents::kWeight;
  const int axes = parameters.dimension;
  for (int corner = -1; corner < axes; ++corner) {
    std::vector<std::vector<Rational>> place;
    for (int axis = 0; axis < axes; ++axis) place.push_back({Rational(axis == corner ? 6 : 0)});
    place.emplace_back();
    lab::add_object(scene, "c" + std::to_string(corner + 1), std::move(place));
  }
  std::vector<Rational> weight{1};
  for (int root = 1; root <= parameters.n; ++root) {
    std::vector<Rational> next(weight.size() + 1);
    for (std::size_t k = 0; k < weight.size(); ++k) {
      next[k + 1] += weight[k];
      next[k] -= weight[k] * Rational(root);
    }
    weight = std::move(next);
  }
  weight[0] -= Rational(axes == 2 ? 13 : 18);
  std::vector<std::vector<Rational>> place(static_cast<std::size_t>(axes), {Rational(1)});
  place[0] = {Rational(2)};
  place.push_back(std::move(weight));
  lab::add_object(scene, "breathing", std::move(place));
}

namespace {

// As small-integers (proximity/small_integers.cpp); then for each point its weight, next() mod 1500, and
// if it moves the rate of it, (next() mod 401) - 200. In space mod 6000, and (next() mod 801) - 400.
void generate_small(const lab::WorkloadParameters& parameters, bool moving, Scene& scene) {
  lab::RepeatableNumbers numbers(parameters.seed);
  scene.start = 0;
  scene.end = Rational(10);
  scene.extents = Extents::kWeight;
  const bool in_space = parameters.dimension == 3;
  const int weights = in_space ? 6000 : 1500, most = in_space ? 400 : 200;
  for (int i = 0; i < parameters.n; ++i) {
    std::vector<std::vector<Rational>> axes;
    for (int axis = 0; axis < parameters.dimension; ++axis) axes.push_back(numbers.line());
    axes.push_back({Rational(numbers.next() % weights)});
    if (moving) axes.back().push_back(Rational(numbers.next() % (2 * most + 1) - most));
    lab::add_object(scene, "p" + std::to_string(i), std::move(axes));
  }
}

}  // namespace

void generate_small_weights(const lab::WorkloadParameters& parameters, Scene& scene) {
  generate_small(parameters, false, scene);
}
void generate_small_moving_weights(const lab::WorkloadParameters& parameters, Scene& scene) {
  generate_small(parameters, true, scene);
}

// On a line from one random place of the unit square (cube) at t = 0 to another at t = 1; weights go from
// one random number to another, at most the square of a typical distance, n^(-2/d). Multiples of 2^-20.
void generate_random_weights(const lab::WorkloadParameters& parameters, Scene& scene) {
  lab::WorkloadRandom random(parameters.seed);
  scene.start = 0;
  scene.end = Rational(1);
  scene.extents = Extents::kWeight;
  const std::int64_t heaviest =
      std::max<std::int64_t>(1, lab::grid_over_root(parameters.n, parameters.dimension, 2));
  const auto line = [&random](std::int64_t most) {
    const std::int64_t first = random.between(0, most), last = random.between(0, most);
    return std::vector<Rational>{lab::on_grid(first), lab::on_grid(last - first)};
  };
  for (int i = 0; i < parameters.n; ++i) {
    std::vector<std::vector<Rational>> axes;
    for (int axis = 0; axis < parameters.dimension; ++axis) axes.push_back(line(lab::kGridUnits));
    axes.push_back(line(heaviest));
    lab::add_object(scene, "p" + std::to_string(i), std::move(axes));
  }
}

}  // namespace kinex::families
