// SPDX-License-Identifier: GPL-3.0-or-later
// The results of a run as text.
#ifndef KINEX_EXPERIMENTS_FORMATS_RUN_REPORT_H
#define KINEX_EXPERIMENTS_FORMATS_RUN_REPORT_H

#include <string>
#include <vector>

#include "experiments/formats/run_outcome.h"

namespace kinex::formats {

// A table of counts by structure, the bounds, samples; a last line with the counts of what the scene maintains, those
// of structures that exist only to be read, and the seconds.
std::string describe_results(const Simulator& simulator, const RunOutcome& outcome);

// The attributes at the times that were asked for, and the answers to queries: a line each. They are in the text
// above, too.
std::string describe_samples(const Simulator& simulator, const RunOutcome& outcome);

// Failures: violated bounds, corruption, violations found by audits; each once.
std::vector<std::string> failures_of(const Simulator& simulator, const RunOutcome& outcome);

}  // namespace kinex::formats

#endif
