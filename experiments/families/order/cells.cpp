// SPDX-License-Identifier: GPL-3.0-or-later
// Questions: is the largest possible number of swaps reached exactly, and never exceeded? How many
//   swaps does random motion cause, and how do they grow with n?
// Sources: Guibas, "Kinetic data structures: a state of the art report" (1998), sections 5
//   to 7 for the bounds, section 9 for the law of growth; n(n-1)/4 in random motion, since the
//   orders at 0 and at 1 are independent.
// Parameters: see each family. The mean of random motion is known to 1 %.
// Expected: the integers below, in every run, audited after every event at small sizes; in random
//   motion also the exact count of every single scene.
// Cost: about 3 s, half a minute in full.
#include <utility>

#include "experiments/families/order/experiments.h"
#include "experiments/families/order/inversions.h"
#include "experiments/families/points/random_motion.h"
#include "experiments/lab/cell_parts.h"

namespace kinex::families {

namespace {

constexpr double kSortingError = 0.01;

// All C(n,2) pairs swap `degree` times.
void add_worst_case(lab::Catalogue& catalogue, int n, int degree, double cost) {
  lab::Cell cell = lab::worst_case_cell("sorted_list", "sort-worst", n, degree, cost);
  cell.expectations.push_back(lab::expect_exactly("sorted_list.worst_case", "processed",
                                             Integer(degree) * pairs(Integer(n)),
                                             "every pair swaps at every root: degree * n(n-1)/2"));
  catalogue.cells.push_back(std::move(cell));
}

void add_worst_cases(lab::Catalogue& catalogue, lab::Extent extent) {
  const bool full = extent == lab::Extent::kFull;
  for (const int n : {4, 8, 16, 32, 64}) add_worst_case(catalogue, n, 1, n * n * n * 1e-6);
  if (full) {
    for (const int n : {128, 256}) add_worst_case(catalogue, n, 1, n * n * n * 1e-6);
  }
  add_worst_case(catalogue, 5, 2, 0.01);
  add_worst_case(catalogue, 6, 3, 0.01);
  for (const int degree : {2, 3, 5}) {
    for (const int n : {8, 16, 32}) {
      if (n == 32 && degree == 5 && !full) continue;
      add_worst_case(catalogue, n, degree, degree * n * n * 2e-5);
    }
  }
}

void add_random_motion(lab::Catalogue& catalogue, lab::Extent extent) {
  for (const int n : {16, 32, 64, 128, 256, 512, 1024}) {
    if (n > 512 && extent == lab::Extent::kQuick) continue;
    lab::Cell cell = uniform_cell("sorted_list", n, 1);
    cell.precise = {{"processed", kSortingError}};
    cell.expectations.push_back(
        lab::expect_mean("sorted_list.uniform", "processed", n * (n - 1) / 4.0,
                    "E = n(n-1)/4: independent orders; Guibas 1998, section 9"));
    cell.expectations.push_back(lab::expect_witness("sorted_list.inversions", "processed", inversions,
                                               "inversions between the first and the last order"));
    cell.cost = 0.3;
    catalogue.cells.push_back(std::move(cell));
  }
  add_uniform_growth(catalogue, "sorted_list.uniform.growth", "sorted_list", 16, 2,
                     "Theta(n^2) swaps even in expectation; Guibas 1998, section 9");
}

}  // namespace

void add_order_cells(lab::Catalogue& catalogue, lab::Extent extent) {
  add_worst_cases(catalogue, extent);
  add_random_motion(catalogue, extent);
}

}  // namespace kinex::families
