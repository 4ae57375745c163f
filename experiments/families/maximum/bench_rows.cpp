// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the benchmarks of this family.
#include "experiments/families/points/bench_rows.h"
#include "experiments/families/maximum/experiments.h"

namespace kinex::families {

std::vector<lab::BenchRow> maximum_bench_rows(int scale) {
  const auto n = [scale](int size) { return lab::scaled_size(size, scale); };
  const std::vector<std::string_view> three{"double", "exact", "gsl"};
  const std::string_view tournament = "maximum_tournament", random = "uniform-square";
  std::vector<lab::BenchRow> rows{lab::speed_row(tournament, random, 1, n(40000), three),
                                  lab::speed_row(tournament, random, 3, n(20000), three)};
  for (const int size : {1000, 10000, 100000}) {
    rows.push_back(random_row(tournament, 1, n(size)));
  }
  for (const char* other :
       {"maximum_heap", "maximum_hanger", "maximum_envelope", "maximum_dual_hull"}) {
    rows.push_back(random_row(other, 1, n(10000)));
  }
  rows.push_back(random_row("maximum_sorted_list", 1, n(1000)));
  add_common_rows(rows, tournament, scale, 2000);
  rows.push_back(queue_row("maximum_heap", 1, 10000, scale));
  add_scheduling_rows(rows, tournament, scale, 10000, {300, 300, 300});
  // What shares a structure with others, and what shares none.
  rows.push_back(shared_row({tournament}, scale));
  rows.push_back(shared_row({"sorted_list", tournament}, scale));
  rows.push_back(shared_row({"maximum_sorted_list"}, scale));
  rows.push_back(shared_row({"minimum_sorted_list"}, scale));
  rows.push_back(shared_row({"sorted_list", "maximum_sorted_list", "minimum_sorted_list"}, scale));
  return rows;
}

}  // namespace kinex::families
