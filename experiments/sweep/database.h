// SPDX-License-Identifier: GPL-3.0-or-later
// The merged database of a sweep. See settled.h for the merge.
#ifndef KINEX_EXPERIMENTS_SWEEP_DATABASE_H
#define KINEX_EXPERIMENTS_SWEEP_DATABASE_H

#include <string>
#include <vector>

#include "experiments/sweep/settled.h"

namespace kinex::sweep {

// The bytes of an SQLite file. Exact tables depend on plans and verdicts alone, not on shards,
// repeated runs or order:
//   plan      the plans
//   cell      every cell of a plan, and others that were run; by key. status: that of its settled
//             record, or "missing"
//   run       one row for each cell of runs that is done or has failed
//   counter, extreme, bound, violation    of runs; structure '': over all structures
// Other tables:
//   provenance    one row per attempt file: plan, program, machine, command
//   attempt       one row per record: status, signal, seconds, memory
// Exact numbers that may be large, or are no integers, are TEXT. Requires attempts without a
// conflict (find_conflict).
std::string sweep_database(const std::vector<Attempt>& attempts,
                           const Experiments& experiments = {});

}  // namespace kinex::sweep

#endif
