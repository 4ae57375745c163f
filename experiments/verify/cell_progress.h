// SPDX-License-Identifier: GPL-3.0-or-later
// CellProgress: one line on standard error, only if that is a terminal.
#ifndef KINEX_EXPERIMENTS_VERIFY_CELL_PROGRESS_H
#define KINEX_EXPERIMENTS_VERIFY_CELL_PROGRESS_H

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>
#include <vector>

namespace kinex {

// All functions may be called from any thread.
class CellProgress {
 public:
  // `costs`: the expected cost of each cell.
  explicit CellProgress(std::vector<double> costs);
  ~CellProgress() { wipe(); }
  CellProgress(const CellProgress&) = delete;
  CellProgress& operator=(const CellProgress&) = delete;

  // "cell 12 of 130: WHAT; 45 s left", a few times a second.
  void show(std::size_t cell, const std::string& what);
  // The cell is done: its expected cost counts for the time left.
  void finished(std::size_t cell);
  // Clears the line, before other output.
  void wipe();

 private:
  using Clock = std::chrono::steady_clock;
  const std::vector<double> costs_;
  const bool terminal_;
  std::mutex mutex_;
  bool shown_ = false;
  double cost_ = 0, done_ = 0;
  Clock::time_point began_ = Clock::now();
  Clock::time_point last_ = began_ - std::chrono::seconds(1);
};

}  // namespace kinex

#endif
