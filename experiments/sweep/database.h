// SPDX-License-Identifier: GPL-3.0-or-later
// The merged database of a sweep.
#ifndef KINEX_EXPERIMENTS_SWEEP_DATABASE_H
#define KINEX_EXPERIMENTS_SWEEP_DATABASE_H

#include <string>
#include <vector>

#include "experiments/sweep/settled.h"

namespace kinex::sweep {

// The bytes of an SQLite file. Exact tables: the same for the same plans and verdicts, however the
// cells were shared out, run again and ordered.
//   plan      the plans
//   cell      every cell of a plan, and others that were run; by key. status: that of its settled
//             record, or "missing"
//   run       of each cell that is done or has failed
//   counter, extreme, bound, violation    of runs; structure '': over all structures
// Others:
//   provenance    one row an attempt file: plan, program, machine, command
//   attempt       one row a record: status, signal, seconds, memory
// Exact numbers that may be large, or are no integers, are TEXT. Requires attempts without a
// conflict (find_conflict).
std::string sweep_database(const std::vector<Attempt>& attempts);

}  // namespace kinex::sweep

#endif
