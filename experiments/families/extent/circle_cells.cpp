// SPDX-License-Identifier: GPL-3.0-or-later
// Questions: does the smallest circle change exactly as often as counted by hand? Does the box on a
//   hull change as that of tournaments? Do all keep their bounds in random motion?
// Source: seesaw.cpp counts 3nm - n - m - 1 changes of the circle and (n - 1)(m - 1) of the
//   triangulation; box_worst.cpp counts 2n of the box in the plane.
// Expected: the integers below, in every run; every hard bound, and every audit.
// Cost: about 10 s.
#include <string>
#include <string_view>
#include <utility>

#include "experiments/families/extent/experiments.h"
#include "experiments/families/extent/quadratic_families.h"
#include "experiments/families/points/random_motion.h"
#include "experiments/families/points/uniform_lines.h"
#include "experiments/lab/cell_parts.h"

namespace kinex::families {
namespace {

void add_seesaw(lab::Catalogue& catalogue, const char* structure, int size, int changes,
                const char* source) {
  lab::Cell cell = lab::worst_case_cell(structure, "seesaw", size, 1, 0.3);
  set_both_sizes(cell, size);
  cell.audit = size <= 6 ? AuditLevel::kEvents : AuditLevel::kEnd;
  cell.expectations.push_back(lab::expect_exactly(std::string(structure) + ".seesaw", "external",
                                                  Integer(changes), source));
  catalogue.cells.push_back(std::move(cell));
}

}  // namespace

void add_circle_cells(lab::Catalogue& catalogue, lab::Extent extent) {
  for (const int n : kWorstSizes) {
    if (n > kLargestQuickSize && extent == lab::Extent::kQuick) continue;
    const int circle = 3 * n * n - 2 * n - 1;
    for (const char* structure : {"min_circle_2", "min_circle_2_brute_force"}) {
      if (n > 32 && std::string_view(structure) != "min_circle_2") continue;  // n certificates a change
      add_seesaw(catalogue, structure, n, circle, "3nm - n - m - 1 changes, counted by hand");
    }
    add_seesaw(catalogue, "farthest_delaunay_2", n, (n - 1) * (n - 1),
               "each point of the right is passed by the arc's n - 1 pairs once");
  }
  for (const char* structure : {"min_circle_2", "min_circle_2_brute_force", "farthest_delaunay_2"}) {
    catalogue.growths.push_back(quadratic_growth(structure, "seesaw", "external"));
  }
  for (const int n : {4, 8, 16, 32}) {
    lab::Cell cell = lab::worst_case_cell("bounding_box_2_hull", "box-worst", n, 1, 0.2);
    cell.expectations.push_back(
        lab::expect_exactly("bounding_box_2_hull.worst_case", "external", Integer(2 * n),
                            "n dual points in convex position: n changes of the two sides of an "
                            "axis"));
    catalogue.cells.push_back(std::move(cell));
  }
  for (const int n : {16, 64, 256}) {
    lab::Cell box = uniform_cell("bounding_box_2_hull", n, 2);
    box.precise = {{"external", 0.05}};
    box.expectations.push_back(
        lab::expect_mean("bounding_box_2_hull.uniform", "external",
                         4 * expected_envelope_changes(n),
                         "4 sides, each the expected changes of an envelope, by an integral"));
    catalogue.cells.push_back(std::move(box));
    for (const char* structure :
         {"farthest_delaunay_2", "min_circle_2", "min_circle_2_brute_force"}) {
      lab::Cell cell = uniform_cell(structure, n, 2);
      cell.precise = {{"external", kChangesError}};
      cell.cost = n / 100.0;
      catalogue.cells.push_back(std::move(cell));
    }
  }
}

}  // namespace kinex::families
