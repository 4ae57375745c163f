// SPDX-License-Identifier: GPL-3.0-or-later
// Questions: does the triangulation in space change exactly as often as counted by another program?
//   How many events does random motion cause?
// Sources: flips of small integers counted by brute force over exact positions between all critical times, those
//   of skew curves and rows from the spheres and hull facets of the points at rest, by another program; Guibas, "Kinetic data structures: a state of the art report" (1998),
//   section 9, gives n^(4/3) for random motion in space as a preliminary figure; means of random motion
//   from a simulation that makes no triangulation (reference_means.h).
// Expected: the integers below, in every run; every hard bound, and every audit. No exponent: from
//   n = 50 to 1600 the growth still slows down, and no single power fits.
// Cost: about 5 s, half a minute in full.
#include <cstdint>
#include <string>
#include <utility>

#include "experiments/families/points/random_motion.h"
#include "experiments/families/points/reference_means.h"
#include "experiments/families/triangulation/experiments.h"
#include "experiments/lab/cell_parts.h"

namespace kinex::families {
namespace {

void expect(lab::Cell& cell, std::string claim, std::string quantity, int count) {
  cell.expectations.push_back(lab::expect_exactly(std::move(claim), std::move(quantity),
                                                  Integer(count),
                                                  "counted by brute force over exact positions"));
}

void add_small_integers(lab::Catalogue& catalogue) {
  struct Counted {
    int n;
    std::uint64_t seed;
    int inner_2_3, hull_2_3, inner_3_2, hull_3_2;
  };
  for (const Counted& one : {Counted{6, 1, 2, 4, 3, 4}, {7, 2, 9, 7, 8, 10}, {8, 1, 5, 9, 5, 9}}) {
    lab::Cell cell = lab::worst_case_cell("delaunay_3", "small-integers", one.n, 1, 0.1);
    cell.parameters.seed = one.seed;
    cell.parameters.dimension = 3;
    cell.audit = AuditLevel::kEvents;
    expect(cell, "delaunay_3.small_integers.2_3", "kind.flip_2_3", one.inner_2_3);
    expect(cell, "delaunay_3.small_integers.3_2", "kind.flip_3_2", one.inner_3_2);
    expect(cell, "delaunay_3.small_integers.hull_2_3", "kind.enter+kind.hull_2_3", one.hull_2_3);
    expect(cell, "delaunay_3.small_integers.hull_3_2", "kind.leave+kind.hull_3_2", one.hull_3_2);
    catalogue.cells.push_back(std::move(cell));
  }
}

// One point passes between points at rest. It changes a cell as often as it enters or leaves the sphere of a
// cell of theirs, and the hull once for each of its facets, whose plane it crosses.
void add_skew_passages(lab::Catalogue& catalogue) {
  const auto add = [&catalogue](const char* workload, const char* claim, int n, int changes) {
    lab::Cell cell = lab::worst_case_cell("delaunay_3", workload, n, 1, 0.1);
    cell.audit = AuditLevel::kEvents;
    expect(cell, claim, "external", changes);
    catalogue.cells.push_back(std::move(cell));
  };
  for (const auto& [n, changes] :
       {std::pair(2, 6), std::pair(3, 20), std::pair(4, 38), std::pair(5, 64), std::pair(6, 64)}) {
    add("skew-curves", "delaunay_3.skew_curves", n, changes);
  }
  for (const auto& [n, changes] : {std::pair(3, 20), std::pair(4, 38), std::pair(6, 86)}) {
    add("skew-rows", "delaunay_3.skew_rows", n, changes);
  }
}

// All points are on one sphere, or many on several, at one instant: one event. A bound on the events is not known
// where more than five points are on a sphere.
void add_spheres_of_many(lab::Catalogue& catalogue) {
  const auto add = [&catalogue](const char* workload, int n, int dimension) {
    lab::Cell cell = lab::worst_case_cell("delaunay_3", workload, n, 1, 0.1);
    if (dimension != 0) cell.parameters.dimension = dimension;
    cell.audit = AuditLevel::kEvents;
    cell.bounded = false;
    cell.expectations.push_back(lab::expect_exactly("delaunay_3.one_sphere", "external", 1,
                                                    "all points are on one sphere, once"));
    catalogue.cells.push_back(std::move(cell));
  };
  add("sheared-lattice", 8, 3);
  add("twice-sheared-lattice", 8, 0);
  add("bipyramid", 4, 0);
}

}  // namespace

void add_space_cells(lab::Catalogue& catalogue, lab::Extent extent) {
  add_small_integers(catalogue);
  add_skew_passages(catalogue);
  add_spheres_of_many(catalogue);
  for (const int n : {16, 32, 64, 128}) {
    if (n > 32 && extent == lab::Extent::kQuick) continue;
    lab::Cell cell = uniform_cell("delaunay_3", n, 3);
    if (const ReferenceMean reference = reference_mean("delaunay_3", n); reference.seeds > 0) {
      cell.expectations.push_back(lab::expect_mean("delaunay_3.uniform", "external", reference.mean,
                                                   reference.source()));
      cell.expectations.back().reference_error = reference.error;
      cell.min_seeds = kSeedsOfMeans;
    }
    cell.cost = n / 40.0;
    catalogue.cells.push_back(std::move(cell));
  }
}

}  // namespace kinex::families
