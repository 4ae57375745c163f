// SPDX-License-Identifier: GPL-3.0-or-later
// Every pair of points exchanges its order along x, y, x + y and x - y, far apart.
#include <cstdint>
#include <string>

#include "experiments/families/proximity/experiments.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

// (x_j, y_j) = (2 j t - 6 a_j, j t - 2 a_j) with a_j = 4 n^2 j^2 + j^3. Along each of the four
// directions the speeds ascend and the places at t = 0 descend with j, so every pair exchanges its
// order once, at (a_j - a_i) / (j - i) times 3, 2, 8/3 and 4: 4 C(n, 2) exchanges. No two points
// meet, and no two exchanges along one direction are simultaneous: (a_j - a_i) / (j - i) is
// 4 n^2 s + s^2 - i j for s = i + j.
void generate_exchange_in_all_orders(const lab::WorkloadParameters& parameters, Scene& scene) {
  const std::int64_t n = parameters.n;
  scene.start = 0;
  scene.end = lab::fraction(4 * (8 * n * n * n + 4 * n * n), 1);
  for (std::int64_t j = 0; j < n; ++j) {
    const std::int64_t place = 4 * n * n * j * j + j * j * j;
    lab::add_object(scene, "p" + std::to_string(j),
                    {{lab::fraction(-6 * place, 1), lab::fraction(2 * j, 1)},
                     {lab::fraction(-2 * place, 1), lab::fraction(j, 1)}});
  }
}

}  // namespace kinex::families
