// SPDX-License-Identifier: GPL-3.0-or-later
// Discs and boxes that move: scenes of known numbers of meetings, and random ones.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "experiments/families/proximity/experiments.h"
#include "experiments/lab/grid_root.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

namespace {

using Axes = std::vector<std::vector<Rational>>;

// A disc or a box of these extents, as many as the scene's objects have.
void add_extended(Scene& scene, std::string id, Axes position, Axes extents) {
  for (std::vector<Rational>& axis : extents) position.push_back(std::move(axis));
  lab::add_object(scene, std::move(id), std::move(position));
}

// p_i = (i t, i^2 t, ..), -2 <= t <= 2, radius or half extents 1/2: at t = 0 all centres coincide.
// Objects i and j overlap along the last axis in the shortest time about 0, and touch within
// |t| <= 1: each two meet once and part once, n(n-1) changes, which is the hard bound.
void generate_fan(const lab::WorkloadParameters& parameters, Extents kind, Scene& scene) {
  scene.start = Rational(-2);
  scene.end = Rational(2);
  scene.extents = kind;
  for (std::int64_t i = 0; i < parameters.n; ++i) {
    Axes position;
    std::int64_t speed = 1;
    for (int axis = 0; axis < parameters.dimension; ++axis) {
      speed *= i;
      position.push_back({lab::fraction(0, 1), lab::fraction(speed, 1)});
    }
    Axes extents(static_cast<std::size_t>(scene.extent_axes()), {lab::fraction(1, 2)});
    add_extended(scene, "p" + std::to_string(i), std::move(position), std::move(extents));
  }
}

// As small-integers (small_integers.cpp); then for each object its radius, or its half extent along
// each axis, 1 + next() mod 12.
void generate_small(const lab::WorkloadParameters& parameters, Extents kind, Scene& scene) {
  lab::RepeatableNumbers numbers(parameters.seed);
  scene.start = 0;
  scene.end = Rational(10);
  scene.extents = kind;
  for (int i = 0; i < parameters.n; ++i) {
    Axes position, extents;
    for (int axis = 0; axis < parameters.dimension; ++axis) position.push_back(numbers.line());
    for (int axis = 0; axis < scene.extent_axes(); ++axis) {
      extents.push_back({lab::fraction(1 + numbers.next() % 12, 1)});
    }
    add_extended(scene, "p" + std::to_string(i), std::move(position), std::move(extents));
  }
}

// On a line from one random place of the unit square (cube, interval) at t = 0 to another at t = 1;
// radii and half extents go from one random number to another, each positive and at most a quarter of a
// typical distance, n^(-1/d) / 4: however many there are, each meets about as many others. Multiples of 2^-20.
void generate_random(const lab::WorkloadParameters& parameters, Extents kind, Scene& scene) {
  lab::WorkloadRandom random(parameters.seed);
  scene.start = 0;
  scene.end = Rational(1);
  scene.extents = kind;
  const std::int64_t largest =
      std::max<std::int64_t>(1, lab::grid_over_root(parameters.n, parameters.dimension) / 4);
  const auto line = [&random](std::int64_t least, std::int64_t most) {
    const std::int64_t first = random.between(least, most), last = random.between(least, most);
    return std::vector<Rational>{lab::on_grid(first), lab::on_grid(last - first)};
  };
  for (int i = 0; i < parameters.n; ++i) {
    Axes position, extents;
    for (int axis = 0; axis < parameters.dimension; ++axis) position.push_back(line(0, lab::kGridUnits));
    for (int axis = 0; axis < scene.extent_axes(); ++axis) {
      extents.push_back(line(1, largest));
    }
    add_extended(scene, "p" + std::to_string(i), std::move(position), std::move(extents));
  }
}

}  // namespace

void generate_fan_of_discs(const lab::WorkloadParameters& parameters, Scene& scene) {
  generate_fan(parameters, Extents::kRadius, scene);
}
void generate_fan_of_boxes(const lab::WorkloadParameters& parameters, Scene& scene) {
  generate_fan(parameters, Extents::kHalfExtents, scene);
}
void generate_small_discs(const lab::WorkloadParameters& parameters, Scene& scene) {
  generate_small(parameters, Extents::kRadius, scene);
}
void generate_small_boxes(const lab::WorkloadParameters& parameters, Scene& scene) {
  generate_small(parameters, Extents::kHalfExtents, scene);
}
void generate_random_discs(const lab::WorkloadParameters& parameters, Scene& scene) {
  generate_random(parameters, Extents::kRadius, scene);
}
void generate_random_boxes(const lab::WorkloadParameters& parameters, Scene& scene) {
  generate_random(parameters, Extents::kHalfExtents, scene);
}

// m discs rest in a row, 16 apart, of radius 4 and 2 in turn. n discs of radius 1 pass over it at a height
// of 8, one after another, 16 m apart, so that right over the row there is one of them, and only one. It
// has the smallest gap with each disc of the row in turn, at least 3: all nm pairs, nm - 1 changes. Two
// neighbours of the row have a gap of 10.
void generate_gaps_along_row(const lab::WorkloadParameters& parameters, Scene& scene) {
  const std::int64_t n = parameters.n, m = parameters.m;
  scene.start = 0;
  scene.end = lab::fraction(2 * n * m - 1, 2);
  scene.extents = Extents::kRadius;
  for (std::int64_t j = 0; j < m; ++j) {
    add_extended(scene, "row" + std::to_string(j), {{lab::fraction(16 * j, 1)}, {Rational(0)}},
                 {{lab::fraction(j % 2 == 0 ? 4 : 2, 1)}});
  }
  for (std::int64_t i = 0; i < n; ++i) {
    add_extended(scene, "p" + std::to_string(i),
                 {{lab::fraction(-16 * m * i, 1), Rational(16)}, {Rational(8)}}, {{Rational(1)}});
  }
}

// Discs of linear motion in the unit square (cube) whose radii are at most 1 / (32 n): most of the time no
// two meet. Positions as of random discs.
void generate_apart_discs(const lab::WorkloadParameters& parameters, Scene& scene) {
  lab::WorkloadRandom random(parameters.seed);
  scene.start = 0;
  scene.end = Rational(1);
  scene.extents = Extents::kRadius;
  const auto line = [&random](std::int64_t least, std::int64_t most) {
    const std::int64_t first = random.between(least, most), last = random.between(least, most);
    return std::vector<Rational>{lab::on_grid(first), lab::on_grid(last - first)};
  };
  const std::int64_t most = std::max<std::int64_t>(1, lab::kGridUnits / (32 * std::int64_t{parameters.n}));
  for (int i = 0; i < parameters.n; ++i) {
    Axes position;
    for (int axis = 0; axis < parameters.dimension; ++axis) position.push_back(line(0, lab::kGridUnits));
    add_extended(scene, "p" + std::to_string(i), std::move(position), {line(1, most)});
  }
}

}  // namespace kinex::families
