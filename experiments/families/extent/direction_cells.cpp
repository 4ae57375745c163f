// SPDX-License-Identifier: GPL-3.0-or-later
// Question: how often do the extreme points of fixed directions change, at most and in random
//   motion?
// Sources: along a direction and its opposite the extreme points change at most n times (the hull
//   of n dual points), so 2kn times along 4k directions: the hard bound of every run. The axes are
//   among the directions, so box-worst reaches 2n of it.
// Expected: at least 2n changes in box-worst; the hard bounds; the same changes by tournaments.
// Cost: seconds.
#include <string>
#include <utility>

#include "experiments/families/extent/experiments.h"
#include "experiments/lab/cell_parts.h"

namespace kinex::families {

void add_direction_cells(lab::Catalogue& catalogue, lab::Extent extent) {
  for (const int n : {4, 8, 16, 32, 64}) {
    if (n > 16 && extent == lab::Extent::kQuick) continue;
    for (const char* structure : {"directions_2", "directions_2_tournament"}) {
      lab::Cell cell = lab::worst_case_cell(structure, "box-worst", n, 1, 0.3);
      cell.parameters.dimension = 2;
      lab::Expectation expectation =
          lab::expect_exactly("directions_2.box_worst",
                              std::string(structure) == "directions_2" ? "kind.replace" : "processed",
                              Integer(2 * n), "the axes alone change 2n times");
      expectation.kind = lab::ExpectationKind::kAtLeast;
      cell.expectations.push_back(std::move(expectation));
      catalogue.cells.push_back(std::move(cell));
    }
    for (const char* structure :
         {"diameter_directions", "width_directions", "min_perimeter_rectangle_directions",
          "min_area_rectangle_directions"}) {
      lab::Cell cell = lab::worst_case_cell(structure, "box-worst", n, 1, 0.3);
      cell.parameters.dimension = 2;
      catalogue.cells.push_back(std::move(cell));
    }
  }
}

}  // namespace kinex::families
