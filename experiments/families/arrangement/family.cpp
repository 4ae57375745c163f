// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/arrangement/family.h"

#include "experiments/families/arrangement/experiments.h"

namespace kinex::families {

lab::FamilyExperiments arrangement_experiments() {
  lab::FamilyExperiments family;
  family.name = "arrangement";
  family.workloads = {
      {"points-through-lines", "--n points pass through --m turning lines: 2nm changes of sides", 2,
       2, 2, false, false, true, "incidences_all", generate_points_through_lines},
      {"small-lines-and-points",
       "lines and points of small integers from a generator that every program can repeat", 2, 2, 2,
       true, false, false, "incidences_all", generate_small_lines_and_points},
      {"random-lines-and-points", "chords and points of the unit square, linear motion", 2, 2, 2,
       true, false, false, "incidences_all", generate_random_lines_and_points}};
  family.add_cells = add_arrangement_cells;
  family.trade = {{"incidences_all",
                   2,
                   {12, 32},
                   "points-through-lines",
                   {4, 8},
                   {16, 36},
                   {8, 16},
                   {{8, 16, 32}, {8, 16, 32, 64, 128}}}};
  family.speed = arrangement_speed_rows;
  return family;
}

}  // namespace kinex::families
