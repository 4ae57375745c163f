// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/points/speed_rows.h"

namespace kinex::families {

lab::SpeedRow random_row(const char* structure, int degree, int n, std::uint64_t events) {
  return {structure, "uniform-square", degree, n, {"double", "exact"}, events};
}

lab::SpeedRow plans_row(const char* structure, int plans, int scale) {
  lab::SpeedRow row{structure, "walks", 1, lab::scaled_size(308, scale), {"double", "exact"}};
  row.m = lab::scaled_size(plans, scale);
  return row;
}

void add_common_rows(std::vector<lab::SpeedRow>& rows, const char* structure, int scale, int most) {
  for (const int size : {10, 30}) {
    for (const int degree : {1, 3}) rows.push_back(random_row(structure, degree, size));
  }
  for (const char* workload : {"lattice", "meet", "grid"}) {
    for (const int size : {30, lab::scaled_size(400, scale), lab::scaled_size(2000, scale)}) {
      if (size <= most) rows.push_back({structure, workload, 1, size, {"double", "exact"}});
    }
  }
}

}  // namespace kinex::families
