// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/proximity/family.h"

#include "experiments/families/proximity/experiments.h"

namespace kinex::families {

lab::FamilyExperiments proximity_experiments() {
  lab::FamilyExperiments family;
  family.name = "proximity";
  family.workloads = {
      {"pass-over-row", "--n points pass over a row of --m: n(m + 1) changes of the closest pair",
       2, 2, 2, false, false, true, "closest_pair_delaunay", generate_pass_over_row, 1, 2}};
  family.add_cells = add_proximity_cells;
  family.trade = {{"closest_pair_delaunay",
                   2,
                   {12, 32},
                   "pass-over-row",
                   {4, 8},
                   {16, 36},
                   {8, 16},
                   {{8, 16, 32}, {8, 16, 32, 64, 128}}}};
  return family;
}

}  // namespace kinex::families
