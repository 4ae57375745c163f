// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments on convex hulls; each source file states its question.
#ifndef KINEX_EXPERIMENTS_FAMILIES_HULL_EXPERIMENTS_H
#define KINEX_EXPERIMENTS_FAMILIES_HULL_EXPERIMENTS_H

#include <functional>
#include <vector>

#include "experiments/lab/cell.h"
#include "experiments/lab/judge.h"
#include "experiments/lab/part.h"
#include "experiments/lab/speed_row.h"

namespace kinex {

// cells.cpp. The quadratic family and random motion.
void add_hull_cells(Catalogue& catalogue, Extent extent);
// hull_locality.cpp. Certificates per point of the kinetic hull, with slope certificates and
// without.
StudyResult study_hull_locality(bool quick, const std::function<bool()>& go_on);

// kds_figure_3.cpp
std::vector<SeriesPoint> kds_figure_3_points(bool quick);
PartReport kds_figure_3_report(const std::vector<SeriesResult>& results,
                               const std::string& command);
// kds_large_runs.cpp
std::vector<SeriesPoint> kds_large_runs_points(bool quick);
PartReport kds_large_runs_report(const std::vector<SeriesResult>& results,
                                 const std::string& command);
// speed.cpp
std::vector<SpeedRow> hull_speed_rows(int scale);

}  // namespace kinex

#endif
