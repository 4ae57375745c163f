// SPDX-License-Identifier: GPL-3.0-or-later
// All objects but one rest in the unit square; the last one crosses it. The cost should depend on
// what the mover meets, not on n.
#include "experiments/families/points/workloads.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

void generate_static_one_mover(const lab::WorkloadParameters& parameters, Scene& scene) {
  lab::WorkloadRandom random(parameters.seed);
  scene.start = 0;
  scene.end = 1;
  for (int i = 0; i + 1 < parameters.n; ++i) {
    std::vector<std::vector<Rational>> coordinates;
    for (int axis = 0; axis < scene.dimension; ++axis) {
      coordinates.push_back({lab::on_grid(random.between(0, lab::kGridUnits))});
    }
    lab::add_object(scene, "p" + std::to_string(i), std::move(coordinates));
  }
  // From x = -1/4 to x = 5/4, between random heights.
  std::vector<std::vector<Rational>> coordinates{{lab::fraction(-1, 4), lab::fraction(3, 2)}};
  for (int axis = 1; axis < scene.dimension; ++axis) {
    const std::int64_t from = random.between(0, lab::kGridUnits);
    const std::int64_t to = random.between(0, lab::kGridUnits);
    coordinates.push_back({lab::on_grid(from), lab::on_grid(to - from)});
  }
  lab::add_object(scene, "mover", std::move(coordinates));
}

}  // namespace kinex::families
