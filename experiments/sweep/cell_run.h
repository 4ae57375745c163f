// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a cell in this process. A sweep calls it in child processes.
#ifndef KINEX_EXPERIMENTS_SWEEP_CELL_RUN_H
#define KINEX_EXPERIMENTS_SWEEP_CELL_RUN_H

#include <string>
#include <string_view>

#include "experiments/sweep/outcome.h"
#include "experiments/sweep/run_cell.h"

namespace kinex::sweep {

struct CellReport {
  Outcome outcome = Outcome::kDone;  // kDone, kFailed, kRefused, kMemory, or kLimit of its own
  std::string message;               // the failure or the refusal; empty for kDone
  double simulate_s = 0;             // CPU time of the simulation, without set-up and audits
  long peak_kb = 0;                  // of the process: own_peak_kb
  // Canonical JSON of all results that must be equal on every machine; empty unless the outcome is
  // kDone or kFailed:
  //   scene, scene_hash, numbers, objects    numbers: the arithmetic by its own name
  //   digest                                 of the events and their order: log_digest.h
  //   ended                                  "done", or "limit" at max_events
  //   run                                    {"counters": {..}, "extremes": {..}}
  //   structures      {LABEL: the same, "bounds": [{"id", "bound", "observed", "holds", "source"},
  //                   ..], "corrupt": TEXT}, ..}; no bounds where the run ended at max_events
  //   violations      of audits, as text
  // of cells of experiments, also where it is kLimit: their own (experiment.h).
  std::string exact;
  std::string times;  // of cells of experiments: the rest, which no two runs have alike
};

// Exhausted memory is reported as kMemory; exceptions of program errors are passed on.
CellReport run_cell(const RunCell& cell);

// The report as one line of JSON, and back. parse_report throws InputError for text that is no
// report.
std::string report_text(const CellReport& report);
CellReport parse_report(std::string_view text, const std::string& file);

}  // namespace kinex::sweep

#endif
