// SPDX-License-Identifier: GPL-3.0-or-later
// Runs cells, each in a child process (lab/child_process.h: posix_spawn and wait4, for a record has the
// CPU time and the peak memory of its child).
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
  std::string program;  // started as PROGRAM sweep cell TEXT --seconds .. --megabytes ..
  std::function<bool()> go_on;                // called about fifty times a second
  std::function<void(std::size_t)> on_start;  // gets the index of the cell
  std::function<void(std::size_t, const Record&)> on_end;
};

// Starts the cells in their order and reports each as it ends. Returns false if go_on() did:
// running cells were then ended and are not reported. An exception of on_end ends them, too, and is
// passed on.
bool run_cells(const std::vector<PlanCell>& cells, const SweepOptions& options);

}  // namespace kinex::sweep

#endif
