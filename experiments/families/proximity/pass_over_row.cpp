// SPDX-License-Identifier: GPL-3.0-or-later
// A closest pair that changes n(m + 1) times, as can be counted by hand.
#include <string>

#include "experiments/families/proximity/experiments.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

// m points rest in a row, 10 apart. n points pass over it at a height of 1, one after another, so
// far apart that at most one of them is nearer than 10 to the row:
//
//      .  -->                 .  -->
//           o    o    o    o                one of m = 4 points at rest is the nearest
//
// While no moving point is near, the closest pair is the row's first two points: all neighbours are
// at identically equal distances, and this is the smallest pair. A point that passes forms the
// closest pair with each of the m points, one after another, at most sqrt(26) apart; afterwards the
// first two are the closest pair again: m + 1 changes.
void generate_pass_over_row(const lab::WorkloadParameters& parameters, Scene& scene) {
  const int n = parameters.n, m = parameters.m;
  const std::int64_t gap = 10 * std::int64_t{m} + 17;
  scene.start = 0;
  scene.end = lab::fraction(gap * (n + 1), 1);
  for (int i = 0; i < m; ++i) {
    lab::add_object(scene, "row" + std::to_string(i), {{Rational(10 * i)}, {Rational(0)}});
  }
  for (int j = 0; j < n; ++j) {
    lab::add_object(scene, "p" + std::to_string(j),
                    {{lab::fraction(-20 - gap * j, 1), Rational(1)}, {Rational(1)}});
  }
}

}  // namespace kinex::families
