// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments on the proximity of points; each source file states its question.
#ifndef KINEX_EXPERIMENTS_FAMILIES_PROXIMITY_EXPERIMENTS_H
#define KINEX_EXPERIMENTS_FAMILIES_PROXIMITY_EXPERIMENTS_H

#include <vector>

#include "experiments/lab/cell.h"
#include "experiments/lab/speed_row.h"
#include "experiments/lab/workload.h"

namespace kinex::families {

// cells.cpp
void add_proximity_cells(lab::Catalogue& catalogue, lab::Extent extent);
// speed.cpp
std::vector<lab::SpeedRow> proximity_speed_rows(int scale);
// pass_along_row.cpp
void generate_pass_along_row(const lab::WorkloadParameters&, Scene&);
// graphs.cpp
void generate_parallel_edges(const lab::WorkloadParameters&, Scene&);
void generate_random_graph(const lab::WorkloadParameters&, Scene&);
// extents.cpp
void generate_fan_of_discs(const lab::WorkloadParameters&, Scene&);
void generate_fan_of_boxes(const lab::WorkloadParameters&, Scene&);
void generate_small_discs(const lab::WorkloadParameters&, Scene&);
void generate_small_boxes(const lab::WorkloadParameters&, Scene&);
void generate_random_discs(const lab::WorkloadParameters&, Scene&);
void generate_random_boxes(const lab::WorkloadParameters&, Scene&);
// octant_cells.cpp, pair_cells.cpp, graph_cells.cpp, meeting_cells.cpp
void add_octant_cells(lab::Catalogue& catalogue, lab::Extent extent);
void add_pair_cells(lab::Catalogue& catalogue, lab::Extent extent);
void add_graph_cells(lab::Catalogue& catalogue, lab::Extent extent);
void add_meeting_cells(lab::Catalogue& catalogue, lab::Extent extent);
// small_integers.cpp
void generate_small_integers(const lab::WorkloadParameters&, Scene&);
// pass_over_row.cpp
void generate_pass_over_row(const lab::WorkloadParameters&, Scene&);

}  // namespace kinex::families

#endif
