// SPDX-License-Identifier: GPL-3.0-or-later
// The runs of studies: audited, held to their bounds, and what is wrong in one refutes what is said of them.
#ifndef KINEX_EXPERIMENTS_LAB_STUDY_RUNS_H
#define KINEX_EXPERIMENTS_LAB_STUDY_RUNS_H

#include <string>
#include <string_view>

#include "core/engine/simulator.h"
#include "experiments/lab/claim.h"
#include "experiments/lab/judge.h"

namespace kinex::lab {

// Audits a run where it stands, at a rational time right after now, and adds a refuted check "STUDY.runs" to
// the study if the audit, an earlier one, or a bound of one of its structures failed. `run`: what it was, in words.
void check_run(Simulator& simulator, std::string_view run, StudyResult& study);

// A claim on a study with refuted checks is refuted, and says how many there are and what the first one is.
void refute_by_checks(const StudyResult& study, PaperClaim& claim);

}  // namespace kinex::lab

#endif
