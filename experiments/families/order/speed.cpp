// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of `bench/run speed` of this family.
#include "experiments/families/order/experiments.h"
#include "experiments/families/points/speed_rows.h"

namespace kinex::families {

std::vector<lab::SpeedRow> order_speed_rows(int scale) {
  const auto n = [scale](int size) { return lab::scaled_size(size, scale); };
  const std::vector<const char*> three{"double", "exact", "gsl"}, reference{"exact", "sturm"};
  const char* const random = "uniform-square";
  std::vector<lab::SpeedRow> rows{{"sorted_list", random, 1, n(4000), three},
                             {"sorted_list", random, 2, n(2000), three},
                             {"sorted_list", random, 3, n(2000), three}};
  // How the cost of an event grows with n.
  for (const int size : {1000, 10000, 100000}) {
    rows.push_back(random_row("sorted_list", 1, n(size), 400000));
  }
  rows.push_back(plans_row("sorted_list", 368, scale));
  add_common_rows(rows, "sorted_list", scale, 2000);
  rows.push_back({"sorted_list", random, 1, n(400), reference});
  return rows;
}

}  // namespace kinex::families
