// SPDX-License-Identifier: GPL-3.0-or-later
// Progress: a line on standard error, if it is wanted: on a terminal one that changes, elsewhere a new one
// a minute.
#ifndef KINEX_EXPERIMENTS_LAB_PROGRESS_H
#define KINEX_EXPERIMENTS_LAB_PROGRESS_H

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "core/engine/simulator.h"

namespace kinex::lab {

// All functions may be called from any thread.
class Progress {
 public:
  explicit Progress(bool wanted = true);
  // Writes to `file`: on a terminal a line that changes, elsewhere a line after every `interval` seconds.
  Progress(std::FILE* file, bool terminal, double interval);
  ~Progress() { wipe(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // Shows text(seconds since the start), at most a few times a second, or once a minute where there is no
  // terminal; more frequent calls do nothing.
  void show(const std::function<std::string(double seconds)>& text);
  // Clears the line of a terminal, before other output.
  void wipe();

 private:
  using Clock = std::chrono::steady_clock;
  std::FILE* const file_;  // nullptr: nothing is shown
  const bool terminal_;
  const double interval_;  // seconds between two lines
  std::mutex mutex_;
  bool shown_ = false;
  Clock::time_point began_ = Clock::now();
  Clock::time_point last_ = began_;
};

// Estimates the time left for pieces of work with expected costs. May be called from any thread.
class PiecesDone {
 public:
  explicit PiecesDone(std::vector<double> costs);
  // The piece is done: the estimate uses its expected cost.
  void finished(std::size_t piece);
  // "cell 12 of 130: WHAT; 45 s left"
  std::string text(std::size_t piece, const std::string& what, double seconds);

 private:
  const std::vector<double> costs_;
  std::mutex mutex_;
  double cost_ = 0, done_ = 0;
};

// Certificate failures, simulated time, failures per second, and the time left where the end is
// known.
std::string progress_text(const Simulator& simulator, double seconds);
// "done of all queries, .. a second, .. s left"
std::string progress_text(std::size_t done, std::size_t all, double seconds);

}  // namespace kinex::lab

#endif
