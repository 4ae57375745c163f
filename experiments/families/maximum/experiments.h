// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments on structures for a maximum; each source file states its question.
#ifndef KINEX_EXPERIMENTS_FAMILIES_MAXIMUM_EXPERIMENTS_H
#define KINEX_EXPERIMENTS_FAMILIES_MAXIMUM_EXPERIMENTS_H

#include <functional>
#include <vector>

#include "experiments/lab/bench_row.h"
#include "experiments/lab/cell.h"
#include "experiments/lab/judge.h"

namespace kinex::families {

// cells.cpp. Worst cases and random motion.
void add_maximum_cells(lab::Catalogue& catalogue, lab::Extent extent);
// comparison.cpp. All structures for a maximum on the same scenes.
void add_maximum_comparison(lab::Catalogue& catalogue, lab::Extent extent);
// hanger_expectation.cpp. Events of the kinetic hanger over many seeds of its coins, against their
// exact expectation.
lab::StudyResult study_hanger(bool quick, const std::function<bool()>& go_on);
// bench_rows.cpp
std::vector<lab::BenchRow> maximum_bench_rows(int scale);

}  // namespace kinex::families

#endif
