// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes on the line that reach the largest number of events of two structures for a maximum.
#include "experiments/families/maximum/workloads.h"
#include "experiments/families/points/power_lines.h"
#include "experiments/formats/input_error.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

// f_i(t) = i t - 2^i with leaves in bit-reversed order: at every node of the tournament the two
// sides win alternately, so its winner changes once for every function below it: n log2(n) - n + 1
// failures.
void generate_tournament_worst(const lab::WorkloadParameters& parameters, Scene& scene) {
  const int n = parameters.n;
  if ((n & (n - 1)) != 0) {
    int below = 1;
    while (2 * below < n) below *= 2;
    const bool above = 2 * below <= lab::kMaxWorkloadSize;
    throw formats::InputError(
        "tournament-worst", "--n", show_text(std::to_string(n)) + " is not a power of two",
        "write " + std::to_string(below) + (above ? " or " + std::to_string(2 * below) : ""));
  }
  scene.start = 0;
  for (int leaf = 0; leaf < n; ++leaf) {
    int reversed = 0;
    for (int bit = 1; bit < n; bit *= 2) reversed = 2 * reversed + ((leaf & bit) != 0 ? 1 : 0);
    const Integer drop = Integer::power_of_two(static_cast<unsigned long>(reversed));
    lab::add_object(scene, function_name(reversed), {{-Rational(drop), Rational(reversed)}});
  }
}

// In array order every item rises to the root after all smaller ones are done, so the failures are
// the sum of the depths: floor(log2(j + 1)) over j = 0 .. n-1.
void generate_heap_worst(const lab::WorkloadParameters& parameters, Scene& scene) {
  add_power_lines(parameters.n, scene);
}

}  // namespace kinex::families
