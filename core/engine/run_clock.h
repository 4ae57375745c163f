// SPDX-License-Identifier: GPL-3.0-or-later
// RunClock: the time of a run by phase and by structure.
//
// Figures are CPU time of the thread, which does not depend on the machine's load; phases have wall
// time as well. Reading the CPU clock is a system call (a few hundred nanoseconds) and may cost
// more than an event of a sorted list. Therefore
//
//   phases      read both clocks when the phase changes: a few times in a run without audits.
//   structures  read the wall clock (no system call) when another structure is called; the CPU time
//               of the whole stretch is divided in proportion.
//   reports     (calls of the event sink) are sampled: all of the first kAlwaysMeasured, then one
//               in g on average, where g keeps the cost of measuring below about 1/kShare of the
//               sink's own. The gaps vary, so that a periodic pattern of events does not bias the
//               sample. A measured call stands for itself and for the calls since the previous
//               measured one. Their time is moved from the phase and the structure in which they
//               were made to kReport.
#ifndef KINEX_CORE_ENGINE_RUN_CLOCK_H
#define KINEX_CORE_ENGINE_RUN_CLOCK_H

#include <array>
#include <chrono>
#include <cstdint>
#include <vector>

#include "core/engine/certificate.h"

namespace kinex {

struct Seconds {  // a length of time by both clocks
  double cpu = 0;  // of the calling thread
  double wall = 0;

  Seconds& operator+=(const Seconds& other);
  Seconds& operator-=(const Seconds& other);
};

// Both clocks, read now; only differences mean anything.
Seconds seconds_now();

enum class RunPhase : std::uint8_t {  // what the time of a run is spent on
  kOther,     // outside of the run
  kSetup,     // building the structures, and repairs at the scene's start
  kSimulate,  // events and flight-plan changes
  kReport,    // the event sink: digest, log
  kAudit,
};
inline constexpr std::size_t kRunPhases = 5;  // the number of phases

class RunClock {
 public:
  // Time is charged to `phase` during this object's life, afterwards to the previous phase again.
  class Scope {
   public:
    Scope(RunClock& clock, RunPhase phase) : clock_(clock), before_(clock.enter(phase)) {}
    ~Scope() { clock_.enter(before_); }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    RunClock& clock_;
    RunPhase before_;
  };

  static constexpr StructureId kNoStructure = 0xff;

  // The time spent in this phase up to now.
  Seconds seconds(RunPhase phase) const;
  // CPU seconds of a structure in all stretches that have ended.
  double structure_seconds(StructureId id) const {
    return id < of_structure_.size() ? of_structure_[id] : 0.0;
  }

  // From now on this structure is at work. A stretch begins with the first structure and ends with
  // kNoStructure.
  void charge(StructureId id) {
    if (id != charged_) charge_other(id);
  }

  // Runs `call`, which calls the event sink; its time is measured or estimated.
  template <class Call>
  void report(const Call& call) {
    if (--until_measured_ > 0) {
      call();
      return;
    }
    const Seconds begin = seconds_now();
    call();
    end_report(begin);
  }

 private:
  static constexpr std::uint64_t kAlwaysMeasured = 64;
  static constexpr double kShare = 10;
  static constexpr std::uint64_t kLongestGap = 64;
  using Clock = std::chrono::steady_clock;

  RunPhase enter(RunPhase phase);
  void charge_other(StructureId id);
  void end_report(const Seconds& begin);
  std::uint64_t next_gap();

  std::array<Seconds, kRunPhases> of_phase_{};
  RunPhase phase_ = RunPhase::kOther;
  Seconds phase_began_;

  std::vector<double> of_structure_;  // CPU
  std::vector<double> wall_;          // of this stretch, by structure
  StructureId charged_ = kNoStructure;
  Clock::time_point charged_since_;
  Seconds stretch_began_, stretch_reports_;

  std::uint64_t until_measured_ = 1;
  std::uint64_t gap_ = 1;       // calls that the next measured one stands for
  std::uint64_t measured_ = 0;  // calls
  // Of measured calls, and of one reading of the clocks for each.
  double measured_cpu_ = 0, cost_cpu_ = 0;
  std::uint64_t random_ = 0x9e3779b97f4a7c15;
};

}  // namespace kinex

#endif
