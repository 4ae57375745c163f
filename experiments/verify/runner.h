// SPDX-License-Identifier: GPL-3.0-or-later
// Runner: the results of the cells of a catalogue, several at a time if requested. They do not depend
// on the number of jobs, times aside: cells share nothing, and are handed over in the catalogue's order.
#ifndef KINEX_EXPERIMENTS_VERIFY_RUNNER_H
#define KINEX_EXPERIMENTS_VERIFY_RUNNER_H

#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/lab/growth.h"
#include "experiments/sweep/cell_source.h"

namespace kinex::verify {

// The claim of the check of a cell whose run threw.
inline constexpr const char* kThrew = "error";

struct VerifyOptions {
  int jobs = 1;                      // more than one makes time ratios noisy
  std::optional<int> seeds;          // exactly this many for every random cell
  std::string keep_folder;           // for scenes that fail; empty: they are not kept
  sweep::CellSource source;          // runs cells, or has their records
  const std::atomic<bool>* interrupt = nullptr;  // as in SimulatorOptions, of runs in this process
  // Cell `index` is about to be run. Called from all threads.
  std::function<void(std::size_t index)> on_start;
  // In the catalogue's order, one at a time.
  std::function<void(std::size_t index, const lab::CellResult&)> on_cell;
};

struct VerifyResult {
  std::vector<lab::CellResult> cells;  // those that finished
  std::vector<lab::GrowthResult> growths;
  std::vector<lab::StudyResult> studies;
  bool interrupted = false;

  lab::Verdict verdict() const;
};

// All runs of a cell, in this process, not judged; nullopt if it was interrupted. Throws what a run throws.
std::optional<lab::CellResult> run_trials(const lab::Cell& cell, const VerifyOptions& options);
// A cell with all its runs, by options.source, judged; nullopt if it was interrupted. A crash is a failed
// check.
std::optional<lab::CellResult> run_cell(const lab::Cell& cell, const VerifyOptions& options);

VerifyResult run_catalogue(const lab::Catalogue& catalogue, const VerifyOptions& options);

}  // namespace kinex::verify

#endif
