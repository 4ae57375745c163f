// SPDX-License-Identifier: GPL-3.0-or-later
// A regular polygon of n vertices and radius 1 that turns once about its centre (0, L), and a body
// below it with a fan of m nearly parallel edges at the origin. L = 1 + separation.
//
//        .-'-.        B turns
//       |  +  |       centre (0, L)
//        '-.-'
//     ___.-----.___   the fan of the other body
#include <algorithm>

#include "experiments/families/collision/polygons.h"
#include "experiments/formats/angles.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

namespace {

void add_spinning(const lab::WorkloadParameters& parameters, Scene& scene) {
  scene.start = 0;
  scene.end = 2;
  add_turning_body(scene, "b", regular_polygon(parameters.n, 1), 0,
                   Rational(1) + *parameters.separation, half_turns(2, 2));
}

// The k-th of m numbers spread evenly between two, at half a step from both.
Rational spread(const Rational& low, const Rational& high, int k, int m) {
  return low + (high - low) * lab::fraction(2 * std::int64_t{k} + 1, 2 * std::int64_t{m});
}

}  // namespace

// As a vertex of B passes, the direction of the shortest segment between the bodies swings by the
// angle b1 with sin b1 = sin(pi/n) / L to either side and back. The normals of the fan's edges,
// (s, 1), lie within 2/5 of that, so the segment crosses the whole fan twice: 3m + 2 changes of the
// closest features per vertex, n (3m + 2) in the turn.
void generate_polygon_fan(const lab::WorkloadParameters& parameters, Scene& scene) {
  const Rational gap = *parameters.separation, distance = Rational(1) + gap;
  const Rational swing = formats::rounded(
      formats::approximate_cos_sin(formats::approximate_pi() / Rational(parameters.n)).sin / distance,
      60);
  const int m = parameters.m;
  const Rational steepest = lab::fraction(2, 5) * swing;
  const Rational width =  // of an edge
      formats::rounded(lab::fraction(6, 25) * swing * gap, 60) / Rational(m);
  std::vector<Vertex2> fan{{width * lab::fraction(m, 2), 0}};
  for (int k = 0; k < m; ++k) {
    const Rational slope = spread(steepest, -steepest, k, m);
    fan.push_back({fan.back()[0] - width, fan.back()[1] + width * slope});
  }
  const Rational top = top_of(fan);
  std::vector<Vertex2> polygon{{-1, -1}, {1, -1}};
  for (Vertex2& vertex : fan) polygon.push_back({vertex[0], vertex[1] - top});
  add_body(scene, "a", std::move(polygon), {0}, {0});
  add_spinning(parameters, scene);
}

// The inner common tangent from the fan touches B at the angle u from its lowest point, where its
// direction from upright is atan(sin u / (L - cos u)). As a vertex passes, that swings between the
// direction at cos u = 1/L, the largest, and that at pi/n beside it. The fan's edges have
// directions in the middle half of the swing and are short, so the tangent crosses the whole fan
// twice: 2m + 1 changes per vertex, n (2m + 1) in the turn. At a separation below 3/4 the bodies
// would collide.
void generate_polygon_tangents(const lab::WorkloadParameters& parameters, Scene& scene) {
  const Rational distance = Rational(1) + *parameters.separation;
  const Rational cos = Rational(1) / distance;
  const Rational sin = formats::approximate_root(distance * distance - Rational(1)) / distance;
  const formats::CosSin step =
      formats::approximate_cos_sin(formats::approximate_pi() / Rational(parameters.n));
  const auto slope_at = [&](const Rational& c, const Rational& s) { return s / (distance - c); };
  const Rational high = formats::rounded(slope_at(cos, sin), 64);
  const Rational low =
      formats::rounded(std::max(slope_at(cos * step.cos - sin * step.sin, sin * step.cos + cos * step.sin),
                       slope_at(cos * step.cos + sin * step.sin, sin * step.cos - cos * step.sin)),
              64);
  const int m = parameters.m;
  const Rational quarter = (high - low) / Rational(4);
  const Rational height = (high - low) * distance / Rational(2 * std::int64_t{m});  // of an edge
  // Downwards, the body on the left: the steepest directions come last.
  Vertex2 vertex{0, height * lab::fraction(m, 2)};
  std::vector<Vertex2> polygon{vertex};
  for (int k = 0; k < m; ++k) {
    const Rational slope = spread(high - quarter, low + quarter, k, m);
    vertex = {vertex[0] - height * slope, vertex[1] - height};
    polygon.push_back(vertex);
  }
  polygon.push_back({1, -3});
  polygon.push_back({2, -1});
  add_body(scene, "a", std::move(polygon), {0}, {0});
  add_spinning(parameters, scene);
}

}  // namespace kinex::families
