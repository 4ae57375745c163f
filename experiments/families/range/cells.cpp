// SPDX-License-Identifier: GPL-3.0-or-later
// Questions: do the trees for range search follow every swap of both orders, and within their hard
//   bounds? How many swaps does random motion cause?
// Sources: all pairs of plane_sort_worst.cpp swap on both axes; in random motion the orders at 0
//   and at 1 are independent, so an axis has n(n-1)/4 swaps in expectation.
//   A tree over trajectories has no event.
// Expected: the integers below, in every run; the means; every bound, every audit (which asks
//   boxes, too, and compares the answers with CGAL's).
// Cost: about 10 s.
#include <utility>

#include "experiments/families/points/random_motion.h"
#include "experiments/families/range/experiments.h"
#include "experiments/lab/cell_parts.h"

namespace kinex::families {
namespace {

constexpr const char* kTrees[] = {"range_tree_2", "rank_kd_tree_2", "pseudo_kd_tree_2"};

void add_worst(lab::Catalogue& catalogue, const char* tree, int n) {
  lab::Cell cell = lab::worst_case_cell(tree, "plane-sort-worst", n, 1, n * n * n * 4e-6);
  if (tree == kTrees[0]) {
    cell.expectations.push_back(
        lab::expect_exactly("range_tree_2.worst_case", "external", Integer(n) * Integer(n - 1),
                            "every pair swaps once on either axis: n(n-1)"));
  }
  catalogue.cells.push_back(std::move(cell));
}

void add_random(lab::Catalogue& catalogue, const char* tree, int n) {
  lab::Cell cell = uniform_cell(tree, n, 2);
  cell.precise = {{"external", 0.03}};
  if (tree == kTrees[0]) {
    cell.precise = {{"external", 0.01}};
    cell.expectations.push_back(
        lab::expect_mean("range_tree_2.uniform", "external", n * (n - 1) / 2.0,
                         "E = n(n-1)/4 an axis: independent orders; Guibas 1998, section 9"));
  }
  cell.cost = n * n * 1e-5;
  catalogue.cells.push_back(std::move(cell));
}

// Linear motion only, and nothing ever happens.
void add_static(lab::Catalogue& catalogue, int n) {
  lab::Cell cell = lab::worst_case_cell("trajectory_tree", "plane-sort-worst", n, 1, n * n * 4e-6);
  cell.expectations.push_back(lab::expect_exactly("trajectory_tree.static", "external", Integer(0),
                                                  "the trajectories do not change"));
  catalogue.cells.push_back(std::move(cell));
}

}  // namespace

void add_range_cells(lab::Catalogue& catalogue, lab::Extent extent) {
  for (const int n : {2, 8, 32}) add_static(catalogue, n);
  for (const char* const tree : kTrees) {
    for (const int n : {2, 4, 8, 16, 32, 64}) {
      if (n > 32 && extent == lab::Extent::kQuick) continue;
      add_worst(catalogue, tree, n);
    }
    for (const int n : {16, 64, 256}) {
      if (n > 64 && extent == lab::Extent::kQuick) continue;
      add_random(catalogue, tree, n);
    }
  }
}

}  // namespace kinex::families
