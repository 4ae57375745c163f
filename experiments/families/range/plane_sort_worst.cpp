// SPDX-License-Identifier: GPL-3.0-or-later
// Every pair of points changes places on both axes.
#include <string>

#include "experiments/families/range/experiments.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

// x = j t - (2n)^j and y = j t - 3 (2n + 1)^j, t >= 0: on each axis j overtakes every i < j once,
// after all pairs of smaller numbers. n(n-1)/2 swaps an axis.
void generate_plane_sort_worst(const lab::WorkloadParameters& parameters, Scene& scene) {
  scene.start = 0;
  Integer x(1), y(3);
  for (int j = 0; j < parameters.n; ++j) {
    lab::add_object(scene, "p" + std::to_string(j),
                    {{Rational(-x), Rational(j)}, {Rational(-y), Rational(j)}});
    x = x * Integer(2 * parameters.n);
    y = y * Integer(2 * parameters.n + 1);
  }
}

}  // namespace kinex::families
