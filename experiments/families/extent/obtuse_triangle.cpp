// SPDX-License-Identifier: GPL-3.0-or-later
// A triangle whose smallest circle changes while its hull and its triangulation do not.
#include <string>

#include "experiments/families/extent/experiments.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

//   a = (0, 0),  b = (4, 0),  c = (t - 2, 1),  0 <= t <= 8
//
//   t      2              4 - sqrt 3       4 + sqrt 3              6
//   bc     |     abc          |      ab        |        abc        |      ac
//
// The circle is on the side opposite to an obtuse angle, else it goes through all three: 4 changes.
// n - 3 more points, at rest at (2, i / (4n)), are inside the triangle all the time.
void generate_obtuse_triangle(const lab::WorkloadParameters& parameters, Scene& scene) {
  scene.start = 0;
  scene.end = Rational(8);
  lab::add_object(scene, "a", {{Rational(0)}, {Rational(0)}});
  lab::add_object(scene, "b", {{Rational(4)}, {Rational(0)}});
  lab::add_object(scene, "c", {{Rational(-2), Rational(1)}, {Rational(1)}});
  for (int i = 1; i + 2 < parameters.n; ++i) {
    lab::add_object(scene, "p" + std::to_string(i),
                    {{Rational(2)}, {lab::fraction(i, 4 * parameters.n)}});
  }
}

}  // namespace kinex::families
