// SPDX-License-Identifier: GPL-3.0-or-later
// Questions: do points change sides of moving lines exactly as often as counted by hand, or by brute
//   force? Do the structures keep their bounds in random motion?
// Sources: lines_and_points.cpp counts the changes of points through lines; those of small integers
//   are the roots of the polynomials of all pairs, found by another program.
// Expected: the integers below, in every run; every hard bound, and every audit.
// Cost: about 10 s.
#include <cstdint>
#include <string>
#include <utility>

#include "experiments/families/arrangement/experiments.h"
#include "experiments/lab/cell_parts.h"

namespace kinex::families {
namespace {

constexpr const char* kIncidences[] = {"incidences_all"};

void add_exactly(lab::Catalogue& catalogue, lab::Cell cell, std::string claim,
                 const char* quantity, int count, std::string source) {
  cell.audit = AuditLevel::kEvents;
  cell.expectations.push_back(
      lab::expect_exactly(std::move(claim), quantity, Integer(count), std::move(source)));
  catalogue.cells.push_back(std::move(cell));
}

lab::Cell small_cell(const char* structure, const char* workload, int n, std::uint64_t seed) {
  lab::Cell cell = lab::worst_case_cell(structure, workload, n, 1, 0.1);
  cell.parameters.seed = seed;
  return cell;
}

lab::Cell random_cell(const char* structure, const char* workload, int n, double cost) {
  lab::Cell cell;
  cell.question = "Do the hard bounds hold?";
  cell.structure = structure;
  cell.workload = workload;
  cell.parameters.n = n;
  cell.family = cell.workload;
  cell.random = true;
  cell.min_seeds = cell.max_seeds = 4;
  cell.audit = n <= 16 ? AuditLevel::kEvents : AuditLevel::kEnd;
  cell.cost = cost;
  return cell;
}

void add_incidence_cells(lab::Catalogue& catalogue, lab::Extent extent) {
  struct Sizes {
    int n, m;
  };
  for (const char* const structure : kIncidences) {
    for (const auto& [n, m] : {Sizes{2, 2}, Sizes{3, 4}, Sizes{8, 8}}) {
      lab::Cell cell = lab::worst_case_cell(structure, "points-through-lines", n, 1, 0.1);
      cell.parameters.m = m;
      add_exactly(catalogue, std::move(cell), "incidences.hard_bound", "external", 2 * n * m,
                  "every point is on every line twice: 2nm");
    }
    struct Counted {
      int n;
      std::uint64_t seed;
      int external;
    };
    for (const Counted& one : {Counted{6, 1, 6}, {8, 1, 12}, {10, 2, 18}, {12, 3, 30}}) {
      add_exactly(catalogue,
                  small_cell(structure, "small-lines-and-points", one.n, one.seed),
                  "incidences.small_integers", "external", one.external,
                  "the roots of the polynomials of all pairs");
    }
    for (const int n : {16, 64, 256}) {
      if (n > 64 && extent == lab::Extent::kQuick) continue;
      lab::Cell cell =
          random_cell(structure, "random-lines-and-points", n, n * n / 8000.0 + 0.1);
      cell.comparison = "incidences";
      catalogue.cells.push_back(std::move(cell));
    }
  }
}

}  // namespace

void add_arrangement_cells(lab::Catalogue& catalogue, lab::Extent extent) {
  add_incidence_cells(catalogue, extent);
}

}  // namespace kinex::families
