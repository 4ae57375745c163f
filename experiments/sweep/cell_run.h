// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a cell in this process: the work of a child.
#ifndef KINEX_EXPERIMENTS_SWEEP_CELL_RUN_H
#define KINEX_EXPERIMENTS_SWEEP_CELL_RUN_H

#include <string>
#include <string_view>

#include "experiments/sweep/outcome.h"
#include "experiments/sweep/sweep_cell.h"

namespace kinex::sweep {

struct CellReport {
  Outcome outcome = Outcome::kDone;  // kDone, kFailed, kRefused or kMemory
  std::string message;               // what failed, or was refused; empty if it is done
  double simulate_s = 0;             // CPU time of the simulation, without set-up and audits
  long peak_kb = 0;                  // of the process: own_peak_kb
  // Canonical JSON of everything that every machine must find alike; empty unless it is done or has
  // failed:
  //   scene, scene_hash, numbers, objects    numbers: the arithmetic by its own name
  //   digest                                 of the events and their order: log_digest.h
  //   ended                                  "done", or "limit" at max_events
  //   run                                    {"counters": {..}, "extremes": {..}}
  //   structures      {LABEL: the same, "bounds": [{"id", "bound", "observed", "holds", "source"},
  //                   ..], "corrupt": TEXT}, ..}; no bounds where the run ended at max_events
  //   violations      of audits, as text
  std::string exact;
};

// Memory that is exhausted is reported, not thrown; a program error is thrown.
CellReport run_cell(const Cell& cell);

// The report as one line of JSON, and back. Throws InputError for text that is no report.
std::string report_text(const CellReport& report);
CellReport parse_report(std::string_view text, const std::string& file);

}  // namespace kinex::sweep

#endif
