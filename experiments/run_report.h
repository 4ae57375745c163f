// SPDX-License-Identifier: GPL-3.0-or-later
// The results of a run as text.
#ifndef KINEX_EXPERIMENTS_RUN_REPORT_H
#define KINEX_EXPERIMENTS_RUN_REPORT_H

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/scene_run.h"

namespace kinex {

// The counts of a run, over all structures. Reports, summaries and logs use these words:
//   certificate failures   failures of certificates that were handled
//   events                 external and internal
//   log records            lines of an event log between its header and its last line
struct RunCounts {
  std::uint64_t external = 0, internal = 0, failures = 0, records = 0, instants = 0;
  std::uint64_t events() const { return external + internal; }
};
RunCounts counts_of(const Simulator& simulator);

// A table of counts by structure, the bounds, samples; a last line with all counts and the seconds.
std::string describe_results(const Simulator& simulator, const RunOutcome& outcome);

// Failures: violated bounds, corruption, violations found by audits.
std::vector<std::string> failures_of(const Simulator& simulator, const RunOutcome& outcome);

}  // namespace kinex

#endif
