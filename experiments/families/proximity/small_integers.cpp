// SPDX-License-Identifier: GPL-3.0-or-later
// Pseudorandom scenes of small integers, for counts that another program can repeat.
#include <string>

#include "experiments/families/proximity/experiments.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

// A linear congruential generator, s := (1103515245 s + 12345) mod 2^31 from s = seed, gives
// floor(s / 2^16). For each point and each axis in turn: position next() mod 100, velocity
// (next() mod 41) - 20. 0 <= t <= 10.
void generate_small_integers(const lab::WorkloadParameters& parameters, Scene& scene) {
  std::uint64_t state = parameters.seed;
  const auto next = [&state] {
    state = (1103515245 * state + 12345) % (std::uint64_t{1} << 31);
    return static_cast<std::int64_t>(state >> 16);
  };
  scene.start = 0;
  scene.end = Rational(10);
  for (int i = 0; i < parameters.n; ++i) {
    std::vector<std::vector<Rational>> axes;
    for (int axis = 0; axis < parameters.dimension; ++axis) {
      const std::int64_t position = next() % 100, velocity = next() % 41 - 20;
      axes.push_back({lab::fraction(position, 1), lab::fraction(velocity, 1)});
    }
    lab::add_object(scene, "p" + std::to_string(i), std::move(axes));
  }
}

}  // namespace kinex::families
