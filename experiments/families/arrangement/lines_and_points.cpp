// SPDX-License-Identifier: GPL-3.0-or-later
// Moving lines y = a x + b, with and without points: scenes of known numbers of changes, and random ones.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "experiments/families/arrangement/experiments.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

namespace {

using Axes = std::vector<std::vector<Rational>>;

void add_line(Scene& scene, std::string id, Axes slope_and_height) {
  lab::add_object(scene, std::move(id), std::move(slope_and_height));
  scene.objects.back().line = true;
}

// Every second object is a line, from the first on; without points all are.
template <class Draw>
void add_all(const lab::WorkloadParameters& parameters, bool points, Scene& scene,
             const Draw& draw) {
  for (int i = 0; i < parameters.n; ++i) {
    if (points && i % 2 == 1) {
      lab::add_object(scene, "p" + std::to_string(i), draw(false));
    } else {
      add_line(scene, "l" + std::to_string(i), draw(true));
    }
  }
}

// As small-integers (proximity/small_integers.cpp), with (a, b) in the place of (x, y).
void generate_small(const lab::WorkloadParameters& parameters, bool points, Scene& scene) {
  lab::RepeatableNumbers numbers(parameters.seed);
  scene.start = 0;
  scene.end = Rational(10);
  add_all(parameters, points, scene, [&numbers](bool) {
    Axes axes;
    for (int axis = 0; axis < 2; ++axis) axes.push_back(numbers.line());
    return axes;
  });
}

// A line goes from one random chord of the unit square to another: its heights at x = 0 and x = 1
// do. A point goes from one random place to another. Multiples of 2^-20; 0 <= t <= 1.
void generate_random(const lab::WorkloadParameters& parameters, bool points, Scene& scene) {
  lab::WorkloadRandom random(parameters.seed);
  scene.start = 0;
  scene.end = Rational(1);
  const auto draw = [&random] {
    const std::int64_t first = random.between(0, lab::kGridUnits);
    const std::int64_t last = random.between(0, lab::kGridUnits);
    return std::vector<Rational>{lab::on_grid(first), lab::on_grid(last - first)};
  };
  add_all(parameters, points, scene, [&draw](bool line) {
    const std::vector<Rational> at_0 = draw(), at_1 = draw();
    if (!line) return Axes{at_0, at_1};
    return Axes{{at_1[0] - at_0[0], at_1[1] - at_0[1]}, at_0};
  });
}

}  // namespace

// Lines y = t x - j, j = 1 .. m, and points (t, i / (n + 1)), i < n, for |t| <= m + 1. Point i is
// on line j where t^2 = j + i / (n + 1): twice, at distinct times. 2nm changes are the hard bound.
void generate_points_through_lines(const lab::WorkloadParameters& parameters, Scene& scene) {
  const std::int64_t n = parameters.n, m = parameters.m;
  scene.start = Rational(-m - 1);
  scene.end = Rational(m + 1);
  for (std::int64_t j = 1; j <= m; ++j) {
    add_line(scene, "l" + std::to_string(j), {{Rational(0), Rational(1)}, {Rational(-j)}});
  }
  for (std::int64_t i = 0; i < n; ++i) {
    lab::add_object(scene, "p" + std::to_string(i),
                    {{Rational(0), Rational(1)}, {lab::fraction(i, n + 1)}});
  }
}

// Three bundles of parallel lines, y = i, y = (x - k j) / 2 and y = x + k m q - t, for i < k, j < m and q < r
// with k + m + r = n: three of them, one of each bundle, meet at t = i + k j + k m q, an instant of their own.
// k m r triples turn over, nothing else.
void generate_three_bundles(const lab::WorkloadParameters& parameters, Scene& scene) {
  const std::int64_t n = parameters.n, k = (n + 2) / 3, m = (n + 1) / 3, r = n / 3;
  const Rational half = lab::fraction(1, 2);
  scene.start = -half;
  scene.end = Rational(k * m * r) + half;
  for (std::int64_t i = 0; i < k; ++i) {
    add_line(scene, "a" + std::to_string(i), {{Rational(0)}, {Rational(i)}});
  }
  for (std::int64_t j = 0; j < m; ++j) {
    add_line(scene, "b" + std::to_string(j), {{half}, {lab::fraction(-k * j, 2)}});
  }
  for (std::int64_t q = 0; q < r; ++q) {
    add_line(scene, "c" + std::to_string(q), {{Rational(1)}, {Rational(k * m * q), Rational(-1)}});
  }
}

// y = (i^2 + i t) x + i + i^2 t, 1 <= i <= n, for -2 n <= t <= 2. As a point (a, b) it is (i, i^2) under a
// linear map of determinant t^2 - 1: all triples turn over at t = -1, where the lines meet, and at t = 1,
// where they meet again. The slopes of i and j are equal at t = -(i + j). 2 C(n,3) and C(n,2) are the hard
// bounds.
void generate_turning_pencil(const lab::WorkloadParameters& parameters, Scene& scene) {
  const std::int64_t n = parameters.n;
  scene.start = Rational(-2 * n);
  scene.end = Rational(2);
  for (std::int64_t i = 1; i <= n; ++i) {
    add_line(scene, "l" + std::to_string(i),
             {{Rational(i * i), Rational(i)}, {Rational(i), Rational(i * i)}});
  }
}

void generate_small_lines(const lab::WorkloadParameters& parameters, Scene& scene) {
  generate_small(parameters, false, scene);
}
void generate_random_lines(const lab::WorkloadParameters& parameters, Scene& scene) {
  generate_random(parameters, false, scene);
}
void generate_small_lines_and_points(const lab::WorkloadParameters& parameters, Scene& scene) {
  generate_small(parameters, true, scene);
}
void generate_random_lines_and_points(const lab::WorkloadParameters& parameters, Scene& scene) {
  generate_random(parameters, true, scene);
}

}  // namespace kinex::families
