// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/verify_progress.h"

#include <unistd.h>

#include <cstdio>

namespace kinex {

namespace {

constexpr double kInterval = 0.2;      // seconds between two lines
constexpr double kTrustedPart = 0.02;  // of the cost, from which on the time left is told

}  // namespace

VerifyProgress::VerifyProgress(const Catalogue& catalogue)
    : catalogue_(catalogue), terminal_(::isatty(STDERR_FILENO) != 0) {
  for (const Cell& cell : catalogue.cells) cost_ += cell.cost;
}

void VerifyProgress::show(std::size_t index, int seed) {
  if (!terminal_) return;
  const std::lock_guard lock(mutex_);
  const Clock::time_point now = Clock::now();
  if (std::chrono::duration<double>(now - last_).count() < kInterval) return;
  last_ = now;
  shown_ = true;
  const Cell& cell = catalogue_.cells[index];
  std::fprintf(stderr, "\r\033[Kcell %zu of %zu: %s, %s, n = %d", index + 1,
               catalogue_.cells.size(), cell.structure.c_str(), cell.workload_text().c_str(),
               cell.parameters.n);
  if (cell.random) std::fprintf(stderr, ", scene %d", seed + 1);
  if (done_ > kTrustedPart * cost_) {
    const double seconds = std::chrono::duration<double>(now - began_).count();
    std::fprintf(stderr, "; %.0f s left", seconds * (cost_ - done_) / done_);
  }
  std::fflush(stderr);
}

void VerifyProgress::finished(std::size_t index) {
  const std::lock_guard lock(mutex_);
  done_ += catalogue_.cells[index].cost;
}

void VerifyProgress::wipe() {
  const std::lock_guard lock(mutex_);
  if (shown_) std::fputs("\r\033[K", stderr);
  shown_ = false;
}

}  // namespace kinex
