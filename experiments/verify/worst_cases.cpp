// SPDX-License-Identifier: GPL-3.0-or-later
// Question: are the largest possible event counts reached exactly, and never exceeded?
// Sources: Guibas, "Kinetic data structures: a state of the art report" (1998), sections 5 to 7,
//   for the bounds; the families are constructed for this project, and their counts were found with
//   exact polynomials and rational sample points between consecutive critical times.
// Parameters: see each family. Minima run on the mirror images of the scenes for maxima.
// Expected: the integers below, in every run; audited after every event at small sizes.
// Cost: about 2 s, 1 min in full.
#include <utility>

#include "experiments/verify/catalogue.h"

namespace kinex {

namespace {

constexpr int kAuditedSize = 64;  // objects up to which every event is audited

Integer whole(int value) { return Integer(value); }

Expectation exactly(std::string claim, Quantity quantity, Integer count, std::string source) {
  Expectation expectation;
  expectation.claim = std::move(claim);
  expectation.kind = ExpectationKind::kExact;
  expectation.quantity = std::move(quantity);
  expectation.exact = std::move(count);
  expectation.source = std::move(source);
  return expectation;
}

Cell worst_case(std::string structure, std::string workload, int n, int degree, double cost) {
  Cell cell;
  cell.question = "Is the largest possible number of events reached?";
  cell.structure = std::move(structure);
  cell.workload = std::move(workload);
  cell.parameters.n = n;
  cell.parameters.degree = degree;
  cell.family = "worst case";
  cell.bounded = true;
  if (degree > 1) cell.family += ", degree " + std::to_string(degree);
  cell.audit = n <= kAuditedSize ? AuditLevel::kEvents : AuditLevel::kEnd;
  cell.cost = cost;
  return cell;
}

// All C(n,2) pairs swap `degree` times.
void add_sorting(Catalogue& catalogue, int n, int degree, double cost) {
  Cell cell = worst_case("sorted_list", "sort-worst", n, degree, cost);
  cell.expectations.push_back(exactly("sorted_list.worst_case", "processed",
                                      whole(degree) * pairs(whole(n)),
                                      "every pair swaps at every root: degree * n(n-1)/2"));
  catalogue.cells.push_back(std::move(cell));
}

// n = 2^k lines in bit-reversed order: at every node the two sides win alternately.
void add_tournament(Catalogue& catalogue, std::string structure, bool mirrored, int n,
                    double cost) {
  Cell cell = worst_case(std::move(structure), "tournament-worst", n, 1, cost);
  cell.mirrored = mirrored;
  int levels = 0;
  while ((1 << levels) < n) ++levels;
  cell.expectations.push_back(exactly(
      "tournament.worst_case", "processed", whole(n * levels - n + 1),
      "sum over nodes with m leaves of m - 1 changes: n log2 n - n + 1; Guibas 1998, section 5"));
  cell.expectations.push_back(
      exactly("maximum.worst_case", "external", whole(n - 1),
              "all lines are on the envelope: n - 1; Guibas 1998, section 5"));
  catalogue.cells.push_back(std::move(cell));
}

// Every item rises from its place to the root after all smaller ones are done.
void add_heap(Catalogue& catalogue, std::string structure, bool mirrored, int n, double cost) {
  Cell cell = worst_case(std::move(structure), "heap-worst", n, 1, cost);
  cell.mirrored = mirrored;
  int depths = 0;
  for (int j = 1; j <= n; ++j) {
    for (int half = j / 2; half > 0; half /= 2) ++depths;
  }
  cell.expectations.push_back(
      exactly("heap.worst_case", "processed", whole(depths),
              "sum of the depths: (ancestor, descendant) pairs; Guibas 1998, section 5"));
  cell.expectations.push_back(exactly("maximum.worst_case", "external", whole(n - 1),
                                      "the root changes n - 1 times; Guibas 1998, section 5"));
  catalogue.cells.push_back(std::move(cell));
}

// n moving points visit every gap between m slow ones on a parabola. `flips`: inside the hull; 0 if
// there is no reference.
void add_hull(Catalogue& catalogue, int size, int flips, double cost) {
  Cell cell = worst_case("delaunay_2", "hull-worst", size, 1, cost);
  cell.family = "quadratic family";
  cell.audit = size <= 8 ? AuditLevel::kEvents : AuditLevel::kEnd;
  if (flips > 0) {
    cell.expectations.push_back(
        exactly("delaunay_2.quadratic.flips", "kind.flip", whole(flips),
                "flips between interior edges, found with exact polynomials"));
  }
  cell.expectations.push_back(exactly("delaunay_2.quadratic.hull", "kind.enter+kind.leave",
                                      whole(2 * size * size - 1),
                                      "hull changes of m slow and n moving points: 2nm - 1"));
  cell.expectations.push_back(
      exactly("delaunay_2.ratio_1", "internal", 0,
              "every event changes the triangulation; Guibas 1998, section 7"));
  catalogue.cells.push_back(std::move(cell));
}

// The same motion, for structures that maintain the hull alone.
void add_hull_changes(Catalogue& catalogue, std::string structure, int size, double cost) {
  Cell cell = worst_case(std::move(structure), "hull-worst", size, 1, cost);
  cell.family = "quadratic family";
  cell.audit = size <= 8 ? AuditLevel::kEvents : AuditLevel::kEnd;
  cell.bounded = false;  // its bounds are on events by kind
  cell.expectations.push_back(exactly("convex_hull_2.quadratic", "external",
                                      whole(2 * size * size - 1),
                                      "hull changes of m slow and n moving points: 2nm - 1"));
  catalogue.cells.push_back(std::move(cell));
}

}  // namespace

void add_worst_cases(Catalogue& catalogue, Extent extent) {
  const bool full = extent == Extent::kFull;
  for (const int n : {4, 8, 16, 32, 64}) add_sorting(catalogue, n, 1, n * n * n * 1e-6);
  if (full) {
    for (const int n : {128, 256}) add_sorting(catalogue, n, 1, n * n * n * 1e-6);
  }
  add_sorting(catalogue, 5, 2, 0.01);
  add_sorting(catalogue, 6, 3, 0.01);
  for (const int degree : {2, 3, 5}) {
    for (const int n : {8, 16, 32}) {
      if (n == 32 && degree == 5 && !full) continue;
      add_sorting(catalogue, n, degree, degree * n * n * 2e-5);
    }
  }
  for (const bool minimum : {false, true}) {
    const std::string which = minimum ? "minimum_" : "maximum_";
    for (const int n : {4, 8, 16, 64, 256}) {
      add_tournament(catalogue, which + "tournament", minimum, n, 0.05);
    }
    for (const int n : {7, 15, 31, 63}) add_heap(catalogue, which + "heap", minimum, n, 0.05);
    if (!full) continue;
    for (const int n : {512, 1024}) {
      add_tournament(catalogue, which + "tournament", minimum, n, 1);
    }
    for (const int n : {100, 127, 255}) add_heap(catalogue, which + "heap", minimum, n, 1);
  }
  add_hull(catalogue, 3, 15, 0.1);
  add_hull(catalogue, 4, 38, 0.2);
  add_hull(catalogue, 5, 68, 0.3);
  add_hull(catalogue, 6, 107, 0.5);
  for (const int size : {8, 12, 16, 24}) add_hull(catalogue, size, 0, 0.5);
  for (const char* hull : {"convex_hull_2", "convex_hull_2_naive", "convex_hull_2_brute_force",
                           "convex_hull_2_delaunay"}) {
    for (const int size : {3, 4, 5, 8, 16}) add_hull_changes(catalogue, hull, size, 0.2);
  }
  if (full) {
    for (const int size : {32, 48, 64}) add_hull(catalogue, size, 0, 5);
  }
}

}  // namespace kinex
