// SPDX-License-Identifier: GPL-3.0-or-later
// Pseudorandom scenes of small integers, for counts that another program can repeat.
#include <string>

#include "experiments/families/proximity/experiments.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

// lab::RepeatableNumbers: for each point and each axis in turn a position in 0 .. 99 and a velocity in
// -20 .. 20. 0 <= t <= 10.
void generate_small_integers(const lab::WorkloadParameters& parameters, Scene& scene) {
  lab::RepeatableNumbers numbers(parameters.seed);
  scene.start = 0;
  scene.end = Rational(10);
  for (int i = 0; i < parameters.n; ++i) {
    std::vector<std::vector<Rational>> axes;
    for (int axis = 0; axis < parameters.dimension; ++axis) axes.push_back(numbers.line());
    lab::add_object(scene, "p" + std::to_string(i), std::move(axes));
  }
}

}  // namespace kinex::families
