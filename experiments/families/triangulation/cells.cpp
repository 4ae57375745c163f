// SPDX-License-Identifier: GPL-3.0-or-later
// Questions: how often does the quadratic family of hulls change a Delaunay triangulation? How many
//   events does random motion cause, and how do they grow with n?
// Sources: Guibas, "Kinetic data structures: a state of the art report" (1998), section 7
//   for the efficiency, section 9 for the law of growth; flips of the quadratic family found with
//   exact polynomials and rational sample points between consecutive critical times; means of an
//   independent simulation in doubles, with their standard errors (points/reference_means.h).
// Expected: the integers below, in every run; the means, and the exponent.
// Cost: about 10 s, half a minute in full.
#include <cmath>
#include <utility>

#include "experiments/families/points/random_motion.h"
#include "experiments/families/points/reference_means.h"
#include "experiments/families/triangulation/experiments.h"
#include "experiments/lab/cell_parts.h"

namespace kinex::families {

namespace {

// n moving points visit every gap between m slow ones on a parabola. `flips`: inside the hull; 0 if
// there is no reference.
void add_quadratic(lab::Catalogue& catalogue, int size, int flips, double cost) {
  lab::Cell cell = lab::worst_case_cell("delaunay_2", "hull-worst", size, 1, cost);
  cell.family = "quadratic family";
  cell.audit = size <= 8 ? AuditLevel::kEvents : AuditLevel::kEnd;
  if (flips > 0) {
    cell.expectations.push_back(
        lab::expect_exactly("delaunay_2.quadratic.flips", "kind.flip", Integer(flips),
                       "flips between interior edges, found with exact polynomials"));
  }
  cell.expectations.push_back(lab::expect_exactly(
      "delaunay_2.quadratic.hull", "kind.enter+kind.leave", Integer(2 * size * size - 1),
      "hull changes of m slow and n moving points: 2nm - 1"));
  cell.expectations.push_back(
      lab::expect_exactly("delaunay_2.ratio_1", "internal", 0,
                     "every event changes the triangulation; Guibas 1998, section 7"));
  catalogue.cells.push_back(std::move(cell));
}

void add_integers_in_the_plane(lab::Catalogue& catalogue) {
  struct Counted {
    int n;
    std::uint64_t seed;
    int flips, hull_flips;
  };
  for (const Counted& one :
       {Counted{6, 1, 10, 8}, {8, 1, 17, 8}, {10, 2, 34, 12}, {12, 3, 29, 5}}) {
    lab::Cell cell = lab::worst_case_cell("delaunay_2", "small-integers", one.n, 1, 0.1);
    cell.parameters.seed = one.seed;
    cell.audit = AuditLevel::kEvents;
    const char* const source = "counted by brute force over exact positions";
    cell.expectations.push_back(lab::expect_exactly("delaunay_2.small_integers.flips", "kind.flip",
                                                    Integer(one.flips), source));
    cell.expectations.push_back(lab::expect_exactly("delaunay_2.small_integers.hull",
                                                    "kind.enter+kind.leave",
                                                    Integer(one.hull_flips), source));
    catalogue.cells.push_back(std::move(cell));
  }
}

// Four, eight and four of the eight triangles of a grid are replaced by others, two at a time.
void add_sheared_grid(lab::Catalogue& catalogue) {
  lab::Cell cell = lab::worst_case_cell("delaunay_2", "sheared-lattice", 9, 1, 0.1);
  cell.audit = AuditLevel::kEvents;
  cell.expectations.push_back(lab::expect_exactly("delaunay_2.sheared_grid", "kind.flip",
                                                  Integer(8),
                                                  "4, 8 and 4 cells change at t = -1, 0 and 1"));
  catalogue.cells.push_back(std::move(cell));
}

void add_random_motion(lab::Catalogue& catalogue) {
  for (const ReferenceMean& reference : reference_means("delaunay")) {
    lab::Cell cell = uniform_cell("delaunay_2", reference.n, 2);
    cell.expectations.push_back(
        lab::expect_mean("delaunay_2.uniform", "processed", reference.mean,
                    reference.source() + "; Guibas 1998, section 9: Theta(n^1.5)"));
    cell.expectations.back().reference_error = reference.error;
    cell.cost = 0.1 + 6e-5 * std::pow(reference.n, 1.5);
    catalogue.cells.push_back(std::move(cell));
  }
  add_uniform_growth(catalogue, "delaunay_2.uniform.growth", "delaunay_2", 50, 1.5,
                     "Theta(n^1.5) events in expectation; Guibas 1998, section 9");
}

}  // namespace

void add_triangulation_cells(lab::Catalogue& catalogue, lab::Extent extent) {
  add_quadratic(catalogue, 3, 15, 0.1);
  add_quadratic(catalogue, 4, 38, 0.2);
  add_quadratic(catalogue, 5, 68, 0.3);
  add_quadratic(catalogue, 6, 107, 0.5);
  for (const int size : {8, 12, 16, 24}) add_quadratic(catalogue, size, 0, 0.5);
  if (extent == lab::Extent::kFull) {
    for (const int size : {32, 48, 64}) add_quadratic(catalogue, size, 0, 5);
  }
  add_integers_in_the_plane(catalogue);
  add_sheared_grid(catalogue);
  add_random_motion(catalogue);
  add_space_cells(catalogue, extent);
  add_weighted_cells(catalogue, extent);
}

}  // namespace kinex::families
