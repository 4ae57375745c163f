// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of `bench/run speed` of this family.
#include "experiments/families/hull/experiments.h"
#include "experiments/families/points/speed_rows.h"

namespace kinex::families {

std::vector<lab::SpeedRow> hull_speed_rows(int scale) {
  const auto n = [scale](int size) { return lab::scaled_size(size, scale); };
  std::vector<lab::SpeedRow> rows{random_row("convex_hull_2", 1, n(1000)),
                             random_row("convex_hull_2", 1, n(10000)),
                             random_row("convex_hull_2", 2, n(1000))};
  rows.push_back(plans_row("convex_hull_2", 100, scale));
  add_common_rows(rows, "convex_hull_2", scale, 1000);
  return rows;
}

}  // namespace kinex::families
