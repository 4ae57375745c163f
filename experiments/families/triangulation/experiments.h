// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments on triangulations: see cells.cpp and space_cells.cpp.
#ifndef KINEX_EXPERIMENTS_FAMILIES_TRIANGULATION_EXPERIMENTS_H
#define KINEX_EXPERIMENTS_FAMILIES_TRIANGULATION_EXPERIMENTS_H

#include <vector>

#include "experiments/lab/cell.h"
#include "experiments/lab/speed_row.h"
#include "experiments/lab/workload.h"

namespace kinex::families {

void add_triangulation_cells(lab::Catalogue& catalogue, lab::Extent extent);
// space_cells.cpp
void add_space_cells(lab::Catalogue& catalogue, lab::Extent extent);
// skew_curves.cpp
void generate_skew_curves(const lab::WorkloadParameters&, Scene&);
// speed.cpp
std::vector<lab::SpeedRow> triangulation_speed_rows(int scale);

}  // namespace kinex::families

#endif
