// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of which every one is on the bounding box in every axis.
#include <string>

#include "experiments/families/extent/experiments.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

// In axis k point i is the line h + s t whose dual point (s, h) is on the unit circle, at the
// parameter a = (6 - k)/n (i - (n-1)/2 + 1/(7 - 2k)):
//   (h, s) = ((1 - a^2)/(1 + a^2), 2a/(1 + a^2)), or (s, h) for every other axis.
// All n dual points are on their convex hull, whose upper and lower chains are the two envelopes
// and have their two ends in common: n + 2 pieces, n changes of the two sides. (Two lines exchange both
// sides at one instant, which is one external event an axis.) The parameters of
// two axes differ, so that no two axes change at one instant.
void generate_box_worst(const lab::WorkloadParameters& parameters, Scene& scene) {
  const int n = parameters.n;
  scene.start = Rational(-1000000);
  scene.end = Rational(1000000);
  for (int i = 0; i < n; ++i) {
    std::vector<std::vector<Rational>> axes;
    for (int k = 0; k < parameters.dimension; ++k) {
      const Rational a =
          lab::fraction(6 - k, n) * (lab::fraction(2 * i - n + 1, 2) + lab::fraction(1, 7 - 2 * k));
      const Rational all = Rational(1) + a * a;
      const Rational u = (Rational(1) - a * a) / all, v = Rational(2) * a / all;
      axes.push_back(k % 2 == 0 ? std::vector<Rational>{u, v} : std::vector<Rational>{v, u});
    }
    lab::add_object(scene, "p" + std::to_string(i), std::move(axes));
  }
}

}  // namespace kinex::families
