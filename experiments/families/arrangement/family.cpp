// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/arrangement/family.h"

#include <string_view>
#include <vector>

#include "experiments/families/arrangement/experiments.h"
#include "experiments/families/points/experiments.h"

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
       true, false, false, "incidences_all", generate_random_lines_and_points},
      {"three-bundles",
       "three bundles of n / 3 parallel lines each, rounded up or down: (n / 3)^3 triples meet, "
       "each at its own "
       "instant",
       2, 2, 2, false, false, false, "line_arrangement_2", generate_three_bundles},
      {"turning-pencil",
       "n lines meet twice, and all slopes change their order: the most events that there can be",
       2, 2, 2, false, false, false, "line_arrangement_2", generate_turning_pencil},
      {"small-lines", "lines of small integers from a generator that every program can repeat", 2,
       2, 2, true, false, false, "line_arrangement_2", generate_small_lines},
      {"random-lines", "chords of the unit square, linear motion", 2, 2, 2, true, false, false,
       "line_arrangement_2", generate_random_lines}};
  lab::set_kind(family.workloads, lab::SceneKind::kRandom,
                {"random-lines-and-points", "random-lines"});
  lab::set_kind(family.workloads, lab::SceneKind::kTies, {"small-lines-and-points", "small-lines"});
  lab::set_sizes(family.workloads, {{"points-through-lines", "points", "lines"}});
  family.event_bounds = {"triples"};
  family.long_audits = {"line_arrangement_2", "trapezoids_2"};
  family.add_cells = add_arrangement_cells;
  family.studies = {{"incidences_cutting", "incidences", "incidences_cutting", study_cuttings}};
  family.trade = {{"incidences_all",
                   2,
                   {12, 32},
                   "points-through-lines",
                   {4, 8},
                   {16, 36},
                   {8, 16},
                   {{8, 16, 32}, {8, 16, 32, 64, 128}}},
                  {"incidences_cutting",
                   2,
                   {8, 20},
                   "points-through-lines",
                   {4, 8},
                   {8, 20},
                   {8, 12},
                   {{8, 12, 16}, {8, 16, 24, 32}}},
                  {"line_arrangement_2",
                   2,
                   {6, 12},
                   "turning-pencil",
                   {4, 6},
                   {8, 12},
                   {6, 10},
                   {{6, 10, 16}, {6, 10, 16, 24}}},
                  {"points_in_arrangement",
                   2,
                   {8, 16},
                   "points-through-lines",
                   {4, 8},
                   {8, 16},
                   {8, 12},
                   {{8, 12, 16}, {8, 16, 24, 32}}},
                  {"trapezoids_2",
                   2,
                   {6, 10},
                   "turning-pencil",
                   {4, 6},
                   {8, 12},
                   {6, 8},
                   {{6, 8, 10}, {6, 8, 12, 16}}}};
  for (const std::string_view closest : {"closest_point_line", "closest_point_line_vertical"}) {
    family.trade.push_back({closest,
                            2,
                            {8, 20},
                            "points-through-lines",
                            {4, 8},
                            {8, 20},
                            {8, 12},
                            {{8, 12, 16}, {8, 16, 24, 32}}});
  }
  const auto no_runs = [](bool) { return std::vector<lab::SeriesPoint>{}; };
  family.papers = {
      kds_report({{"section-7-arrangements", "arrangements of moving lines", 13,
                   kds_section_7_arrangements_points, kds_section_7_arrangements_report},
                  {"section-7-cuttings", "proofs of incidences by cuttings of many sizes", 16,
                   no_runs, nullptr, study_sample_lines, kds_section_7_cuttings_report}})};
  family.bench_rows = arrangement_bench_rows;
  return family;
}

}  // namespace kinex::families
