// SPDX-License-Identifier: GPL-3.0-or-later
// A convex hull that changes 2nm - 1 times in linear motion. At time t the m points q_j lie on the
// parabola y = x(t - x); each of the n points p_i, 1/8 below it, emerges in the middle of every gap
// between two q's and disappears behind each q.
#include "experiments/families/hull/workloads.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

// q_j(t) = (j, -j^2 + j t), p_i(t) = (t - g, -g^2 + g t - 1/8) with g = i (1 + 1/(n + 1)).
void generate_hull_worst(const lab::WorkloadParameters& parameters, Scene& scene) {
  const std::int64_t n = parameters.n;
  const std::int64_t m = parameters.m;
  for (std::int64_t j = 0; j < m; ++j) {
    lab::add_object(scene, "q" + std::to_string(j),
               {{Rational(j)}, {-(Rational(j) * Rational(j)), Rational(j)}});
  }
  Rational g;
  for (std::int64_t i = 0; i < n; ++i) {
    g = lab::fraction(i * (n + 2), n + 1);
    lab::add_object(scene, "p" + std::to_string(i), {{-g, Rational(1)}, {-(g * g) - lab::fraction(1, 8), g}});
  }
  scene.start = 0;
  scene.end = g + Rational(m + 2);
}

}  // namespace kinex::families
