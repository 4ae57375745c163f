// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/progress.h"

#include <unistd.h>

#include <cstdio>

namespace kinex {

namespace {

constexpr double kInterval = 0.25;  // seconds between two lines
constexpr double kLongestEta = 1e7;

}  // namespace

Progress::Progress() : terminal_(::isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void Progress::show(const Simulator& simulator) {
  if (!terminal_) return;
  const Clock::time_point now = Clock::now();
  if (std::chrono::duration<double>(now - last_).count() < kInterval) return;
  last_ = now;
  shown_ = true;
  const double seconds = std::chrono::duration<double>(now - began_).count();
  const auto failures = static_cast<double>(simulator.ledger().events);
  const double t = simulator.arithmetic().now_approximate();
  std::fprintf(stderr, "\r\033[K%.0f certificate failures, t = %.6g, %.3g a second", failures, t,
               failures / seconds);
  const Scene& scene = simulator.scene();
  if (scene.end) {
    const double start = scene.start.to_double();
    const double fraction = (t - start) / (scene.end->to_double() - start);
    const double left = seconds * (1 - fraction) / fraction;
    if (fraction > 0 && left < kLongestEta) std::fprintf(stderr, ", %.0f s left", left);
  }
  std::fflush(stderr);
}

}  // namespace kinex
