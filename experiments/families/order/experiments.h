// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments on sorted lists: see cells.cpp.
#ifndef KINEX_EXPERIMENTS_FAMILIES_ORDER_EXPERIMENTS_H
#define KINEX_EXPERIMENTS_FAMILIES_ORDER_EXPERIMENTS_H

#include <vector>

#include "experiments/lab/bench_row.h"
#include "experiments/lab/cell.h"

namespace kinex::families {

void add_order_cells(lab::Catalogue& catalogue, lab::Extent extent);
// bench_rows.cpp
std::vector<lab::BenchRow> order_bench_rows(int scale);

}  // namespace kinex::families

#endif
