// SPDX-License-Identifier: GPL-3.0-or-later
// Points of an integer lattice: full of equal, collinear and cocircular positions.
#include "experiments/families/points/workloads.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

namespace {

// The side of the smallest cube of lattice points that holds n of them.
std::int64_t side_for(int n, int dimension) {
  for (std::int64_t side = 1;; ++side) {
    std::int64_t points = 1;
    for (int axis = 0; axis < dimension && points < n; ++axis) points *= side;
    if (points >= n) return side;
  }
}

// Coordinates of the lattice point of that rank.
std::vector<std::int64_t> lattice_point(std::int64_t rank, std::int64_t side, int dimension) {
  std::vector<std::int64_t> point;
  for (int axis = 0; axis < dimension; ++axis) {
    point.push_back(rank % side);
    rank /= side;
  }
  return point;
}

}  // namespace

// Starts on the lattice; velocities are integers in [-3, 3]; t in [0, 4].
void generate_grid(const lab::WorkloadParameters& parameters, Scene& scene) {
  lab::WorkloadRandom random(parameters.seed);
  const std::int64_t side = side_for(parameters.n, scene.dimension);
  scene.start = 0;
  scene.end = 4;
  for (int i = 0; i < parameters.n; ++i) {
    std::vector<std::vector<Rational>> coordinates;
    for (const std::int64_t x : lattice_point(i, side, scene.dimension)) {
      coordinates.push_back({Rational(x), Rational(random.between(-3, 3))});
    }
    lab::add_object(scene, "p" + std::to_string(i), std::move(coordinates));
  }
}

// Starts at random, is on the lattice at t = 1, and continues to t = 2.
void generate_lattice(const lab::WorkloadParameters& parameters, Scene& scene) {
  lab::WorkloadRandom random(parameters.seed);
  const std::int64_t side = side_for(parameters.n, scene.dimension);
  scene.start = 0;
  scene.end = 2;
  for (int i = 0; i < parameters.n; ++i) {
    std::vector<std::vector<Rational>> coordinates;
    for (const std::int64_t x : lattice_point(i, side, scene.dimension)) {
      const std::int64_t origin = random.between(0, side * lab::kGridUnits);
      coordinates.push_back({lab::on_grid(origin), lab::on_grid(x * lab::kGridUnits - origin)});
    }
    lab::add_object(scene, "p" + std::to_string(i), std::move(coordinates));
  }
}

}  // namespace kinex::families
