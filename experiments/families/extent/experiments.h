// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments on the extent of point sets; each source file states its question.
#ifndef KINEX_EXPERIMENTS_FAMILIES_EXTENT_EXPERIMENTS_H
#define KINEX_EXPERIMENTS_FAMILIES_EXTENT_EXPERIMENTS_H

#include "experiments/lab/cell.h"
#include "experiments/lab/workload.h"

namespace kinex::families {

// cells.cpp
void add_extent_cells(lab::Catalogue& catalogue, lab::Extent extent);
// box_worst.cpp
void generate_box_worst(const lab::WorkloadParameters&, Scene&);

}  // namespace kinex::families

#endif
