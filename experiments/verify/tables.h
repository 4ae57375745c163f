// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of measures of `kinex verify`.
#ifndef KINEX_EXPERIMENTS_VERIFY_TABLES_H
#define KINEX_EXPERIMENTS_VERIFY_TABLES_H

#include <vector>

#include "experiments/lab/measures.h"

namespace kinex {

// Those of the families, then one per comparison (comparison_tables).
std::vector<Table> measures_tables(const std::vector<CellResult>& cells);

}  // namespace kinex

#endif
