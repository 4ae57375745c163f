// SPDX-License-Identifier: GPL-3.0-or-later
// Points that pass between two skew rows of n points each, at rest: the triangulation in space has a
// cell for every pair of their edges, and each point that passes changes all of them.
#include <cstdint>
#include <string>

#include "experiments/families/triangulation/experiments.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

// A_i = (x_i, e i^2, -80 - e i^3), B_i = (e i^2, x_i + 3/n, 80 + e i^3) for x_i = (120 i - 60 (n-1)) / n
// and e = 1/n^4, i < n, at rest; (1 + k/1000, 2 + k^2/1000, t - 10^4 k), k < m, for all times that matter.
//
// The sphere through two neighbours of A and two of B, about a and b from the middle along x and
// along y, has its centre near (a, b, (a^2 - b^2) / 320), and holds a piece of the line x = 1, y = 2
// within the radius 82 that the rows keep. So a point that comes along this line is in all
// (n-1)^2 spheres for a while. In rows of fixed gaps (skew_curves.cpp) the far spheres hold no piece
// of it. e is so small that the cells are those of straight rows, and not zero, so that no four points
// are cocircular and no three on a line.
void generate_skew_rows(const lab::WorkloadParameters& parameters, Scene& scene) {
  const std::int64_t n = parameters.n, m = parameters.m, fourth = n * n * n * n;
  scene.start = -10000000;
  scene.end = Rational(10000000 + 10000 * m);
  for (std::int64_t i = 0; i < n; ++i) {
    const std::string number = std::to_string(i);
    const Rational along = lab::fraction(120 * i - 60 * (n - 1), n);
    const Rational aside = lab::fraction(i * i, fourth);
    const Rational above = Rational(80) + lab::fraction(i * i * i, fourth);
    lab::add_object(scene, "a" + number, {{along}, {aside}, {-above}});
    lab::add_object(scene, "b" + number, {{aside}, {along + lab::fraction(3, n)}, {above}});
  }
  for (std::int64_t k = 0; k < m; ++k) {
    lab::add_object(scene, "p" + std::to_string(k),
                    {{Rational(1) + lab::fraction(k, 1000)},
                     {Rational(2) + lab::fraction(k * k, 1000)},
                     {lab::fraction(-10000 * k, 1), Rational(1)}});
  }
}

}  // namespace kinex::families
