// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/triangulation/family.h"

#include "experiments/families/points/experiments.h"
#include "experiments/families/triangulation/experiments.h"

namespace kinex::families {

lab::FamilyExperiments triangulation_experiments() {
  lab::FamilyExperiments family;
  family.name = "triangulation";
  family.usual = {{false, 2, "delaunay_2"}};
  family.long_audits = {"delaunay_3", "regular_2", "regular_3"};
  family.workloads = {
      {"skew-curves", "a point passes between two skew curves of --n points each in space", 3, 3, 3,
       false, false, false, "delaunay_3", generate_skew_curves, 2},
      {"skew-rows",
       "--m points pass between two skew rows of --n points each in space, and each "
       "changes all cells",
       3, 3, 3, false, false, true, "delaunay_3", generate_skew_rows, 2, 1, 1},
      {"sheared-lattice",
       "--n points of a lattice that is sheared through the square or cubic one: all cells change "
       "at "
       "integer times",
       2, 2, 3, false, false, false, "", generate_sheared_lattice},
      {"twice-sheared-lattice",
       "--n points of a lattice in space, sheared along two axes through the cubic one", 3, 3, 3,
       false, false, false, "delaunay_3", generate_twice_sheared_lattice},
      {"bipyramid",
       "a circle of --n points and two apices, all on one sphere at t = 0: 4 are an octahedron", 3,
       3, 3, false, false, false, "delaunay_3", generate_bipyramid, 3},
      {"show-and-hide",
       "--n light points pass under a strip of 2 --m heavy ones: 4n(m - 1) times one shows "
       "or hides",
       2, 2, 2, false, false, true, "regular_2", generate_show_and_hide, 1, 2},
      {"breathing", "the weight of a point crosses --n times the value at which it shows", 2, 2, 3,
       false, false, false, "regular_2", generate_breathing},
      {"small-weights",
       "points of small integers with weights from a generator that every program can repeat", 2, 2,
       3, true, false, false, "regular_2", generate_small_weights},
      {"small-moving-weights", "points of small integers with weights that change, as repeatable",
       2, 2, 3, true, false, false, "regular_2", generate_small_moving_weights},
      {"random-weights", "points of linear motion and weight in the unit square", 2, 2, 3, true,
       false, false, "regular_2", generate_random_weights}};
  lab::set_kind(family.workloads, lab::SceneKind::kRandom, {"random-weights"});
  lab::set_kind(family.workloads, lab::SceneKind::kTies,
                {"small-weights", "small-moving-weights", "sheared-lattice",
                 "twice-sheared-lattice", "bipyramid"});
  lab::set_sizes(family.workloads, {{"skew-curves", "points of each curve"},
                                    {"skew-rows", "points of each row", "points that pass"},
                                    {"bipyramid", "points of the circle"},
                                    {"show-and-hide", "light points", "pairs of heavy points"},
                                    {"breathing", "times that the value is crossed"}});
  family.add_cells = add_triangulation_cells;
  family.studies = {{"triangulation_growth", "regular_2", "regular_3", study_triangulation_growth}};
  family.event_bounds = {"passes"};
  family.trade = {{"delaunay_2",
                   2,
                   {12, 32},
                   "hull-worst",
                   {4, 8},
                   {16, 36},
                   {8, 16},
                   {{8, 16, 32, 64}, {8, 16, 32, 64, 128, 256}}},
                  {"delaunay_3",
                   3,
                   {10, 20},
                   "skew-curves",
                   {3, 6},
                   {8, 27},
                   {8, 16},
                   {{8, 12}, {8, 12, 16, 24}}},
                  {"regular_2",
                   2,
                   {12, 32},
                   "show-and-hide",
                   {2, 4},
                   {16, 36},
                   {8, 16},
                   {{8, 16, 32}, {8, 16, 32, 64, 128}}},
                  {"regular_3",
                   3,
                   {10, 20},
                   "breathing",
                   {4, 8},
                   {8, 27},
                   {8, 16},
                   {{8, 12}, {8, 12, 16, 24}}}};
  family.papers = {kds_report({{"section-7-delaunay", "Delaunay triangulations", 5,
                                kds_section_7_delaunay_points, kds_section_7_delaunay_report}})};
  family.bench_rows = triangulation_bench_rows;
  return family;
}

}  // namespace kinex::families
