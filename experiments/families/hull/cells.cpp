// SPDX-License-Identifier: GPL-3.0-or-later
// Questions: how often does the quadratic family change the hull? How many events does random
//   motion cause, and how do they grow with n?
// Sources: Guibas, "Kinetic data structures: a state of the art report" (1998), section 9
//   for the laws of growth; means of an independent simulation in doubles, with their standard
//   errors (points/reference_means.h). Changes of the hull, which are few, are known to 5 %.
// Expected: the integers below, in every run of every structure; the means, and the exponent.
// Cost: about 20 s, a minute in full.
#include <utility>

#include "experiments/families/hull/experiments.h"
#include "experiments/families/points/random_motion.h"
#include "experiments/families/points/reference_means.h"
#include "experiments/lab/cell_parts.h"

namespace kinex::families {

namespace {

// n moving points visit every gap between m slow ones on a parabola.
void add_quadratic(lab::Catalogue& catalogue, std::string structure, int size, double cost) {
  lab::Cell cell = lab::worst_case_cell(std::move(structure), "hull-worst", size, 1, cost);
  cell.family = "quadratic family";
  cell.audit = size <= 8 ? AuditLevel::kEvents : AuditLevel::kEnd;
  cell.bounded = false;  // its bounds are on events by kind
  cell.expectations.push_back(
      lab::expect_exactly("convex_hull_2.quadratic", "external", Integer(2 * size * size - 1),
                     "hull changes of m slow and n moving points: 2nm - 1"));
  catalogue.cells.push_back(std::move(cell));
}

struct Size {
  int n;
  double cost;
};

void add_random_motion(lab::Catalogue& catalogue, lab::Extent extent) {
  static constexpr Size kSizes[] = {{10, 0.1}, {100, 0.3}, {200, 0.5}, {500, 1},   {1000, 2},
                                    {1500, 2}, {2000, 3},  {3000, 5},  {10000, 15}};
  for (const Size& size : kSizes) {
    if (size.n > 3000 && extent == lab::Extent::kQuick) continue;
    lab::Cell cell = uniform_cell("convex_hull_2", size.n, 2);
    cell.bounded = false;  // its bounds are on events by kind
    cell.precise = {{"external", kChangesError}};
    if (const ReferenceMean reference = reference_mean("hull", size.n); reference.seeds > 0) {
      cell.expectations.push_back(
          lab::expect_mean("convex_hull_2.uniform", "external", reference.mean,
                           reference.source() + "; Guibas 1998, section 9: Theta(log^2 n)"));
      cell.expectations.back().reference_error = reference.error;
    }
    cell.cost = size.cost;
    catalogue.cells.push_back(std::move(cell));
  }
  // About 10 n - 200 events: the law shows where 200 are few.
  add_uniform_growth(catalogue, "convex_hull_2.uniform.growth", "convex_hull_2", 500, 1,
                     "Theta(n) events in expectation; Guibas 1998, section 9");
  catalogue.growths.back().tolerance = 0.05;
}

}  // namespace

void add_hull_cells(lab::Catalogue& catalogue, lab::Extent extent) {
  for (const char* hull : {"convex_hull_2", "convex_hull_2_naive", "convex_hull_2_brute_force",
                           "convex_hull_2_delaunay"}) {
    for (const int size : {3, 4, 5, 8, 16}) add_quadratic(catalogue, hull, size, 0.2);
  }
  add_random_motion(catalogue, extent);
}

}  // namespace kinex::families
