// SPDX-License-Identifier: GPL-3.0-or-later
// Questions: does the closest pair change exactly as often as counted by hand? Does it keep its
//   bounds in random motion?
// Source: pass_over_row.cpp counts n(m + 1) changes.
// Expected: the integers below, in every run; every hard bound, and every audit.
// Cost: about 5 s.
#include <utility>

#include "experiments/families/points/random_motion.h"
#include "experiments/families/proximity/experiments.h"
#include "experiments/lab/cell_parts.h"

namespace kinex::families {

void add_proximity_cells(lab::Catalogue& catalogue, lab::Extent extent) {
  for (const int size : {2, 3, 4, 6, 8, 12}) {
    if (size > 8 && extent == lab::Extent::kQuick) continue;
    lab::Cell cell = lab::worst_case_cell("closest_pair_delaunay", "pass-over-row", size, 1, 0.5);
    cell.parameters.m = size;
    cell.audit = size <= 6 ? AuditLevel::kEvents : AuditLevel::kEnd;
    cell.expectations.push_back(
        lab::expect_exactly("closest_pair.pass_over_row", "external", Integer(size * (size + 1)),
                       "each of n points is nearest to each of m in turn, and leaves: n(m + 1)"));
    catalogue.cells.push_back(std::move(cell));
  }
  for (const int n : {16, 64, 256}) {
    lab::Cell cell = uniform_cell("closest_pair_delaunay", n, 2);
    cell.cost = n / 100.0;
    catalogue.cells.push_back(std::move(cell));
  }
}

}  // namespace kinex::families
