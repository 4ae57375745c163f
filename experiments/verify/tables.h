// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of measures and of neighbours of `kinex verify`.
#ifndef KINEX_EXPERIMENTS_VERIFY_TABLES_H
#define KINEX_EXPERIMENTS_VERIFY_TABLES_H

#include <vector>

#include "experiments/lab/growth.h"
#include "experiments/lab/measures.h"

namespace kinex::verify {

// Those of the families, then one per comparison (comparison_tables).
std::vector<lab::Table> measures_tables(const std::vector<lab::CellResult>& cells);

// Each law that was fitted, and its neighbours (lab/neighbours.h): what each leaves, and which are
// beaten. None without such laws.
std::vector<lab::Table> neighbours_tables(const std::vector<lab::GrowthResult>& growths);

}  // namespace kinex::verify

#endif
