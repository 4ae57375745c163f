// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments of the family range (points in query boxes), for family.cpp; each source file states
// its question.
#ifndef KINEX_EXPERIMENTS_FAMILIES_RANGE_EXPERIMENTS_H
#define KINEX_EXPERIMENTS_FAMILIES_RANGE_EXPERIMENTS_H

#include <functional>
#include <vector>

#include "experiments/lab/bench_row.h"
#include "experiments/lab/cell.h"
#include "experiments/lab/gnuplot.h"
#include "experiments/lab/judge.h"
#include "experiments/lab/workload.h"

namespace kinex::families {

// cells.cpp
void add_range_cells(lab::Catalogue& catalogue, lab::Extent extent);
// plane_sort_worst.cpp
void generate_plane_sort_worst(const lab::WorkloadParameters&, Scene&);
// query_cost.cpp
lab::StudyResult study_query_cost(bool quick, const std::function<bool()>& go_on);
inline constexpr const char* kQueryCostTitle = "Range search: the cost of a query";
std::vector<lab::Figure> query_cost_figures(const std::vector<lab::CellResult>& cells);
// bench_rows.cpp
std::vector<lab::BenchRow> range_bench_rows(int scale);

}  // namespace kinex::families

#endif
