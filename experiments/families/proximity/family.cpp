// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/proximity/family.h"

#include <string_view>
#include <vector>

#include "experiments/families/points/experiments.h"
#include "experiments/families/proximity/experiments.h"

namespace kinex::families {

lab::FamilyExperiments proximity_experiments() {
  lab::FamilyExperiments family;
  family.name = "proximity";
  family.workloads = {
      {"pass-over-row", "--n points pass over a row of --m: n(m + 1) changes of the closest pair",
       2, 2, 2, false, false, true, "closest_pair_delaunay", generate_pass_over_row, 1, 2},
      {"pass-along-row", "--n points pass along a row of --m: nm - 1 changes of the closest pair",
       2, 2, 2, false, false, true, "closest_pair_delaunay", generate_pass_along_row, 1, 2},
      {"colours-along-row",
       "--n points pass along a row of --m: nm - 1 changes of the closest pair of two colours", 2,
       2, 2, false, false, true, "bichromatic_pair_delaunay", generate_colours_along_row, 1, 1},
      {"exchange-in-all-orders",
       "every pair exchanges its order along x, y, x + y and x - y: 4 C(n,2) times", 2, 2, 2, false,
       false, false, "octants_listed", generate_exchange_in_all_orders, 2},
      {"small-integers", "small integers from a generator that every program can repeat", 2, 1, 3,
       true, false, false, "", generate_small_integers},
      {"parallel-edges", "--m bundles of --n parallel edges in a row: m(n - 1) changes of the tree",
       1, 1, 1, false, false, true, "graph_mst_cycles", generate_parallel_edges, 1, 1, 1},
      {"random-graph", "--n edges between random ones of --m vertices, linear weights", 1, 1, 1,
       true, false, true, "graph_mst_cycles", generate_random_graph, 1, 2, 10},
      {"random-planar-graph", "--n edges of a grid with diagonals, linear weights", 1, 1, 1, true,
       false, false, "graph_mst_clusters", generate_random_planar_graph},
      {"fan-of-discs", "--n discs through one point: each two meet and part, n(n-1) changes", 2, 1,
       3, false, false, false, "disc_pairs_boxes", generate_fan_of_discs},
      {"fan-of-boxes", "--n boxes through one point: each two meet and part, n(n-1) changes", 2, 1,
       3, false, false, false, "box_pairs", generate_fan_of_boxes},
      {"small-discs", "discs of small integers from a generator that every program can repeat", 2,
       1, 3, true, false, false, "disc_pairs_boxes", generate_small_discs},
      {"small-boxes", "boxes of small integers from a generator that every program can repeat", 2,
       1, 3, true, false, false, "box_pairs", generate_small_boxes},
      {"random-discs", "discs of linear motion and radius in the unit square", 2, 1, 3, true, false,
       false, "disc_pairs_boxes", generate_random_discs},
      {"random-boxes", "boxes of linear motion and extents in the unit square", 2, 1, 3, true,
       false, false, "box_pairs", generate_random_boxes},
      {"gaps-along-row",
       "--n discs pass along a row of --m: nm - 1 changes of the pair of the smallest gap", 2, 2, 2,
       false, false, true, "closest_pair_discs", generate_gaps_along_row, 1, 2},
      {"apart-discs", "small discs of linear motion and radius: most of the time no two meet", 2, 1,
       3, true, false, false, "closest_pair_discs", generate_apart_discs}};
  lab::set_kind(
      family.workloads, lab::SceneKind::kRandom,
      {"random-graph", "random-planar-graph", "random-discs", "random-boxes", "apart-discs"});
  lab::set_kind(family.workloads, lab::SceneKind::kTies,
                {"small-integers", "small-discs", "small-boxes"});
  lab::set_sizes(family.workloads, {{"pass-over-row", "points that pass", "points of the row"},
                                    {"pass-along-row", "points that pass", "points of the row"},
                                    {"colours-along-row", "points that pass", "points of the row"},
                                    {"parallel-edges", "edges of each bundle", "bundles"},
                                    {"random-graph", "edges", "vertices"},
                                    {"random-planar-graph", "edges"},
                                    {"gaps-along-row", "discs that pass", "discs of the row"}});
  family.add_cells = add_proximity_cells;
  family.event_bounds = {"swaps"};
  family.long_audits = {"mst_maximum_norm_list",
                        "mst_maximum_norm_cycles",
                        "mst_maximum_norm_clusters",
                        "mst_polygon_list",
                        "mst_polygon_cycles",
                        "mst_polygon_clusters",
                        "closest_pair_discs",
                        "cones_local",
                        "emst_list"};
  family.trade = {{"closest_pair_delaunay",
                   2,
                   {12, 32},
                   "pass-over-row",
                   {4, 8},
                   {16, 36},
                   {8, 16},
                   {{8, 16, 32}, {8, 16, 32, 64, 128}}}};
  for (const std::string_view tree :
       {"emst_list", "emst_cycles", "emst_clusters", "mst_maximum_norm_list",
        "mst_maximum_norm_cycles", "mst_maximum_norm_clusters", "mst_polygon_list",
        "mst_polygon_cycles", "mst_polygon_clusters"}) {
    family.trade.push_back({tree,
                            2,
                            {12, 32},
                            "pass-along-row",
                            {4, 8},
                            {16, 36},
                            {8, 16},
                            {{8, 16, 32}, {8, 16, 32, 64, 128}}});
  }
  for (const std::string_view pair :
       {"octants_listed", "octants_local", "cones_local", "closest_pair_all",
        "closest_pair_range_tree", "closest_pair_cones", "closest_pair_local", "closest_pair_bins",
        "bichromatic_pair_delaunay", "bichromatic_pair_all", "bichromatic_pair_maximum_norm"}) {
    family.trade.push_back(
        {pair, 2, {12, 24}, "pass-along-row", {4, 8}, {16, 25}, {8, 16}, {{8, 16}, {8, 16, 32}}});
  }
  for (const std::string_view site : {"nearest_site", "voronoi_cell_2"}) {
    family.trade.push_back({site,
                            2,
                            {12, 32},
                            "pass-along-row",
                            {4, 8},
                            {16, 36},
                            {8, 16},
                            {{8, 16, 32}, {8, 16, 32, 64, 128}}});
  }
  family.trade.push_back({"nearest_site",
                          3,
                          {10, 20},
                          "small-integers",
                          {8, 12},
                          {8, 27},
                          {8, 16},
                          {{8, 12}, {8, 12, 16, 24}}});
  for (const std::string_view tree :
       {"graph_mst_list", "graph_mst_cycles", "graph_mst_clusters", "graph_mst_sparsified"}) {
    family.trade.push_back({tree,
                            1,
                            {12, 32},
                            "parallel-edges",
                            {8, 16},
                            {16, 36},
                            {8, 16},
                            {{8, 16, 32}, {8, 16, 32, 64, 128}}});
  }
  for (const std::string_view pairs :
       {"box_pairs", "disc_pairs_all", "disc_pairs_boxes", "disc_pairs_grid"}) {
    family.trade.push_back({pairs,
                            2,
                            {12, 32},
                            pairs == "box_pairs" ? "fan-of-boxes" : "fan-of-discs",
                            {4, 8},
                            {16, 36},
                            {8, 16},
                            {{8, 16, 32}, {8, 16, 32, 64, 128}}});
  }
  family.trade.push_back({"closest_pair_discs",
                          2,
                          {12, 24},
                          "gaps-along-row",
                          {4, 8},
                          {16, 25},
                          {8, 16},
                          {{8, 16}, {8, 16, 32}}});
  const auto no_runs = [](bool) { return std::vector<lab::SeriesPoint>{}; };
  family.papers = {
      kds_report({{"section-7-pairs", "closest pairs, of one colour and of two", 6,
                   kds_section_7_pairs_points, kds_section_7_pairs_report},
                  {"section-7-trees", "minimum spanning trees", 7, kds_section_7_trees_points,
                   kds_section_7_trees_report},
                  {"section-7-meetings", "discs that meet, and sides of lines", 8,
                   kds_section_7_meetings_points, kds_section_7_meetings_report},
                  {"section-7-lifting", "discs as points in space", 9, no_runs, nullptr,
                   study_lifted_discs, kds_section_7_lifting_report},
                  {"section-7-tree-diameter", "the longest path of a spanning tree", 10, no_runs,
                   nullptr, study_tree_diameter, kds_section_7_diameter_report},
                  {"section-7-hitting", "points that hit all pairs of discs that meet", 11, no_runs,
                   nullptr, study_hitting_sets, kds_section_7_hitting_report},
                  {"section-7-clusters", "what a change of a spanning tree costs by clusters", 12,
                   no_runs, nullptr, study_tree_clusters, kds_section_7_clusters_report},
                  {"section-7-locality", "certificates of one object, and of one event", 14,
                   no_runs, nullptr, study_locality, kds_section_7_locality_report},
                  {"section-7-approximation", "trees that are nearly Euclidean", 15, no_runs,
                   nullptr, study_approximate_trees, kds_section_7_approximation_report}})};
  family.bench_rows = proximity_bench_rows;
  return family;
}

}  // namespace kinex::families
