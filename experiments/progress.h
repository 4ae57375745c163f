// SPDX-License-Identifier: GPL-3.0-or-later
// Progress: one line on standard error, only where that is a terminal.
#ifndef KINEX_EXPERIMENTS_PROGRESS_H
#define KINEX_EXPERIMENTS_PROGRESS_H

#include <chrono>

#include "core/engine/simulator.h"

namespace kinex {

class Progress {
 public:
  Progress();
  ~Progress();  // wipes the line
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // Events, simulated time, events per second, and the time left where the end is known; at most a
  // few times a second.
  void show(const Simulator& simulator);

 private:
  using Clock = std::chrono::steady_clock;
  bool terminal_;
  bool shown_ = false;
  Clock::time_point began_ = Clock::now();
  Clock::time_point last_ = began_;
};

}  // namespace kinex

#endif
