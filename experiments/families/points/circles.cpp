// SPDX-License-Identifier: GPL-3.0-or-later
// Points with rational coordinates on circles: cocircular at all times, under polynomial motion.
// (a (1 - t^2) - 2 b t, 2 a t + b (1 - t^2)) is (a, b) turned by 2 arctan(t) and scaled by 1 + t^2.
#include "experiments/families/points/workloads.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

namespace {

struct CirclePoint {
  Rational a, b;
};

// The i-th of n points counter-clockwise on the unit circle: u = tan(angle / 2) grows evenly from 0
// to 1 in the first quadrant; the other quadrants are turned by right angles.
CirclePoint circle_point(std::int64_t i, std::int64_t n) {
  const std::int64_t quadrant = 4 * i / n;
  const Rational u = lab::fraction(4 * i - quadrant * n, n);
  const Rational scale = Rational(1) + u * u;
  Rational a = (Rational(1) - u * u) / scale;
  Rational b = Rational(2) * u / scale;
  for (std::int64_t turn = 0; turn < quadrant; ++turn) {
    Rational next = -b;
    b = std::move(a);
    a = std::move(next);
  }
  return {a, b};
}

// Turning counter-clockwise (direction 1) or clockwise (-1).
void add_turning(Scene& scene, std::string id, const CirclePoint& p, int direction) {
  const Rational s = Rational(2 * direction);
  lab::add_object(scene, std::move(id), {{p.a, -(s * p.b), -p.a}, {p.b, s * p.a, -p.b}});
}

}  // namespace

// Half of the points turn counter-clockwise on the unit circle, the others clockwise on the circle
// of half its radius, each by a right angle while t runs through [0, 1].
void generate_counter_rotating_rings(const lab::WorkloadParameters& parameters, Scene& scene) {
  scene.start = 0;
  scene.end = 1;
  const std::int64_t outer = (static_cast<std::int64_t>(parameters.n) + 1) / 2;
  const std::int64_t inner = parameters.n - outer;
  for (std::int64_t i = 0; i < outer; ++i) {
    add_turning(scene, "outer" + std::to_string(i), circle_point(i, outer), 1);
  }
  for (std::int64_t i = 0; i < inner; ++i) {
    CirclePoint p = circle_point(i, inner);
    p.a *= lab::fraction(1, 2);
    p.b *= lab::fraction(1, 2);
    add_turning(scene, "inner" + std::to_string(i), p, -1);
  }
}

// All points move outwards, (1 + t) times the unit circle: every in-circle certificate is
// identically zero.
void generate_expanding_circle(const lab::WorkloadParameters& parameters, Scene& scene) {
  scene.start = 0;
  scene.end = 4;
  for (std::int64_t i = 0; i < parameters.n; ++i) {
    const CirclePoint p = circle_point(i, parameters.n);
    lab::add_object(scene, "p" + std::to_string(i), {{p.a, p.a}, {p.b, p.b}});
  }
}

// One ring turns by a right angle: quadratic coordinates, constant shape.
void generate_rotating_circle(const lab::WorkloadParameters& parameters, Scene& scene) {
  scene.start = 0;
  scene.end = 1;
  for (std::int64_t i = 0; i < parameters.n; ++i) {
    add_turning(scene, "p" + std::to_string(i), circle_point(i, parameters.n), 1);
  }
}

}  // namespace kinex::families
