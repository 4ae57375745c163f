// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/engine/run_clock.h"

#include <algorithm>
#include <ctime>

namespace kinex {
namespace {

double read(clockid_t clock) {
  timespec t;
  clock_gettime(clock, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace

Seconds& Seconds::operator+=(const Seconds& other) {
  cpu += other.cpu;
  wall += other.wall;
  return *this;
}

Seconds& Seconds::operator-=(const Seconds& other) {
  cpu -= other.cpu;
  wall -= other.wall;
  return *this;
}

Seconds seconds_now() { return {read(CLOCK_THREAD_CPUTIME_ID), read(CLOCK_MONOTONIC)}; }

// ---- phases

RunPhase RunClock::enter(RunPhase phase) {
  const RunPhase before = phase_;
  const Seconds now = seconds_now();
  Seconds& total = of_phase_[static_cast<std::size_t>(before)];
  total += now;
  total -= phase_began_;
  phase_ = phase;
  phase_began_ = now;
  return before;
}

// Estimates of reports may exceed what was left of a phase.
Seconds RunClock::seconds(RunPhase phase) const {
  Seconds total = of_phase_[static_cast<std::size_t>(phase)];
  if (phase == phase_) {
    total += seconds_now();
    total -= phase_began_;
  }
  return {std::max(total.cpu, 0.0), std::max(total.wall, 0.0)};
}

// ---- structures

void RunClock::charge_other(StructureId id) {
  const Clock::time_point now = Clock::now();
  if (charged_ == kNoStructure) {
    stretch_began_ = seconds_now();
    stretch_reports_ = {};
  } else {
    wall_[charged_] += std::chrono::duration<double>(now - charged_since_).count();
  }
  if (id == kNoStructure) {
    Seconds stretch = seconds_now();
    stretch -= stretch_began_;
    stretch -= stretch_reports_;
    double wall = 0;
    for (double& w : wall_) wall += w = std::max(w, 0.0);
    const double cpu = std::max(stretch.cpu, 0.0);
    for (std::size_t i = 0; i < wall_.size(); ++i) {
      if (wall > 0) of_structure_[i] += cpu * wall_[i] / wall;
      wall_[i] = 0;
    }
  } else if (wall_.size() <= id) {
    wall_.resize(id + std::size_t{1}, 0.0);
    of_structure_.resize(id + std::size_t{1}, 0.0);
  }
  charged_ = id;
  charged_since_ = now;
}

// ---- reports

// The cost of reading the clocks is measured too: it may be as large as a short call's.
void RunClock::end_report(const Seconds& begin) {
  const Seconds end = seconds_now();
  Seconds empty = seconds_now();
  empty -= end;
  Seconds call = end;
  call -= begin;
  call -= empty;
  ++measured_;
  measured_cpu_ += call.cpu;
  cost_cpu_ += empty.cpu;
  // A wait (a full disk cache, another process) is counted once: it is rare, and the calls left out
  // need not contain any.
  const double cpu = call.cpu * static_cast<double>(gap_);
  const Seconds all{cpu, cpu + std::max(call.wall - call.cpu, 0.0)};
  of_phase_[static_cast<std::size_t>(RunPhase::kReport)] += all;
  of_phase_[static_cast<std::size_t>(phase_)] -= all;
  if (charged_ != kNoStructure) {
    stretch_reports_ += all;
    wall_[charged_] -= all.wall;
  }
  gap_ = until_measured_ = next_gap();
}

// Uniform in 1 .. 2 g - 1: g on average, and independent of the cost of the calls left out.
std::uint64_t RunClock::next_gap() {
  if (measured_ < kAlwaysMeasured) return 1;
  const double wanted =
      measured_cpu_ > 0 ? kShare * 3 * cost_cpu_ / measured_cpu_ : static_cast<double>(kLongestGap);
  const auto g =
      static_cast<std::uint64_t>(std::clamp(wanted, 1.0, static_cast<double>(kLongestGap)));
  random_ = random_ * 6364136223846793005 + 1442695040888963407;
  return 1 + (random_ >> 33) % (2 * g - 1);
}

}  // namespace kinex
