// SPDX-License-Identifier: GPL-3.0-or-later
// Has one small run of each claim checked by a second program.
#ifndef KINEX_EXPERIMENTS_REPRODUCE_CLAIM_CHECK_H
#define KINEX_EXPERIMENTS_REPRODUCE_CLAIM_CHECK_H

#include <functional>
#include <string>
#include <vector>

#include "experiments/reproduce/claim.h"
#include "experiments/reproduce/record_store.h"
#include "experiments/reproduce/second_program.h"

namespace kinex {

// `run` as small as it is worth checking: with so few points, or vertices of bodies, that every
// level of the second program can be done and has something to do.
RunKey small_run(RunKey run);

// Fills in checked_by of all claims. What the store holds is not checked again; what is found fine
// is added to it. A claim whose run is refused is not confirmed: it is left open, and says why.
// Returns the refusals, one a run. `on_run`: a run is about to be checked.
std::vector<std::string> check_claims(std::vector<PaperClaim>& claims, const SecondProgram& program,
                                      RecordStore& store,
                                      const std::function<void(const RunKey&)>& on_run);

}  // namespace kinex

#endif
