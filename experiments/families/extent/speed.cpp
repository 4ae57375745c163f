// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of `bench/run speed` of this family.
#include "experiments/families/extent/calipers_experiments.h"
#include "experiments/families/extent/experiments.h"

namespace kinex::families {

std::vector<lab::SpeedRow> extent_speed_rows(int scale) {
  const auto n = [scale](int size) { return lab::scaled_size(size, scale); };
  const std::vector<const char*> two{"double", "exact"};
  std::vector<lab::SpeedRow> rows = caliper_speed_rows(scale);
  const std::vector<lab::SpeedRow> circles{
      {"bounding_box_2_hull", "uniform-square", 1, n(1000), two},
      {"min_circle_2", "uniform-square", 1, n(1000), two},
      {"min_circle_2", "seesaw", 1, n(32), two, 0, n(32)},
      {"min_circle_2_brute_force", "uniform-square", 1, n(200), two},
      {"directions_2", "box-worst", 1, n(1000), two},
      {"diameter_directions", "box-worst", 1, n(1000), two},
      {"width_directions", "box-worst", 1, n(1000), two}};
  rows.insert(rows.end(), circles.begin(), circles.end());
  return rows;
}

}  // namespace kinex::families
