// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the benchmarks of this family.
#include "experiments/families/points/bench_rows.h"
#include "experiments/families/order/experiments.h"
#include "experiments/families/order/floor.h"

namespace kinex::families {

namespace {

constexpr std::string_view kList = "sorted_list", kRandom = "uniform-square";

std::vector<lab::BenchRow> speed_rows(int scale) {
  const auto n = [scale](int size) { return lab::scaled_size(size, scale); };
  const std::vector<std::string_view> three{"double", "exact", "gsl"};
  std::vector<lab::BenchRow> rows{lab::speed_row(kList, kRandom, 1, n(4000), three),
                                  lab::speed_row(kList, kRandom, 2, n(2000), three),
                                  lab::speed_row(kList, kRandom, 3, n(2000), three)};
  // How the cost of an event grows with n.
  for (const int size : {1000, 10000, 100000}) {
    rows.push_back(random_row(kList, 1, n(size), 400000));
  }
  rows.push_back(plans_row(kList, 368, scale));
  add_common_rows(rows, kList, scale, 2000);
  rows.push_back(lab::speed_row(kList, kRandom, 1, n(400), {"exact", "sturm"}));
  for (lab::BenchRow& row : rows) {
    if (row.workload == kRandom) row.floor = run_list_floor;
  }
  return rows;
}

}  // namespace

std::vector<lab::BenchRow> order_bench_rows(int scale) {
  const auto n = [scale](int size) { return lab::scaled_size(size, scale); };
  std::vector<lab::BenchRow> rows = speed_rows(scale);
  add_fall_through_rows(rows, kList, scale);
  for (const int size : {1000, 10000}) rows.push_back(queue_row(kList, 1, size, scale));
  add_scheduling_rows(rows, kList, scale, 1000, {80, 80, 80});
  rows.push_back(plane_row("naming", kList, 1, n(600), 3));
  rows.push_back(plane_row("naming", kList, 2, n(400), 3));
  add_requires_rows(rows, kList, scale);
  rows.push_back(shared_row({kList}, scale));
  return rows;
}

}  // namespace kinex::families
