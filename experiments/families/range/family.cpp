// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/range/family.h"

#include "experiments/families/range/experiments.h"

namespace kinex::families {

lab::FamilyExperiments range_experiments() {
  lab::FamilyExperiments family;
  family.name = "range";
  family.workloads = {{"plane-sort-worst", "every pair swaps on both axes", 2, 2, 2, false, false,
                       false, "range_tree_2", generate_plane_sort_worst, 2}};
  family.add_cells = add_range_cells;
  family.event_bounds = {"swaps"};
  family.studies = {{"range_search", "range_tree_2", "rank_kd_tree_2", study_query_cost}};
  family.figures = query_cost_figures;
  family.figure_titles = {kQueryCostTitle};
  for (const char* tree :
       {"range_tree_2", "rank_kd_tree_2", "pseudo_kd_tree_2", "trajectory_tree"}) {
    family.trade.push_back({tree,
                            2,
                            {24, 64},
                            "plane-sort-worst",
                            {16, 48},
                            {25, 64},
                            {16, 48},
                            {{8, 16, 32}, {8, 16, 32, 64, 128}}});
  }
  family.bench_rows = range_bench_rows;
  return family;
}

}  // namespace kinex::families
