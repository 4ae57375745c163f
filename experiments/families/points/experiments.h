// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments on points that belong to no single family of structures.
#ifndef KINEX_EXPERIMENTS_FAMILIES_POINTS_EXPERIMENTS_H
#define KINEX_EXPERIMENTS_FAMILIES_POINTS_EXPERIMENTS_H

#include <string>
#include <vector>

#include "experiments/lab/cell.h"
#include "experiments/lab/part.h"
#include "structures/parts/descriptor.h"

namespace kinex::families {

// common_cells.cpp. Hard bounds and audits of one structure on every kind of scene of points.
void add_common_point_cells(lab::Catalogue& catalogue, const StructureInfo& structure, lab::Extent extent);

// group_comparisons.cpp. What the structures of a group for points cost on the same scenes.
void add_group_comparisons(lab::Catalogue& catalogue, lab::Extent extent);

// Guibas, "Kinetic data structures: a state of the art report", 1998, with these parts of it.
lab::Paper kds_report(std::vector<lab::PaperPart> parts);
// kds_section_9.cpp
std::vector<lab::SeriesPoint> kds_section_9_points(bool quick);
lab::PartReport kds_section_9_report(const std::vector<lab::SeriesResult>& results,
                                const std::string& command);

}  // namespace kinex::families

#endif
