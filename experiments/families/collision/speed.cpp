// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of `bench/run speed` of this family.
#include "experiments/families/collision/experiments.h"

namespace kinex::families {

std::vector<lab::SpeedRow> collision_speed_rows(int scale) {
  const auto n = [scale](int size) { return lab::scaled_size(size, scale); };
  const std::vector<const char*> two{"double", "exact"};
  const int turns = scale > 1 ? 2 : 100;
  std::vector<lab::SpeedRow> rows;
  for (const int size : {8, 32, n(128)}) {
    rows.push_back({"separation_mixed", "polygon-gears", 1, size, two, 0, size - 1, 100, turns});
  }
  for (const char* other : {"separation_hysteresis", "closest_features", "inner_tangents"}) {
    rows.push_back(
        {other, "polygon-gears", 1, n(128), two, 0, n(128) - 1, 100, scale > 1 ? 2 : 20});
  }
  rows.push_back(
      {"separation_mixed", "polygon-spin-orbit", 1, n(128), two, 0, n(128) - 1, 100, turns});
  rows.push_back({"separation_minkowski", "polygon-orbit", 1, n(128), two});
  rows.push_back({"closest_features", "polygon-fan", 1, n(64), two});
  rows.push_back({"inner_tangents", "polygon-tangents", 1, n(64), two});
  for (const int degree : {1, 2, 3}) {
    rows.push_back({"separation_mixed", "polygon-random", degree, n(64), two});
  }
  for (const int size : {10, n(100), n(1000)}) {
    rows.push_back({"separation_mixed", "polygons-in-box", 1, size, two});
  }
  return rows;
}

}  // namespace kinex::families
