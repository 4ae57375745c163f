// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace kinex::lab {

namespace {

constexpr double kOnTerminal = 0.25;   // seconds between two lines
constexpr double kElsewhere = 60;
constexpr double kTrustedPart = 0.02;  // of the cost, beyond which the time left is shown
constexpr double kLongestEta = 1e7;

}  // namespace

Progress::Progress(std::FILE* file, bool terminal, double interval)
    : file_(file), terminal_(terminal), interval_(interval) {}

Progress::Progress(bool wanted)
    : Progress(wanted ? stderr : nullptr, ::isatty(STDERR_FILENO) != 0,
               ::isatty(STDERR_FILENO) != 0 ? kOnTerminal : kElsewhere) {}

void Progress::show(const std::function<std::string(double seconds)>& text) {
  if (file_ == nullptr) return;
  const std::lock_guard lock(mutex_);
  const Clock::time_point now = Clock::now();
  if (std::chrono::duration<double>(now - last_).count() < interval_) return;
  last_ = now;
  shown_ = terminal_;
  const double seconds = std::chrono::duration<double>(now - began_).count();
  std::fprintf(file_, terminal_ ? "\r\033[K%s" : "kinex: %s\n", text(seconds).c_str());
  std::fflush(file_);
}

void Progress::wipe() {
  const std::lock_guard lock(mutex_);
  if (shown_) std::fputs("\r\033[K", file_);
  shown_ = false;
}

PiecesDone::PiecesDone(std::vector<double> costs) : costs_(std::move(costs)) {
  for (const double cost : costs_) cost_ += cost;
}

void PiecesDone::finished(std::size_t piece) {
  const std::lock_guard lock(mutex_);
  done_ += costs_[piece];
}

std::string PiecesDone::text(std::size_t piece, const std::string& what, double seconds) {
  const std::lock_guard lock(mutex_);
  std::string line = fmt::format("cell {} of {}: {}", piece + 1, costs_.size(), what);
  if (done_ > kTrustedPart * cost_) {
    line += fmt::format("; {:.0f} s left", seconds * (cost_ - done_) / done_);
  }
  return line;
}

std::string progress_text(const Simulator& simulator, double seconds) {
  const auto failures = static_cast<double>(simulator.ledger().events);
  const double t = simulator.arithmetic().now_approximate();
  std::string line = fmt::format("{:.0f} certificate failures, t = {:.6g}, {:.3g} a second",
                                 failures, t, failures / seconds);
  const Scene& scene = simulator.scene();
  if (scene.end) {
    const double start = scene.start.to_double();
    const double fraction = (t - start) / (scene.end->to_double() - start);
    const double left = seconds * (1 - fraction) / fraction;
    if (fraction > 0 && left < kLongestEta) line += fmt::format(", {:.0f} s left", left);
  }
  return line;
}

std::string progress_text(std::size_t done, std::size_t all, double seconds) {
  const auto finished = static_cast<double>(done);
  return fmt::format("{} of {} queries, {:.3g}/s, {:.0f} s left", done, all, finished / seconds,
                     seconds * static_cast<double>(all - done) / finished);
}

}  // namespace kinex::lab
