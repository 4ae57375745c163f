// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the benchmarks of this family.
#include <string>

#include "experiments/families/points/bench_rows.h"
#include "experiments/families/range/experiments.h"

namespace kinex::families {

namespace {

const std::vector<std::string_view>& trees() {
  static const std::vector<std::string_view> kTrees{"range_tree_2", "rank_kd_tree_2",
                                                    "pseudo_kd_tree_2"};
  return kTrees;
}

Request request(std::string_view structure) {
  return {std::string(structure), std::string(structure), {}};
}

// Swaps: the lists alone, with each tree, and with all.
void add_swaps(std::vector<lab::BenchRow>& rows, int n, std::uint64_t events) {
  Request x = request("sorted_list"), y = x;
  x.label = "x";
  y.label = "y";
  y.key.kind = Key::Kind::kCoordinate;
  y.key.axis = 1;
  std::vector<lab::BenchRow> swaps(trees().size() + 2,
                                   plane_row("queries_swaps", "lists", 1, n, 5));
  swaps.front().maintain = {x, y};
  swaps.back().structure = "all three";
  for (std::size_t i = 0; i < trees().size(); ++i) {
    swaps[i + 1].structure = trees()[i];
    swaps.back().maintain.push_back(request(trees()[i]));
  }
  for (lab::BenchRow& row : swaps) {
    row.events = events;
    rows.push_back(row);
  }
}

}  // namespace

std::vector<lab::BenchRow> range_bench_rows(int scale) {
  const auto n = [scale](int size) { return lab::scaled_size(size, scale); };
  std::vector<lab::BenchRow> rows;
  // Swaps, with the trees that follow them.
  for (const std::string_view tree : trees()) {
    rows.push_back(random_row(tree, 1, n(2000), 400000));
  }
  for (const std::string_view tree : trees()) {
    rows.push_back(plane_row("queries", tree, 1, n(100000), 5));
  }
  rows.push_back(plane_row("queries", "trajectory_tree", 1, n(100000), 5));
  for (const int size : {2000, 10000, 100000}) {
    add_swaps(rows, n(size), static_cast<std::uint64_t>(n(400000)));
  }
  return rows;
}

}  // namespace kinex::families
