// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of `bench/run speed` of this family.
#include "experiments/families/maximum/experiments.h"
#include "experiments/families/points/speed_rows.h"

namespace kinex::families {

std::vector<lab::SpeedRow> maximum_speed_rows(int scale) {
  const auto n = [scale](int size) { return lab::scaled_size(size, scale); };
  const std::vector<const char*> three{"double", "exact", "gsl"};
  std::vector<lab::SpeedRow> rows{{"maximum_tournament", "uniform-square", 1, n(40000), three},
                             {"maximum_tournament", "uniform-square", 3, n(20000), three}};
  for (const int size : {1000, 10000, 100000}) {
    rows.push_back(random_row("maximum_tournament", 1, n(size)));
  }
  rows.push_back(random_row("maximum_heap", 1, n(10000)));
  rows.push_back(random_row("maximum_hanger", 1, n(10000)));
  add_common_rows(rows, "maximum_tournament", scale, 2000);
  return rows;
}

}  // namespace kinex::families
