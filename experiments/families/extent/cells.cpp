// SPDX-License-Identifier: GPL-3.0-or-later
// Questions: does a bounding box change as often as it can, and never more often? How often does
//   random motion change it?
// Sources: the upper and the lower envelope of n lines have n + 2 pieces together (the convex hull
//   of their dual points), so a box changes at most n times an axis; box_worst.cpp reaches it. In
//   random motion the axes are independent and every side is a maximum: uniform_lines.h has its
//   expectation.
// Expected: the integers below, in every run; the means.
// Cost: about 10 s.
#include <string>
#include <utility>

#include "experiments/families/extent/calipers_experiments.h"
#include "experiments/families/extent/experiments.h"
#include "experiments/families/points/random_motion.h"
#include "experiments/families/points/uniform_lines.h"
#include "experiments/lab/cell_parts.h"
#include "structures/registry.h"

namespace kinex::families {
namespace {

void add_worst(lab::Catalogue& catalogue, int n, int dimension) {
  lab::Cell cell = lab::worst_case_cell("bounding_box", "box-worst", n, 1, 0.1);
  cell.parameters.dimension = dimension;
  cell.family += ", " + std::to_string(dimension) + (dimension == 1 ? " axis" : " axes");
  cell.expectations.push_back(
      lab::expect_exactly("bounding_box.worst_case", "external", Integer(n) * Integer(dimension),
                     "n dual points in convex position: n changes of the two sides of an axis"));
  catalogue.cells.push_back(std::move(cell));
}

void add_random(lab::Catalogue& catalogue, int n, int dimension) {
  lab::Cell cell = uniform_cell("bounding_box", n, dimension);
  cell.family += ", " + std::to_string(dimension) + (dimension == 1 ? " axis" : " axes");
  cell.precise = {{"external", 0.05}};
  cell.expectations.push_back(
      lab::expect_mean("bounding_box.uniform", "external", 2 * dimension * expected_envelope_changes(n),
                  "2 dim sides, each the expected changes of an envelope, by an integral"));
  cell.cost = 0.3;
  catalogue.cells.push_back(std::move(cell));
}

}  // namespace

void add_extent_cells(lab::Catalogue& catalogue, lab::Extent extent) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    for (const int n : {4, 8, 16, 32, 64}) {
      if (n > 32 && extent == lab::Extent::kQuick) continue;
      add_worst(catalogue, n, dimension);
    }
    for (const int n : {16, 64, 256}) add_random(catalogue, n, dimension);
  }
  add_caliper_cells(catalogue, extent);
  add_circle_cells(catalogue, extent);
  add_direction_cells(catalogue, extent);
  // The bounds on the events of what reads a hull are by kind, as those of the hull; all events of
  // the circle by brute force are external, and bounded as such.
  for (lab::Cell& cell : catalogue.cells) {
    const StructureInfo* const info = find_structure_info(cell.structure);
    if (family_of(cell.structure) != "extent") continue;
    if (!info->reads.empty() || info->group == "min_circle") cell.bounded = false;
  }
}

}  // namespace kinex::families
