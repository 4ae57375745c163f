// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of cells that families make: expectations of each kind, cells of worst cases.
#ifndef KINEX_EXPERIMENTS_LAB_CELL_PARTS_H
#define KINEX_EXPERIMENTS_LAB_CELL_PARTS_H

#include <string>

#include "experiments/lab/cell.h"

namespace kinex::lab {

Expectation expect_exactly(std::string claim, Quantity quantity, Integer count, std::string source);
Expectation expect_mean(std::string claim, Quantity quantity, double reference, std::string source);
Expectation expect_witness(std::string claim, Quantity quantity, Integer (*count)(const Scene&),
                           std::string source);

// Is the largest possible number of events reached? Audited after every event at small sizes.
Cell worst_case_cell(std::string structure, std::string workload, int n, int degree, double cost);

}  // namespace kinex::lab

#endif
