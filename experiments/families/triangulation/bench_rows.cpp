// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the benchmarks of this family.
#include "experiments/families/points/bench_rows.h"
#include "experiments/families/triangulation/experiments.h"
#include "experiments/families/triangulation/floor.h"

namespace kinex::families {

namespace {

constexpr std::string_view kDelaunay = "delaunay_2", kRandom = "uniform-square";

std::vector<lab::BenchRow> speed_rows(int scale) {
  const auto n = [scale](int size) { return lab::scaled_size(size, scale); };
  const std::vector<std::string_view> three{"double", "exact", "gsl"};
  std::vector<lab::BenchRow> rows{lab::speed_row(kDelaunay, kRandom, 1, n(4000), three),
                                  lab::speed_row(kDelaunay, kRandom, 2, n(1000), three),
                                  lab::speed_row(kDelaunay, kRandom, 3, n(1000), three),
                                  random_row(kDelaunay, 1, n(10000)),
                                  random_row(kDelaunay, 1, n(1000))};
  // How the cost of an event grows with n.
  rows.push_back(random_row(kDelaunay, 1, n(1000), 50000));
  rows.push_back(random_row(kDelaunay, 1, n(10000), 200000));
  rows.push_back(random_row(kDelaunay, 1, n(100000), 400000));
  rows.push_back(random_row(kDelaunay, 1, n(1000000), static_cast<std::uint64_t>(n(1000000))));
  rows.push_back(plans_row(kDelaunay, 100, scale));
  add_common_rows(rows, kDelaunay, scale, 1000);
  rows.push_back(lab::speed_row(kDelaunay, kRandom, 1, n(200), {"exact", "sturm"}));
  for (lab::BenchRow& row : rows) {
    if (row.workload == kRandom) row.floor = run_delaunay_floor;
  }
  rows.push_back(random_row("delaunay_3", 1, n(500)));
  rows.push_back(random_row("delaunay_3", 1, n(5000), 300000));
  for (const std::string_view regular : {"regular_2", "regular_3"}) {
    const bool in_space = regular == "regular_3";
    rows.push_back(random_row(regular, 1, n(in_space ? 500 : 1000)));
    rows.push_back(lab::speed_row(regular, "random-weights", 1, n(in_space ? 500 : 1000)));
  }
  return rows;
}

}  // namespace

std::vector<lab::BenchRow> triangulation_bench_rows(int scale) {
  const auto n = [scale](int size) { return lab::scaled_size(size, scale); };
  std::vector<lab::BenchRow> rows = speed_rows(scale);
  add_fall_through_rows(rows, kDelaunay, scale);
  for (const int size : {1000, 10000}) rows.push_back(queue_row(kDelaunay, 1, size, scale));
  rows.push_back(queue_row(kDelaunay, 3, 1000, scale));
  add_scheduling_rows(rows, kDelaunay, scale, 500, {60, 24, 24});
  rows.push_back(plane_row("naming", kDelaunay, 1, n(1000), 3));
  rows.push_back(plane_row("naming", kDelaunay, 2, n(400), 3));
  rows.push_back(plane_row("naming", kDelaunay, 3, n(200), 3));
  add_requires_rows(rows, kDelaunay, scale);
  rows.push_back(shared_row({kDelaunay}, scale));
  rows.push_back(shared_row({"sorted_list", "maximum_tournament", kDelaunay}, scale));
  return rows;
}

}  // namespace kinex::families
