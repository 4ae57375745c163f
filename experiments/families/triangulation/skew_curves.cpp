// SPDX-License-Identifier: GPL-3.0-or-later
// A point that passes between two skew curves of n points each, at rest: the triangulation in space
// has a cell for nearly every pair of their edges.
#include <cstdint>
#include <string>

#include "experiments/families/triangulation/experiments.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

// A_i = (40i - 20(n-1), i^2, -80 - i^3), B_i = (i^2, 40i - 20(n-1) + 3, 80 + i^3), i < n, at rest, and
// (1, 2, t), for all times that matter: |t| < 10^7.
void generate_skew_curves(const lab::WorkloadParameters& parameters, Scene& scene) {
  const std::int64_t n = parameters.n;
  scene.start = -10000000;
  scene.end = Rational(10000000);
  const auto rest = [&scene](const std::string& name, std::int64_t x, std::int64_t y,
                             std::int64_t z) {
    lab::add_object(scene, name, {{Rational(x)}, {Rational(y)}, {Rational(z)}});
  };
  for (std::int64_t i = 0; i < n; ++i) {
    const std::string number = std::to_string(i);
    const std::int64_t along = 40 * i - 20 * (n - 1);
    rest("a" + number, along, i * i, -80 - i * i * i);
    rest("b" + number, i * i, along + 3, 80 + i * i * i);
  }
  lab::add_object(scene, "passer", {{Rational(1)}, {Rational(2)}, {Rational(0), Rational(1)}});
}

}  // namespace kinex::families
