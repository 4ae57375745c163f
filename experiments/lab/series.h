// SPDX-License-Identifier: GPL-3.0-or-later
// Series: runs of one structure over one workload at growing n, and their means.
#ifndef KINEX_EXPERIMENTS_LAB_SERIES_H
#define KINEX_EXPERIMENTS_LAB_SERIES_H

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/lab/field_archive.h"
#include "experiments/lab/run_record.h"
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
  std::function<bool()> go_on = [] { return true; };
  const std::atomic<bool>* interrupt = nullptr;  // as in SimulatorOptions
};

// All runs of a point; nullopt if it was interrupted.
std::optional<SeriesResult> run_point(const SeriesPoint& point, const SeriesOptions& options);

// The runs as text, and back: nullopt if the texts are not of runs. Of the point, nothing.
Fields runs_fields(const std::vector<RunRecord>& runs);
std::optional<std::vector<RunRecord>> runs_of(const Fields& fields);

}  // namespace kinex::lab

#endif
