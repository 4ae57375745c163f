// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/order/family.h"

#include "experiments/families/order/experiments.h"
#include "experiments/families/order/workloads.h"

namespace kinex::families {

lab::FamilyExperiments order_experiments() {
  lab::FamilyExperiments family;
  family.name = "order";
  family.usual = {{false, 0, "sorted_list"}};
  family.workloads = {{"sort-worst", "every pair swaps --degree times", 1, 1, 1, false, true, false,
                       "sorted_list", generate_sort_worst}};
  family.add_cells = add_order_cells;
  family.event_bounds = {"swaps"};
  family.trade = {{"sorted_list",
                   1,
                   {24, 64},
                   "sort-worst",
                   {24, 64},
                   {25, 64},
                   {16, 48},
                   {{8, 16, 32, 64}, {8, 16, 32, 64, 128, 256}}}};
  family.bench_rows = order_bench_rows;
  return family;
}

}  // namespace kinex::families
