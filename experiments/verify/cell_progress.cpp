// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/cell_progress.h"

#include <unistd.h>

#include <cstdio>
#include <utility>

namespace kinex {

namespace {

constexpr double kInterval = 0.2;      // seconds between two lines
constexpr double kTrustedPart = 0.02;  // of the cost, beyond which the time left is shown

}  // namespace

CellProgress::CellProgress(std::vector<double> costs)
    : costs_(std::move(costs)), terminal_(::isatty(STDERR_FILENO) != 0) {
  for (const double cost : costs_) cost_ += cost;
}

void CellProgress::show(std::size_t cell, const std::string& what) {
  if (!terminal_) return;
  const std::lock_guard lock(mutex_);
  const Clock::time_point now = Clock::now();
  if (std::chrono::duration<double>(now - last_).count() < kInterval) return;
  last_ = now;
  shown_ = true;
  std::fprintf(stderr, "\r\033[Kcell %zu of %zu: %s", cell + 1, costs_.size(), what.c_str());
  if (done_ > kTrustedPart * cost_) {
    const double seconds = std::chrono::duration<double>(now - began_).count();
    std::fprintf(stderr, "; %.0f s left", seconds * (cost_ - done_) / done_);
  }
  std::fflush(stderr);
}

void CellProgress::finished(std::size_t cell) {
  const std::lock_guard lock(mutex_);
  done_ += costs_[cell];
}

void CellProgress::wipe() {
  const std::lock_guard lock(mutex_);
  if (shown_) std::fputs("\r\033[K", stderr);
  shown_ = false;
}

}  // namespace kinex
