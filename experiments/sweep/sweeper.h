// SPDX-License-Identifier: GPL-3.0-or-later
// Runs cells, each in a child process.
#ifndef KINEX_EXPERIMENTS_SWEEP_SWEEPER_H
#define KINEX_EXPERIMENTS_SWEEP_SWEEPER_H

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "experiments/sweep/plan.h"
#include "experiments/sweep/record.h"

namespace kinex::sweep {

struct SweepOptions {
  int jobs = 1;         // children at a time
  Limits limits;        // of each
  std::string program;  // that is started: PROGRAM sweep cell TEXT --seconds .. --megabytes ..
  std::function<bool()> go_on;                // asked some fifty times a second
  std::function<void(std::size_t)> on_start;  // place among the cells
  std::function<void(std::size_t, const Record&)> on_end;
};

// Starts the cells in their order and reports each as it ends. False if go_on() was: the cells at
// work were ended and are not reported. What on_end throws ends them, too.
bool run_cells(const std::vector<PlannedCell>& cells, const SweepOptions& options);

}  // namespace kinex::sweep

#endif
