// SPDX-License-Identifier: GPL-3.0-or-later
// Two nearly regular polygons of n vertices and radius 1; one rests at the origin, the other moves
// in straight lines.
#include <algorithm>

#include "experiments/families/collision/polygons.h"
#include "experiments/formats/angles.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

namespace {

void generate_path(const lab::WorkloadParameters& parameters, Scene& scene,
                   const std::vector<Vertex2>& points) {
  scene.start = 0;
  scene.end = static_cast<std::int64_t>(points.size()) - 1;
  add_body(scene, "a", regular_polygon(parameters.n, 1), {0}, {0});
  add_body_on_polyline(scene, "b", regular_polygon(parameters.n, 1), points);
}

}  // namespace

// The body moves to and fro m times on the diagonal, by 2^-20 to either side of the distance
// 1 + sqrt(2). For n a multiple of 8, that is where the line that touches one polygon in the middle
// of a quadrant meets the corner of the box around the other.
void generate_polygon_jitter(const lab::WorkloadParameters& parameters, Scene& scene) {
  const Rational middle = Rational(1) + formats::rounded(formats::approximate_root(lab::fraction(1, 2)), 40);
  const Rational near = middle - lab::on_grid(1), far = middle + lab::on_grid(1);
  std::vector<Vertex2> points{{far, far}};
  for (int i = 0; i < parameters.m; ++i) {
    points.push_back({near, near});
    points.push_back({far, far});
  }
  generate_path(parameters, scene, points);
}

// A random walk round the body with m kinks. It keeps a clearance of at least `separation`: the
// kinks are on the circle of radius r = 33/32 (2 + separation), 64 places apart, and a step
// advances by at most four places, so its line stays outside the circle of radius r cos(pi/16) >
// 49/50 r.
void generate_polygon_kinks(const lab::WorkloadParameters& parameters, Scene& scene) {
  constexpr std::int64_t kPlaces = 64;
  lab::WorkloadRandom random(parameters.seed);
  const std::vector<Vertex2> places =
      regular_polygon(kPlaces, lab::fraction(33, 32) * (Rational(2) + *parameters.separation));
  std::int64_t place = 0;
  std::vector<Vertex2> points{places[0]};
  for (int i = 0; i <= parameters.m; ++i) {
    const std::int64_t step = random.between(1, 4);
    place = (place + (random.below(2) == 0 ? step : kPlaces - step)) % kPlaces;
    points.push_back(places[static_cast<std::size_t>(place)]);
  }
  generate_path(parameters, scene, points);
}

// From above, swinging from side to side by the remaining distance to the top of the Minkowski sum,
// which is halved in every unit of time until it is at most `separation`.
void generate_polygon_approach(const lab::WorkloadParameters& parameters, Scene& scene) {
  std::vector<Vertex2> turned = regular_polygon(parameters.n, 1);
  Rational top = top_of(turned);
  for (Vertex2& vertex : turned) vertex[1] = -vertex[1];
  top += top_of(turned);
  std::vector<Vertex2> points;
  Rational left = 4;
  for (int side = 1;; side = -side) {
    points.push_back({Rational(side) * left, top + left});
    if (points.size() > 1 && left <= *parameters.separation) break;
    left /= Rational(2);
  }
  generate_path(parameters, scene, points);
}

}  // namespace kinex::families
