// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of `bench/run speed` of this family.
#include "experiments/families/points/speed_rows.h"
#include "experiments/families/triangulation/experiments.h"

namespace kinex::families {

std::vector<lab::SpeedRow> triangulation_speed_rows(int scale) {
  const auto n = [scale](int size) { return lab::scaled_size(size, scale); };
  const std::vector<const char*> three{"double", "exact", "gsl"}, reference{"exact", "sturm"};
  const char* const random = "uniform-square";
  std::vector<lab::SpeedRow> rows{{"delaunay_2", random, 1, n(4000), three},
                             {"delaunay_2", random, 2, n(1000), three},
                             {"delaunay_2", random, 3, n(1000), three},
                             random_row("delaunay_2", 1, n(10000))};
  // How the cost of an event grows with n.
  rows.push_back(random_row("delaunay_2", 1, n(1000), 50000));
  rows.push_back(random_row("delaunay_2", 1, n(10000), 200000));
  rows.push_back(random_row("delaunay_2", 1, n(100000), 400000));
  rows.push_back(random_row("delaunay_2", 1, n(1000000), static_cast<std::uint64_t>(n(1000000))));
  rows.push_back(plans_row("delaunay_2", 100, scale));
  add_common_rows(rows, "delaunay_2", scale, 1000);
  rows.push_back({"delaunay_2", random, 1, n(200), reference});
  rows.push_back(random_row("delaunay_3", 1, n(500)));
  rows.push_back(random_row("delaunay_3", 1, n(5000), 300000));
  return rows;
}

}  // namespace kinex::families
