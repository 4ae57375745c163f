// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/triangulation/family.h"

#include "experiments/families/triangulation/experiments.h"

namespace kinex::families {

lab::FamilyExperiments triangulation_experiments() {
  lab::FamilyExperiments family;
  family.name = "triangulation";
  family.usual = {{false, 2, "delaunay_2"}};
  family.add_cells = add_triangulation_cells;
  family.trade = {{"delaunay_2",
                   2,
                   {12, 32},
                   "hull-worst",
                   {4, 8},
                   {16, 36},
                   {8, 16},
                   {{8, 16, 32, 64}, {8, 16, 32, 64, 128, 256}}}};
  family.speed = triangulation_speed_rows;
  return family;
}

}  // namespace kinex::families
