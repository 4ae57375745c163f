// SPDX-License-Identifier: GPL-3.0-or-later
// Random polygons in random motion; t in [0, 1].
#include <algorithm>

#include "experiments/families/collision/polygons.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

namespace {

// At most `most` vertices, chosen at random among those of a regular polygon with four times as
// many and stretched along both axes by factors in [1/4, 1].
std::vector<Vertex2> random_polygon(lab::WorkloadRandom& random, int most) {
  const std::vector<Vertex2> places = regular_polygon(4 * most, 1);
  const Rational x = lab::on_grid(random.between(lab::kGridUnits / 4, lab::kGridUnits));
  const Rational y = lab::on_grid(random.between(lab::kGridUnits / 4, lab::kGridUnits));
  std::vector<std::uint64_t> chosen;
  while (chosen.size() < 3) {
    chosen.clear();
    for (int i = 0; i < most; ++i) chosen.push_back(random.below(places.size()));
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  }
  std::vector<Vertex2> polygon;
  for (const std::uint64_t i : chosen) polygon.push_back({places[i][0] * x, places[i][1] * y});
  return polygon;
}

// (1 + at) + ibt: q vanishes at 0 only, where p does not.
struct Spin {
  Coefficients p, q;
};
Spin random_spin(lab::WorkloadRandom& random) {
  const std::int64_t a = random.between(-2 * lab::kGridUnits, 2 * lab::kGridUnits);
  const std::int64_t b = random.between(1, 2 * lab::kGridUnits);
  const std::int64_t sign = random.below(2) == 0 ? 1 : -1;
  return {{1, lab::on_grid(a)}, {0, lab::on_grid(sign * b)}};
}

}  // namespace

// Two bodies in discs of radius 1. Both turn; one comes from the distance 3 and is at a random
// place in [-3, 3]^2 at t = 1/2. In degree d > 1 its path has terms b_k (t^k - t / 2^(k - 1)), b_k
// uniform in [-1, 1], which keep both places. They may collide.
void generate_polygon_random(const lab::WorkloadParameters& parameters, Scene& scene) {
  lab::WorkloadRandom random(parameters.seed);
  scene.start = 0;
  scene.end = 1;
  std::vector<Vertex2> polygon = random_polygon(random, parameters.n);
  Spin spin = random_spin(random);
  add_body(scene, "a", std::move(polygon), {0}, {0}, spin.p, spin.q);
  const std::vector<Vertex2> starts = regular_polygon(64, 3);
  const Vertex2 start = starts[random.below(starts.size())];
  std::vector<Coefficients> way;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const Rational middle = lab::on_grid(random.between(-3 * lab::kGridUnits, 3 * lab::kGridUnits));
    Coefficients c{start[axis], Rational(2) * (middle - start[axis])};
    for (int k = 2; k <= parameters.degree; ++k) {
      const Rational bend = lab::on_grid(random.between(-lab::kGridUnits, lab::kGridUnits));
      c[1] -= bend / Rational(Integer::power_of_two(static_cast<unsigned long>(k - 1)));
      c.push_back(bend);
    }
    way.push_back(std::move(c));
  }
  polygon = random_polygon(random, parameters.m);
  spin = random_spin(random);
  add_body(scene, "b", std::move(polygon), way[0], way[1], spin.p, spin.q);
}

// n regular polygons of m vertices, each in a unit cell of its own of a square box, move straight
// to a random place in the box while they turn. They may collide on the way. Centres start at least
// 3/4 apart; the radius is half of what the separation leaves of that, by default 1/4.
void generate_polygons_in_box(const lab::WorkloadParameters& parameters, Scene& scene) {
  lab::WorkloadRandom random(parameters.seed);
  scene.start = 0;
  scene.end = 1;
  std::int64_t side = 1;
  while (side * side < parameters.n) ++side;
  const std::vector<Vertex2> polygon =
      regular_polygon(parameters.m, (lab::fraction(3, 4) - *parameters.separation) / Rational(2));
  for (std::int64_t i = 0; i < parameters.n; ++i) {
    std::vector<Coefficients> way;
    for (const std::int64_t cell : {i % side, i / side}) {
      const std::int64_t origin =
          cell * lab::kGridUnits + lab::kGridUnits / 2 +
          random.between(-lab::kGridUnits / 8, lab::kGridUnits / 8);
      const std::int64_t destination = random.between(0, side * lab::kGridUnits);
      way.push_back({lab::on_grid(origin), lab::on_grid(destination - origin)});
    }
    const Spin spin = random_spin(random);
    add_body(scene, "b" + std::to_string(i), polygon, way[0], way[1], spin.p, spin.q);
  }
}

}  // namespace kinex::families
