// SPDX-License-Identifier: GPL-3.0-or-later
// Progress: a line on standard error, if it is wanted: on a terminal one that changes, elsewhere a new one
// a minute.
#ifndef KINEX_EXPERIMENTS_LAB_PROGRESS_H
#define KINEX_EXPERIMENTS_LAB_PROGRESS_H

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
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

// The time that is left for pieces of work with expected costs, several of which may run at once.
//
// A piece takes its cost times a factor of its own. The factors of finished pieces have a mean and a spread. What remains
// is the sum of the remaining costs times the mean, less the time that running pieces have had, and not less than the longest
// of them; each piece may be off by the spread. So a few expensive pieces that remain give a wide range, many cheap ones
// a narrow one. May be called from any thread.
class PiecesDone {
 public:
  // `clock`: seconds since some time in the past.
  explicit PiecesDone(std::vector<double> costs, std::function<double()> clock = steady_seconds);
  void started(std::size_t piece);
  void finished(std::size_t piece);
  // "cell 12 of 130: WHAT; 2 to 5 min left"
  std::string text(std::size_t piece, const std::string& what) const;
  // "2 to 5 min left", "about 40 s left"; empty while too little is finished to tell.
  std::string left() const;

 private:
  struct Forecast {
    double seconds = 0, relative_error = 0;
  };
  static double steady_seconds();
  std::optional<Forecast> forecast() const;

  const std::vector<double> costs_;
  const std::function<double()> clock_;
  const double began_;
  mutable std::mutex mutex_;
  std::map<std::size_t, double> running_;  // piece: when it began
  std::vector<bool> done_;
  std::vector<std::pair<double, double>>
      taken_;  // cost and seconds of pieces that have run to their end
};

// Certificate failures, simulated time, failures per second, and the time left where the end is
// known.
std::string progress_text(const Simulator& simulator, double seconds);
// "done of all queries, .. a second, .. s left"
std::string progress_text(std::size_t done, std::size_t all, double seconds);

}  // namespace kinex::lab

#endif
