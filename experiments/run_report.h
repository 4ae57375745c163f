// SPDX-License-Identifier: GPL-3.0-or-later
// The results of a run in lines for people.
#ifndef KINEX_EXPERIMENTS_RUN_REPORT_H
#define KINEX_EXPERIMENTS_RUN_REPORT_H

#include <string>
#include <vector>

#include "experiments/scene_run.h"

namespace kinex {

// A table of counts by structure, the bounds, samples, and the seconds.
std::string describe_results(const Simulator& simulator, const RunOutcome& outcome);

// What went wrong: bounds that do not hold, corruption, violations of audits.
std::vector<std::string> failures_of(const Simulator& simulator, const RunOutcome& outcome);

}  // namespace kinex

#endif
