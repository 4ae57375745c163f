// SPDX-License-Identifier: GPL-3.0-or-later
// Questions: does the pair of discs of the smallest gap change exactly as often as counted by hand? Does
//   it keep its bounds in random motion?
// Source: extents.cpp counts the changes.
// Expected: the integers below, in every run; every hard bound, and every audit.
// Cost: about 5 s.
#include <string>
#include <utility>

#include "experiments/families/proximity/experiments.h"
#include "experiments/lab/cell_parts.h"

namespace kinex::families {
namespace {

constexpr const char* kStructure = "closest_pair_discs";

void add_exactly(lab::Catalogue& catalogue, lab::Cell cell, std::string claim, int count,
                 std::string source) {
  cell.audit = AuditLevel::kEvents;
  cell.expectations.push_back(
      lab::expect_exactly(std::move(claim), "external", Integer(count), std::move(source)));
  catalogue.cells.push_back(std::move(cell));
}

}  // namespace

void add_gap_cells(lab::Catalogue& catalogue, lab::Extent extent) {
  for (const auto& [m, n] : {std::pair{2, 2}, {3, 2}, {4, 2}, {4, 4}, {6, 6}, {8, 8}, {12, 12}}) {
    if (m > 8 && extent == lab::Extent::kQuick) continue;
    lab::Cell cell = lab::worst_case_cell(kStructure, "gaps-along-row", n, 1, 0.3);
    cell.parameters.m = m;
    add_exactly(catalogue, std::move(cell), "closest_pair_discs.all_pairs", n * m - 1,
                "all nm pairs have the smallest gap in turn: nm - 1");
  }
  for (const int n : {3, 4, 5, 6}) {
    add_exactly(catalogue, lab::worst_case_cell(kStructure, "fan-of-discs", n, 1, 0.1),
                "closest_pair_discs.fan", 2, "no two meet before and after all centres coincide: 2");
  }
  for (const int n : {3, 5}) {
    lab::Cell cell = lab::worst_case_cell(kStructure, "fan-of-discs", n, 1, 0.1);
    cell.parameters.dimension = 3;
    add_exactly(catalogue, std::move(cell), "closest_pair_discs.fan", 2,
                "no two meet before and after all centres coincide: 2");
  }
  {
    lab::Cell cell = lab::worst_case_cell(kStructure, "apart-discs", 8, 1, 0.3);
    cell.question = "Do the hard bounds hold?";
    cell.parameters.dimension = 3;
    cell.random = true;
    cell.audit = AuditLevel::kEvents;
    catalogue.cells.push_back(std::move(cell));
  }
  for (const int n : {16, 64, 256}) {
    if (n > 64 && extent == lab::Extent::kQuick) continue;
    for (const char* const workload : {"apart-discs", "random-discs"}) {
      lab::Cell cell;
      cell.question = "Do the hard bounds hold?";
      cell.structure = kStructure;
      cell.workload = workload;
      cell.parameters.n = n;
      cell.family = cell.workload;
      cell.random = true;
      cell.min_seeds = cell.max_seeds = n <= 16 ? 1 : 4;
      cell.audit = n <= 16 ? AuditLevel::kEvents : AuditLevel::kEnd;
      cell.cost = n / 50.0;
      catalogue.cells.push_back(std::move(cell));
    }
  }
}

}  // namespace kinex::families
