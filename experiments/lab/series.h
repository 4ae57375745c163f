// SPDX-License-Identifier: GPL-3.0-or-later
// Series: runs of one structure over one workload at growing n, and their means.
#ifndef KINEX_EXPERIMENTS_LAB_SERIES_H
#define KINEX_EXPERIMENTS_LAB_SERIES_H

#include <atomic>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "experiments/lab/record_store.h"
#include "experiments/lab/statistics.h"

namespace kinex::lab {

// A count of a run by name: "processed", "external", "max_live", "max_per_object", "signs",
// "kind.NAME", "solved.DEGREE" (0 for a kind or a degree that did not occur). Throws
// std::invalid_argument for other names.
double quantity_of(const RunRecord& record, const std::string& quantity);

// Runs with seeds 1, 2, .. until the standard error of `precise` is below `relative_error` of its
// mean: at least min_seeds, at most max_seeds.
struct SeriesPoint {
  RunKey key;  // its seed is set by the runner
  std::string precise = "external";
  double relative_error = 0.02;
  int min_seeds = 8;
  int max_seeds = 2000;
  double cost = 1;  // seconds, for progress
};

struct SeriesResult {
  SeriesPoint point;
  std::vector<RunRecord> runs;

  RunningMean mean(const std::string& quantity) const;
};

struct SeriesOptions {
  int jobs = 1;
  std::function<bool()> go_on = [] { return true; };               // from any thread
  const std::atomic<bool>* interrupt = nullptr;  // as in SimulatorOptions
  std::function<void(std::size_t, const std::string&)> on_run;     // point, which run; any thread
  std::function<void(std::size_t, const SeriesResult&)> on_point;  // in order
};

struct SeriesRun {
  std::vector<SeriesResult> results;  // in the order of the points
  bool interrupted = false;
  std::vector<std::string> troubles;  // audits and bounds that failed; empty in a correct program
};

// Runs that are in the store are not repeated; new ones are added to it.
SeriesRun run_series(const std::vector<SeriesPoint>& points, RecordStore& store,
                     const SeriesOptions& options);

}  // namespace kinex::lab

#endif
