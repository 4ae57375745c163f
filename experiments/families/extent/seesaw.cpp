// SPDX-License-Identifier: GPL-3.0-or-later
// A smallest circle that changes 3nm - n - m - 1 times.
#include <string>

#include "experiments/families/extent/experiments.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

// n points rest on a flat arc on the left, from (.., -1) to (.., 1); m points rise on the right, at
// a distance of L = 10^7, 6 apart, each on a tangent of an arc like that on the left:
//
//   A_i = (3 a^2 / (2L), a),  a = -1 + 2i/(n - 1)
//   B_j = (L + 3 (2 T_j t - T_j^2) / (2L), t - T_j),  T_j = 6 (j + 1/2),  0 < t < 6m
//
// While B_j is opposite to the arc, the circle has a diameter A_i B_j for i = n - 1, .., 0 in turn,
// and passes through A_i, A_(i+1) and B_j in between: 2(n - 1) changes. From j to j + 1 there are
// n + 1: to A_0 B_j B_(j+1), then n - 1 flips of the farthest-point triangulation, A_i to A_(i+1),
// then to the diameter A_(n-1) B_(j+1). In all 2m(n - 1) + (m - 1)(n + 1) = 3nm - n - m - 1 changes
// of the circle, (n - 1)(m - 1) flips, and none of the hull.
void generate_seesaw(const lab::WorkloadParameters& parameters, Scene& scene) {
  const int n = parameters.n, m = parameters.m;
  const Rational far(10000000), bend = lab::fraction(3, 20000000);
  scene.start = 0;
  scene.end = Rational(6 * m);
  for (int i = 0; i < n; ++i) {
    const Rational a = lab::fraction(2 * i - (n - 1), n - 1);
    lab::add_object(scene, "a" + std::to_string(i), {{bend * a * a}, {a}});
  }
  for (int j = 0; j < m; ++j) {
    const Rational middle(6 * j + 3);
    lab::add_object(scene, "b" + std::to_string(j),
                    {{far - bend * middle * middle, Rational(2) * bend * middle},
                     {-middle, Rational(1)}});
  }
}

}  // namespace kinex::families
