// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/collision/family.h"

#include "experiments/families/collision/experiments.h"
#include "experiments/families/collision/polygons.h"
#include "experiments/families/collision/separation_paper.h"
#include "experiments/families/collision/story.h"

namespace kinex::families {

lab::FamilyExperiments collision_experiments() {
  lab::FamilyExperiments family;
  family.name = "collision";
  family.usual = {{true, 0, "separation_mixed"}};
  family.workloads = polygon_workloads();
  family.add_common_cells = add_common_body_cells;
  family.add_comparisons = add_collision_cells;
  family.studies = {{"contacts", "collision", "collision", study_contacts},
                    {"outer_hierarchy", "collision", "outer_hierarchy", study_outer_hierarchies},
                    {"inner_tangents", "collision", "inner_tangents", study_tangents},
                    {"wedge_cover", "collision", "separation_hysteresis", study_wedge_cover}};
  // The one with a law for straight lines.
  family.bounds_events = [](std::string_view structure) {
    return structure == "separation_minkowski";
  };
  family.event_bounds = {"line"};
  family.tables = collision_tables;
  family.figures = collision_figures;
  family.figure_titles = {kStoryTitle};
  family.papers = {separation_paper()};
  family.bench_rows = collision_bench_rows;
  return family;
}

}  // namespace kinex::families
