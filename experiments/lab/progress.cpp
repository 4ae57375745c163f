// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "experiments/lab/time_taken.h"

namespace kinex::lab {

namespace {

constexpr double kOnTerminal = 0.25;   // seconds between two lines
constexpr double kElsewhere = 60;
constexpr double kTrustedPart = 0.02;  // of the cost, beyond which the time left is shown
constexpr std::size_t kFewestPieces = 3;  // with fewer their spread is not known
constexpr double kLeastSeconds = 0.002;   // a piece that is run takes longer
constexpr double kDeviations = 2;
constexpr double kNarrow = 1.3;  // a range is shown if its ends are farther apart
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

double PiecesDone::steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

PiecesDone::PiecesDone(std::vector<double> costs, std::function<double()> clock)
    : costs_(std::move(costs)),
      clock_(std::move(clock)),
      began_(clock_()),
      done_(costs_.size(), false) {}

void PiecesDone::started(std::size_t piece) {
  const std::lock_guard lock(mutex_);
  running_.try_emplace(piece, clock_());
}

void PiecesDone::finished(std::size_t piece) {
  const std::lock_guard lock(mutex_);
  done_[piece] = true;
  const auto run = running_.find(piece);
  if (run == running_.end()) return;
  const double seconds = clock_() - run->second;
  // What an earlier command had finished takes no time, and says nothing of the rest.
  if (seconds > kLeastSeconds && costs_[piece] > 0) taken_.emplace_back(costs_[piece], seconds);
  running_.erase(run);
}

std::optional<PiecesDone::Forecast> PiecesDone::forecast() const {
  double cost = 0, squares = 0, seconds = 0;
  for (const auto& [c, s] : taken_) {
    cost += c;
    squares += c * c;
    seconds += s;
  }
  if (taken_.size() < kFewestPieces) return std::nullopt;
  const double factor = seconds / cost;
  double variance = 0;  // of the factors, relative to their mean
  for (const auto& [c, s] : taken_) variance += c / cost * std::pow(s / c / factor - 1, 2);

  const double now = clock_();
  double rest = 0, rest_squares = 0, work = 0, longest = 0;
  for (std::size_t i = 0; i < costs_.size(); ++i) {
    if (done_[i]) continue;
    const auto run = running_.find(i);
    const double had = run == running_.end() ? 0 : now - run->second;
    seconds += had;
    rest += costs_[i];
    rest_squares += costs_[i] * costs_[i];
    const double due = std::max(0.0, factor * costs_[i] - had);
    work += due;
    longest = std::max(longest, due);
  }
  if (rest == 0 || cost < kTrustedPart * (cost + rest)) return std::nullopt;
  const double at_once = std::max(1.0, seconds / (now - began_));
  return Forecast{
      std::max(work / at_once, longest),
      kDeviations * std::sqrt(variance * (squares / (cost * cost) + rest_squares / (rest * rest)))};
}

std::string PiecesDone::left() const {
  const std::lock_guard lock(mutex_);
  const std::optional<Forecast> found = forecast();
  if (!found) return "";
  const double low = found->seconds / (1 + found->relative_error),
               high = found->seconds * (1 + found->relative_error);
  const std::string least = duration_text(low), most = duration_text(high);
  if (least == most || high < kNarrow * low)
    return "about " + duration_text(found->seconds) + " left";
  const std::size_t unit = least.find(' ');
  const bool one_unit = least.substr(unit) == most.substr(most.find(' '));
  return (one_unit ? least.substr(0, unit) : least) + " to " + most + " left";
}

std::string PiecesDone::text(std::size_t piece, const std::string& what) const {
  const std::string rest = left();
  return fmt::format("cell {} of {}: {}{}", piece + 1, costs_.size(), what,
                     rest.empty() ? "" : "; " + rest);
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
