// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a part of a paper, or takes its runs from records, and judges its claims.
#ifndef KINEX_EXPERIMENTS_REPRODUCE_RUNNER_H
#define KINEX_EXPERIMENTS_REPRODUCE_RUNNER_H

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>

#include "experiments/lab/second_program.h"
#include "experiments/reproduce/paper_files.h"
#include "experiments/sweep/cell_source.h"

namespace kinex::reproduce {

struct RunnerOptions {
  int jobs = 1;
  bool quick = false;
  std::string command;                                 // reproduces the part
  sweep::CellSource source;                            // with a journal
  const std::atomic<bool>* interrupt = nullptr;        // as in SimulatorOptions, of runs in this process
  // A point is about to be run; its place in the part. Called from any thread.
  std::function<void(std::size_t, const lab::SeriesPoint&)> on_start;
  std::function<void(std::size_t)> on_point;           // in order
  std::function<void(const lab::RunKey&)> on_check;
};

// What is in the journal is not run again; new records are added to it. After an interruption all
// claims are open.
ReproducedPart run_part(const lab::PaperPart& part, const lab::SecondProgram& program,
                        const RunnerOptions& options);

}  // namespace kinex::reproduce

#endif
