// SPDX-License-Identifier: GPL-3.0-or-later
// Checks one small run of each claim by a second program.
#ifndef KINEX_EXPERIMENTS_LAB_CLAIM_CHECK_H
#define KINEX_EXPERIMENTS_LAB_CLAIM_CHECK_H

#include <functional>
#include <string>
#include <vector>

#include "experiments/lab/claim.h"
#include "experiments/lab/checked_by.h"
#include "experiments/lab/run_record.h"

namespace kinex::lab {

// `run` at the smallest useful size: few enough points, or vertices of bodies, for every level of
// the second program, and enough that every level has something to check.
RunKey small_run(RunKey run);

// Fills in checked_by of all claims by `check`, which is called once for every small run. A claim
// whose run is refused becomes open, with the reason. Returns the refusals, one per run. `program`:
// the name of the second program, for claims without a run.
std::vector<std::string> check_claims(std::vector<PaperClaim>& claims, const std::string& program,
                                      const std::function<CheckedBy(const RunKey&)>& check);

}  // namespace kinex::lab

#endif
