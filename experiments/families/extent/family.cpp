// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/extent/family.h"

#include <string_view>
#include <utility>
#include <vector>

#include "experiments/families/extent/calipers_experiments.h"
#include "experiments/families/extent/experiments.h"
#include "experiments/families/extent/quadratic_families.h"
#include "experiments/families/extent/trajectory_kernel.h"
#include "experiments/families/points/experiments.h"

namespace kinex::families {

lab::FamilyExperiments extent_experiments() {
  lab::FamilyExperiments family;
  family.name = "extent";
  family.workloads = {
      {"box-worst", "a bounding box that changes --n times in every axis", 2, 1, 3, false, false,
       false, "bounding_box", generate_box_worst, 2},
      {"seesaw",
       "a smallest circle that changes 3nm - n - m - 1 times: --n points at rest, "
       "--m that pass on the other side",
       2, 2, 2, false, false, true, "min_circle_2", generate_seesaw, 2, 2},
      {"obtuse-triangle",
       "a triangle with a smallest circle that changes 4 times; other points inside", 2, 2, 2,
       false, false, false, "min_circle_2", generate_obtuse_triangle, 3}};
  lab::set_sizes(family.workloads, {{"seesaw", "points at rest", "points that pass"}});
  family.add_cells = add_extent_cells;
  family.studies = {{"directions_2", "directions", "directions_2", study_directions},
                    {"calipers", "diameter", "calipers_2", study_calipers}};
  const auto plan = [](std::string_view structure, std::string_view worst, int quick, int full) {
    return lab::TradePlan{structure,     2,         {12, 128}, worst,
                          {quick, full}, {16, 100}, {8, 48},   {{8, 16}, {16, 64, 256}}};
  };
  family.trade = {plan("bounding_box", "box-worst", 16, 48),
                  plan("bounding_box_2_hull", "box-worst", 16, 48),
                  plan("directions_2", "box-worst", 16, 48),
                  plan("farthest_delaunay_2", "seesaw", 4, 8),
                  plan("directions_2_tournament", "box-worst", 8, 24),
                  plan("diameter_directions", "box-worst", 16, 48),
                  plan("width_directions", "box-worst", 16, 48),
                  plan("min_perimeter_rectangle_directions", "box-worst", 16, 48),
                  plan("min_area_rectangle_directions", "box-worst", 16, 48),
                  plan("min_circle_2", "seesaw", 4, 8)};
  family.trade.push_back({"min_circle_2_brute_force",
                          2,
                          {12, 32},
                          "seesaw",
                          {4, 8},
                          {16, 36},
                          {8, 16},
                          {{8, 16}, {16, 64}}});
  for (const lab::Workload& workload : caliper_workloads()) family.workloads.push_back(workload);
  for (const lab::TradePlan& one : caliper_trade()) family.trade.push_back(one);
  const auto no_runs = [](bool) { return std::vector<lab::SeriesPoint>{}; };
  family.papers = {kds_report({{"section-6-circle", "the smallest enclosing circle", 4, no_runs,
                                nullptr, study_kds_section_6, kds_section_6_report}})};
  family.figures = [](const std::vector<lab::CellResult>& cells) {
    std::vector<lab::Figure> all = direction_figures(cells);
    for (lab::Figure& figure : quadratic_figures(cells)) all.push_back(std::move(figure));
    return all;
  };
  family.figure_titles = {kDirectionsTitle, kQuadraticTitle};
  family.thinning = &kKernelThinning;
  family.bench_rows = extent_bench_rows;
  return family;
}

}  // namespace kinex::families
