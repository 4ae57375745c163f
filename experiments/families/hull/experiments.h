// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments on convex hulls; each source file states its question.
#ifndef KINEX_EXPERIMENTS_FAMILIES_HULL_EXPERIMENTS_H
#define KINEX_EXPERIMENTS_FAMILIES_HULL_EXPERIMENTS_H

#include <functional>
#include <vector>

#include "experiments/lab/bench_row.h"
#include "experiments/lab/cell.h"
#include "experiments/lab/judge.h"
#include "experiments/lab/part.h"

namespace kinex::families {

// cells.cpp. The quadratic family and random motion.
void add_hull_cells(lab::Catalogue& catalogue, lab::Extent extent);
// hull_locality.cpp. Certificates per point of the kinetic hull, with slope certificates and
// without.
lab::StudyResult study_hull_locality(bool quick, const std::function<bool()>& go_on);

// kds_figure_3.cpp
std::vector<lab::SeriesPoint> kds_figure_3_points(bool quick);
lab::PartReport kds_figure_3_report(const std::vector<lab::SeriesResult>& results,
                               const std::string& command);
// kds_large_runs.cpp
std::vector<lab::SeriesPoint> kds_large_runs_points(bool quick);
lab::PartReport kds_large_runs_report(const std::vector<lab::SeriesResult>& results,
                                 const std::string& command);
// bench_rows.cpp
std::vector<lab::BenchRow> hull_bench_rows(int scale);

}  // namespace kinex::families

#endif
