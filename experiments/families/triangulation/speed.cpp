// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of `bench/run speed` of this family.
#include "experiments/families/points/speed_rows.h"
#include "experiments/families/triangulation/experiments.h"

namespace kinex {

std::vector<SpeedRow> triangulation_speed_rows(int scale) {
  const auto n = [scale](int size) { return scaled_size(size, scale); };
  const std::vector<const char*> three{"double", "exact", "gsl"}, reference{"exact", "sturm"};
  const char* const random = "uniform-square";
  std::vector<SpeedRow> rows{{"delaunay_2", random, 1, n(4000), three},
                             {"delaunay_2", random, 2, n(1000), three},
                             {"delaunay_2", random, 3, n(1000), three},
                             random_row("delaunay_2", 1, n(10000))};
  // How the cost of an event grows with n.
  rows.push_back(random_row("delaunay_2", 1, n(1000), 50000));
  rows.push_back(random_row("delaunay_2", 1, n(10000), 200000));
  rows.push_back(random_row("delaunay_2", 1, n(100000), 400000));
  add_common_rows(rows, "delaunay_2", scale, 1000);
  rows.push_back({"delaunay_2", random, 1, n(200), reference});
  return rows;
}

}  // namespace kinex
