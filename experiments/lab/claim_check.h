// SPDX-License-Identifier: GPL-3.0-or-later
// Checks one small run of each claim by a second program.
#ifndef KINEX_EXPERIMENTS_LAB_CLAIM_CHECK_H
#define KINEX_EXPERIMENTS_LAB_CLAIM_CHECK_H

#include <functional>
#include <string>
#include <vector>

#include "experiments/lab/claim.h"
#include "experiments/lab/record_store.h"
#include "experiments/lab/second_program.h"

namespace kinex::lab {

// `run` at the smallest useful size: few enough points, or vertices of bodies, for every level of
// the second program, and enough that every level has something to check.
RunKey small_run(RunKey run);

// Fills in checked_by of all claims. Runs in the store are not checked again; accepted ones are
// added to it. A claim whose run is refused becomes open, with the reason. Returns the refusals,
// one per run. `on_run` is called before a run is checked.
std::vector<std::string> check_claims(std::vector<PaperClaim>& claims, const SecondProgram& program,
                                      RecordStore& store,
                                      const std::function<void(const RunKey&)>& on_run);

}  // namespace kinex::lab

#endif
