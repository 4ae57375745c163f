// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of `bench/run speed` of this family: swaps, with the trees that follow them.
#include "experiments/families/points/speed_rows.h"
#include "experiments/families/range/experiments.h"

namespace kinex::families {

std::vector<lab::SpeedRow> range_speed_rows(int scale) {
  const int n = lab::scaled_size(2000, scale);
  return {random_row("range_tree_2", 1, n, 400000), random_row("rank_kd_tree_2", 1, n, 400000),
          random_row("pseudo_kd_tree_2", 1, n, 400000)};
}

}  // namespace kinex::families
