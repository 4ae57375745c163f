// SPDX-License-Identifier: GPL-3.0-or-later
// Random motion: origin and destination are drawn independently from one distribution, t in [0, 1].
// In degree d > 1, x(t) = o + (p - o) t + sum over k = 2..d of a_k (t^k - t), a_k uniform in
// [-1, 1]: the same origin o and destination p, another path between them.
#include "experiments/families/points/workloads.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

namespace {

using Point = std::vector<std::int64_t>;  // in grid units

void generate(const lab::WorkloadParameters& parameters, Scene& scene,
              Point (*draw)(lab::WorkloadRandom&, int)) {
  lab::WorkloadRandom random(parameters.seed);
  scene.start = 0;
  scene.end = 1;
  for (int i = 0; i < parameters.n; ++i) {
    const Point origin = draw(random, scene.dimension);
    const Point destination = draw(random, scene.dimension);
    std::vector<std::vector<Rational>> coordinates;
    for (std::size_t axis = 0; axis < origin.size(); ++axis) {
      std::vector<Rational> bends;
      std::int64_t linear = destination[axis] - origin[axis];
      for (int k = 2; k <= parameters.degree; ++k) {
        const std::int64_t a = random.between(-lab::kGridUnits, lab::kGridUnits);
        bends.push_back(lab::on_grid(a));
        linear -= a;
      }
      std::vector<Rational> coefficients{lab::on_grid(origin[axis]), lab::on_grid(linear)};
      coefficients.insert(coefficients.end(), bends.begin(), bends.end());
      coordinates.push_back(std::move(coefficients));
    }
    lab::add_object(scene, "p" + std::to_string(i), std::move(coordinates));
  }
}

Point in_square(lab::WorkloadRandom& random, int dimension) {
  Point point;
  for (int axis = 0; axis < dimension; ++axis) point.push_back(random.between(0, lab::kGridUnits));
  return point;
}

// By rejection: uniform over the grid points of the unit disk (interval, ball).
Point in_disk(lab::WorkloadRandom& random, int dimension) {
  for (;;) {
    Point point;
    std::int64_t square = 0;
    for (int axis = 0; axis < dimension; ++axis) {
      point.push_back(random.between(-lab::kGridUnits, lab::kGridUnits));
      square += point.back() * point.back();
    }
    if (square <= lab::kGridUnits * lab::kGridUnits) return point;
  }
}

// The sum of twelve uniform numbers, centred: variance 1, normal in all but the tails (|x| <= 6).
Point normal(lab::WorkloadRandom& random, int dimension) {
  Point point;
  for (int axis = 0; axis < dimension; ++axis) {
    std::int64_t sum = -6 * lab::kGridUnits;
    for (int k = 0; k < 12; ++k) sum += random.between(0, lab::kGridUnits);
    point.push_back(sum);
  }
  return point;
}

}  // namespace

void generate_uniform_square(const lab::WorkloadParameters& parameters, Scene& scene) {
  generate(parameters, scene, in_square);
}

void generate_uniform_disk(const lab::WorkloadParameters& parameters, Scene& scene) {
  generate(parameters, scene, in_disk);
}

void generate_gaussian(const lab::WorkloadParameters& parameters, Scene& scene) {
  generate(parameters, scene, normal);
}

}  // namespace kinex::families
