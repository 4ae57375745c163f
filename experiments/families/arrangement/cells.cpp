// SPDX-License-Identifier: GPL-3.0-or-later
// Questions: do points change sides of moving lines, and lines their arrangement, exactly as often as
//   counted by hand, or by brute force? Do the structures keep their bounds in random motion?
// Sources: lines_and_points.cpp counts the changes of points through lines, of lines in bundles and in
//   pencils; those of small integers are the roots of the polynomials of all pairs and triples, found by
//   another program.
// Expected: the integers below, in every run; every hard bound, and every audit.
// Cost: about a minute.
#include <cstdint>
#include <string>
#include <utility>

#include "experiments/families/arrangement/experiments.h"
#include "experiments/lab/cell_parts.h"

namespace kinex::families {
namespace {

constexpr const char* kIncidences[] = {"incidences_all", "incidences_cutting"};

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

void add_line_cells(lab::Catalogue& catalogue, lab::Extent extent) {
  constexpr const char* kName = "line_arrangement_2";
  for (const int n : {6, 9, 18}) {
    if (n > 9 && extent == lab::Extent::kQuick) continue;
    add_exactly(catalogue, lab::worst_case_cell(kName, "three-bundles", n, 1, n * n / 400.0),
                "line_arrangement_2.bundles", "external", n * n * n / 27,
                "each three lines of different bundles meet once: (n / 3)^3");
  }
  for (const int n : {3, 5, 8}) {
    lab::Cell cell = lab::worst_case_cell(kName, "turning-pencil", n, 1, 0.1);
    cell.expectations.push_back(lab::expect_exactly("line_arrangement_2.hard_bound", "kind.parallel",
                                                    Integer(n * (n - 1) / 2),
                                                    "each two slopes are equal once: C(n,2)"));
    add_exactly(catalogue, std::move(cell), "line_arrangement_2.hard_bound", "kind.triple",
                n * (n - 1) * (n - 2) / 3, "each triple turns over twice: 2 C(n,3)");
  }
  struct Counted {
    int n;
    std::uint64_t seed;
    int triples, parallels;
  };
  for (const Counted& one :
       {Counted{6, 1, 21, 8}, {8, 1, 42, 14}, {10, 2, 86, 20}, {12, 3, 113, 12}}) {
    add_exactly(catalogue, small_cell(kName, "small-lines", one.n, one.seed),
                "line_arrangement_2.small_integers", "external", one.triples + one.parallels,
                "the sign changes of the polynomials of all triples and pairs");
  }
  for (const int n : {8, 16, 32}) {
    if (n > 16 && extent == lab::Extent::kQuick) continue;
    catalogue.cells.push_back(random_cell(kName, "random-lines", n, n * n * n / 8000.0));
  }
}

void add_place_cells(lab::Catalogue& catalogue, lab::Extent extent) {
  constexpr const char* kName = "points_in_arrangement";
  struct Sizes {
    int n, m;
  };
  for (const auto& [n, m] : {Sizes{2, 2}, Sizes{3, 4}, Sizes{8, 8}}) {
    lab::Cell cell = lab::worst_case_cell(kName, "points-through-lines", n, 1, 0.1);
    cell.parameters.m = m;
    add_exactly(catalogue, std::move(cell), "points_in_arrangement.passages", "external", 4 * n * m,
                "every point passes every line twice, and both lines next to it change: 4nm");
  }
  for (const int n : {8, 16, 32}) {
    if (n > 16 && extent == lab::Extent::kQuick) continue;
    catalogue.cells.push_back(random_cell(kName, "random-lines-and-points", n, n * n * n / 8000.0));
  }
}

void add_wall_cells(lab::Catalogue& catalogue, lab::Extent extent) {
  constexpr const char* kName = "trapezoids_2";
  struct Counted {
    int n;
    std::uint64_t seed;
    int external;
  };
  for (const Counted& one : {Counted{6, 1, 182}, {8, 1, 414}, {10, 2, 830}}) {
    add_exactly(catalogue, small_cell(kName, "small-lines", one.n, one.seed),
                "trapezoids_2.small_integers", "external", one.external,
                "the lines next to all crossings, between all roots of the polynomials of two, three "
                "and four lines");
  }
  for (const int n : {3, 6, 9}) {
    if (n > 6 && extent == lab::Extent::kQuick) continue;
    lab::Cell cell = lab::worst_case_cell(kName, "three-bundles", n, 1, n * n / 100.0);
    cell.audit = AuditLevel::kEvents;
    catalogue.cells.push_back(std::move(cell));
  }
  for (const int n : {8, 16, 32}) {
    if (n > 16 && extent == lab::Extent::kQuick) continue;
    lab::Cell cell = random_cell(kName, "random-lines", n, n * n * n / 4000.0);
    if (n > 8) cell.audit = AuditLevel::kEnd;  // CGAL decomposes the arrangement in each audit
    catalogue.cells.push_back(std::move(cell));
  }
}

void add_closest_cells(lab::Catalogue& catalogue, lab::Extent extent) {
  struct Sizes {
    int n, m;
  };
  struct Counted {
    int n;
    std::uint64_t seed;
    int euclidean, vertical;
  };
  for (const bool vertical : {false, true}) {
    const char* const name = vertical ? "closest_point_line_vertical" : "closest_point_line";
    for (const auto& [n, m] : {Sizes{2, 2}, Sizes{3, 4}, Sizes{8, 8}}) {
      lab::Cell cell = lab::worst_case_cell(name, "points-through-lines", n, 1, 0.1);
      cell.parameters.m = m;
      add_exactly(catalogue, std::move(cell), "closest_point_line.all_pairs", "external",
                  2 * (n * m - 1), "all nm pairs are the closest in turn, and again: 2(nm - 1)");
    }
    for (const Counted& one :
         {Counted{6, 1, 7, 10}, {8, 1, 16, 17}, {10, 2, 24, 23}, {12, 3, 36, 42}}) {
      add_exactly(catalogue, small_cell(name, "small-lines-and-points", one.n, one.seed),
                  "closest_point_line.small_integers", "external",
                  vertical ? one.vertical : one.euclidean,
                  "the closest pairs between all roots of the polynomials of two pairs");
    }
    for (const int n : {8, 16, 32}) {
      if (n > 16 && extent == lab::Extent::kQuick) continue;
      catalogue.cells.push_back(random_cell(name, "random-lines-and-points", n, n * n / 1000.0));
    }
  }
}

}  // namespace

void add_arrangement_cells(lab::Catalogue& catalogue, lab::Extent extent) {
  add_incidence_cells(catalogue, extent);
  add_line_cells(catalogue, extent);
  add_place_cells(catalogue, extent);
  add_wall_cells(catalogue, extent);
  add_closest_cells(catalogue, extent);
}

}  // namespace kinex::families
