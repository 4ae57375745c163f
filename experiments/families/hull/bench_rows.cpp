// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the benchmarks of this family; its own benchmarks are in bench/.
#include "experiments/families/points/bench_rows.h"
#include "experiments/families/hull/experiments.h"

namespace kinex::families {

std::vector<lab::BenchRow> hull_bench_rows(int scale) {
  const auto n = [scale](int size) { return lab::scaled_size(size, scale); };
  const std::string_view local = "convex_hull_2";
  std::vector<lab::BenchRow> rows{random_row(local, 1, n(1000)), random_row(local, 1, n(10000)),
                                  random_row(local, 2, n(1000))};
  rows.push_back(random_row(local, 1, n(100000)));
  rows.back().rounds = 2;
  rows.push_back(random_row("convex_hull_2_naive", 1, n(1000)));
  rows.push_back(random_row("convex_hull_2_brute_force", 1, n(200)));
  rows.push_back(random_row("convex_hull_2_delaunay", 1, n(1000)));
  rows.push_back(plans_row(local, 100, scale));
  add_common_rows(rows, local, scale, 1000);
  rows.push_back(plane_row("naming", local, 1, n(1000), 3));
  // bench/hull.cpp
  const auto add = [&](std::string_view structure, int size, int rounds) {
    rows.push_back(plane_row("hull", structure, 1, n(size), rounds));
  };
  add(local, 1000, 5);
  add(local, 10000, 5);
  add(local, 100000, 2);
  add(local, 1000000, 1);
  rows.back().events = static_cast<std::uint64_t>(n(1000000));
  add("convex_hull_2_naive", 10000, 3);
  add("convex_hull_2_brute_force", 1000, 3);
  add("convex_hull_2_delaunay", 1000, 3);
  return rows;
}

}  // namespace kinex::families
