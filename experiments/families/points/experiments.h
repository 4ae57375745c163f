// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments that are not of one family of structures for points.
#ifndef KINEX_EXPERIMENTS_FAMILIES_POINTS_EXPERIMENTS_H
#define KINEX_EXPERIMENTS_FAMILIES_POINTS_EXPERIMENTS_H

#include <string>
#include <vector>

#include "experiments/lab/cell.h"
#include "experiments/lab/part.h"
#include "structures/parts/descriptor.h"

namespace kinex {

// common_cells.cpp. Hard bounds and audits of one structure on every kind of scene of points.
void add_common_point_cells(Catalogue& catalogue, const StructureInfo& structure, Extent extent);

// Guibas, "Kinetic data structures: a state of the art report", 1998, with these parts of it.
Paper kds_report(std::vector<PaperPart> parts);
// kds_section_9.cpp
std::vector<SeriesPoint> kds_section_9_points(bool quick);
PartReport kds_section_9_report(const std::vector<SeriesResult>& results,
                                const std::string& command);

}  // namespace kinex

#endif
