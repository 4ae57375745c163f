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

namespace kinex {

// `run` at its smallest useful size: few enough points, or vertices of bodies, for every level of
// the second program, and enough for every level to have work.
RunKey small_run(RunKey run);

// Fills in checked_by of all claims. Runs in the store are not checked again; accepted ones are
// added to it. A claim whose run is refused is not confirmed: it is left open, with the reason.
// Returns the refusals, one a run. `on_run`: a run is about to be checked.
std::vector<std::string> check_claims(std::vector<PaperClaim>& claims, const SecondProgram& program,
                                      RecordStore& store,
                                      const std::function<void(const RunKey&)>& on_run);

}  // namespace kinex

#endif
