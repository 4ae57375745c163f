// SPDX-License-Identifier: GPL-3.0-or-later
// Questions: do the closest pair and the minimum spanning tree change exactly as often as counted by
//   hand, or by brute force? Do they keep their bounds in random motion?
// Sources: pass_over_row.cpp and pass_along_row.cpp count changes. Those of small integers were
//   counted by brute force over exact positions between all critical times, by another program.
// Expected: the integers below, in every run; every hard bound, and every audit.
// Cost: about 20 s, some seconds more in full.
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "experiments/families/points/random_motion.h"
#include "experiments/families/proximity/experiments.h"
#include "experiments/lab/cell_parts.h"

namespace kinex::families {
namespace {

constexpr int kAuditedRow = 8;  // the longest row of which every event is audited

constexpr const char* kTrees[] = {"emst_list", "emst_cycles", "emst_clusters"};

void add_exact(lab::Catalogue& catalogue, lab::Cell cell, std::string claim, int count,
               std::string source) {
  cell.audit = cell.parameters.m <= kAuditedRow ? AuditLevel::kEvents : AuditLevel::kEnd;
  cell.expectations.push_back(
      lab::expect_exactly(std::move(claim), "external", Integer(count), std::move(source)));
  catalogue.cells.push_back(std::move(cell));
}

// Every moving point meets every point of the row.
void add_rows(lab::Catalogue& catalogue, int size) {
  const auto cell_of = [size](const char* structure) {
    lab::Cell cell = lab::worst_case_cell(structure, "pass-along-row", size, 1, 0.5);
    cell.parameters.m = size;
    return cell;
  };
  add_exact(catalogue, cell_of("closest_pair_delaunay"), "closest_pair.all_pairs", size * size - 1,
            "all nm pairs are the closest in turn: nm - 1");
  for (const char* tree : kTrees) {
    add_exact(catalogue, cell_of(tree), "emst.rows", 2 * size * size - 2,
              "two changes at every gap of the row: 2nm - 2");
  }
}

void add_small_integers(lab::Catalogue& catalogue) {
  struct Counted {
    int n, dimension;
    std::uint64_t seed;
    int pair, tree;
  };
  for (const Counted& one : {Counted{6, 2, 1, 4, 7},
                             {8, 2, 1, 5, 14},
                             {10, 2, 2, 8, 22},
                             {12, 2, 3, 7, 20},
                             {6, 3, 1, 4, 7},
                             {7, 3, 2, 7, 11},
                             {8, 3, 1, 5, 13}}) {
    const auto cell_of = [&one](const char* structure) {
      lab::Cell cell = lab::worst_case_cell(structure, "small-integers", one.n, 1, 0.1);
      cell.parameters.seed = one.seed;
      if (one.dimension != 2) cell.parameters.dimension = one.dimension;
      return cell;
    };
    const char* const source = "counted by brute force over exact positions";
    add_exact(catalogue, cell_of("closest_pair_delaunay"), "closest_pair.small_integers", one.pair,
              source);
    for (const char* tree : kTrees) {
      add_exact(catalogue, cell_of(tree), "emst.small_integers", one.tree, source);
    }
  }
}

}  // namespace

void add_proximity_cells(lab::Catalogue& catalogue, lab::Extent extent) {
  for (const int size : {2, 3, 4, 6, 8, 12}) {
    if (size > 8 && extent == lab::Extent::kQuick) continue;
    lab::Cell cell = lab::worst_case_cell("closest_pair_delaunay", "pass-over-row", size, 1, 0.5);
    cell.parameters.m = size;
    cell.audit = size <= 6 ? AuditLevel::kEvents : AuditLevel::kEnd;
    cell.expectations.push_back(lab::expect_exactly(
        "closest_pair.pass_over_row", "external", Integer(size * (size + 1)),
        "each of n points is nearest to each of m in turn, and leaves: n(m + 1)"));
    catalogue.cells.push_back(std::move(cell));
  }
  for (const int size : {3, 4, 5, 8, 16, 32}) {
    if (size > 5 && extent == lab::Extent::kQuick) continue;
    add_rows(catalogue, size);
  }
  add_small_integers(catalogue);
  add_octant_cells(catalogue, extent);
  add_pair_cells(catalogue, extent);
  add_graph_cells(catalogue, extent);
  add_meeting_cells(catalogue, extent);
  add_gap_cells(catalogue, extent);
  for (const char* structure :
       {"closest_pair_delaunay", "emst_list", "emst_cycles", "emst_clusters"}) {
    for (const int n : {16, 64, 256}) {
      // Most failures of the list exchange edges that are far apart: 200,000 a run at n = 256.
      const bool long_run = std::string_view(structure) == "emst_list" && n > 64;
      if (long_run && extent == lab::Extent::kQuick) continue;
      lab::Cell cell = uniform_cell(structure, n, 2);
      cell.precise = {{"external", kChangesError}};
      cell.cost = n / 100.0;
      catalogue.cells.push_back(std::move(cell));
    }
  }
}

}  // namespace kinex::families
