// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/points/power_lines.h"

#include <cstdint>

#include "experiments/lab/workload_parts.h"

namespace kinex::families {

void add_power_lines(int n, Scene& scene) {
  scene.start = 0;
  Integer power_j(1);
  for (int j = 0; j < n; ++j) {
    lab::add_object(scene, function_name(j), {{-Rational(power_j), Rational(j)}});
    power_j *= Integer(2 * static_cast<std::int64_t>(n));
  }
}

}  // namespace kinex::families
