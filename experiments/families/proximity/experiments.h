// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments on the proximity of points; each source file states its question.
#ifndef KINEX_EXPERIMENTS_FAMILIES_PROXIMITY_EXPERIMENTS_H
#define KINEX_EXPERIMENTS_FAMILIES_PROXIMITY_EXPERIMENTS_H

#include <functional>
#include <string>
#include <vector>

#include "experiments/lab/bench_row.h"
#include "experiments/lab/cell.h"
#include "experiments/lab/part.h"
#include "experiments/lab/workload.h"

namespace kinex::families {

// cells.cpp
void add_proximity_cells(lab::Catalogue& catalogue, lab::Extent extent);
// bench_rows.cpp
std::vector<lab::BenchRow> proximity_bench_rows(int scale);
// pass_along_row.cpp
void generate_pass_along_row(const lab::WorkloadParameters&, Scene&);
void generate_colours_along_row(const lab::WorkloadParameters&, Scene&);
// exchange_in_all_orders.cpp
void generate_exchange_in_all_orders(const lab::WorkloadParameters&, Scene&);
// graphs.cpp
void generate_parallel_edges(const lab::WorkloadParameters&, Scene&);
void generate_random_graph(const lab::WorkloadParameters&, Scene&);
void generate_random_planar_graph(const lab::WorkloadParameters&, Scene&);
// extents.cpp
void generate_fan_of_discs(const lab::WorkloadParameters&, Scene&);
void generate_fan_of_boxes(const lab::WorkloadParameters&, Scene&);
void generate_small_discs(const lab::WorkloadParameters&, Scene&);
void generate_small_boxes(const lab::WorkloadParameters&, Scene&);
void generate_random_discs(const lab::WorkloadParameters&, Scene&);
void generate_random_boxes(const lab::WorkloadParameters&, Scene&);
void generate_gaps_along_row(const lab::WorkloadParameters&, Scene&);
void generate_apart_discs(const lab::WorkloadParameters&, Scene&);
// octant_cells.cpp, pair_cells.cpp, graph_cells.cpp, meeting_cells.cpp
void add_octant_cells(lab::Catalogue& catalogue, lab::Extent extent);
void add_pair_cells(lab::Catalogue& catalogue, lab::Extent extent);
void add_graph_cells(lab::Catalogue& catalogue, lab::Extent extent);
void add_meeting_cells(lab::Catalogue& catalogue, lab::Extent extent);
// gap_cells.cpp
void add_gap_cells(lab::Catalogue& catalogue, lab::Extent extent);
// kds_section_7_pairs.cpp, kds_section_7_trees.cpp, kds_section_7_meetings.cpp
std::vector<lab::SeriesPoint> kds_section_7_pairs_points(bool quick);
lab::PartReport kds_section_7_pairs_report(const std::vector<lab::SeriesResult>& results,
                                           const std::string& command);
std::vector<lab::SeriesPoint> kds_section_7_trees_points(bool quick);
lab::PartReport kds_section_7_trees_report(const std::vector<lab::SeriesResult>& results,
                                           const std::string& command);
std::vector<lab::SeriesPoint> kds_section_7_meetings_points(bool quick);
lab::PartReport kds_section_7_meetings_report(const std::vector<lab::SeriesResult>& results,
                                              const std::string& command);
// kds_section_7_lifting.cpp
lab::StudyResult study_lifted_discs(bool quick, const std::function<bool()>& go_on);
lab::PartReport kds_section_7_lifting_report(const lab::StudyResult& result,
                                             const std::string& command);
// kds_section_7_hitting.cpp
lab::StudyResult study_hitting_sets(bool quick, const std::function<bool()>& go_on);
lab::PartReport kds_section_7_hitting_report(const lab::StudyResult& result,
                                             const std::string& command);
// kds_section_7_diameter.cpp
lab::StudyResult study_tree_diameter(bool quick, const std::function<bool()>& go_on);
lab::PartReport kds_section_7_diameter_report(const lab::StudyResult& result,
                                              const std::string& command);
// kds_section_7_clusters.cpp
lab::StudyResult study_tree_clusters(bool quick, const std::function<bool()>& go_on);
lab::PartReport kds_section_7_clusters_report(const lab::StudyResult& result,
                                              const std::string& command);
// kds_section_7_approximation.cpp
lab::StudyResult study_approximate_trees(bool quick, const std::function<bool()>& go_on);
lab::PartReport kds_section_7_approximation_report(const lab::StudyResult& result,
                                                   const std::string& command);
// kds_section_7_locality.cpp
lab::StudyResult study_locality(bool quick, const std::function<bool()>& go_on);
lab::PartReport kds_section_7_locality_report(const lab::StudyResult& result,
                                              const std::string& command);
// small_integers.cpp
void generate_small_integers(const lab::WorkloadParameters&, Scene&);
// pass_over_row.cpp
void generate_pass_over_row(const lab::WorkloadParameters&, Scene&);

}  // namespace kinex::families

#endif
