// SPDX-License-Identifier: GPL-3.0-or-later
// Deadline: the time at which a run has to stop. All code that may take long polls it.
//
// A run must stop when its time is up, or when a flag is raised (by a signal, for example). From
// then on due() is true, and the run stops after the present instant. If that instant takes longer
// than kGrace, or no instant is being processed (structures are being built, an audit is made),
// look() throws Stopped.
#ifndef KINEX_CORE_NUMBERS_STOP_H
#define KINEX_CORE_NUMBERS_STOP_H

#include <atomic>
#include <chrono>
#include <cstdint>
#include <exception>

namespace kinex {

// Thrown out of interrupted work, which stays unfinished.
class Stopped final : public std::exception {
 public:
  const char* what() const noexcept override { return "the run was stopped"; }
};

// Owned by a run, polled by its thread only. Time is wall time, and counted while it is running.
class Deadline {
 public:
  static constexpr std::chrono::milliseconds kGrace{300};

  // Never.
  Deadline() = default;
  // Due after `seconds` (0: never), or when `interrupt` (may be null; it must outlive this) is
  // true. Starts running.
  Deadline(double seconds, const std::atomic<bool>* interrupt);

  void resume();
  void pause();
  bool running() const { return running_; }

  // True if the run has to stop after the present instant. For frequent calls: the clock is read
  // only now and then.
  bool due() {
    if (!running_) return false;
    if (is_due_ || (++asked_ & kSeldom) != 0) return is_due_;
    return note_due();
  }
  // For frequent calls: throws Stopped if the run is due and kGrace has passed.
  void poll() {
    if (running_ && (++asked_ & kSeldom) == 0) look();
  }
  // poll() for rare calls: the clock is read every time.
  void look() {
    if (running_ && note_due()) throw_if_late();
  }
  // True if the flag made the run due.
  bool interrupted() const { return interrupted_; }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::uint32_t kSeldom = 15;  // one in 16

  bool note_due();
  void throw_if_late() const;

  const std::atomic<bool>* interrupt_ = nullptr;
  bool limited_ = false;
  bool running_ = false;
  bool is_due_ = false;
  bool interrupted_ = false;
  std::uint32_t asked_ = 0;
  Clock::duration left_{};        // while it does not run
  Clock::time_point end_;         // while it runs
  Clock::time_point due_since_;
};

// deadline->look(), for work that may have no deadline (null).
inline void look(Deadline* deadline) {
  if (deadline != nullptr) deadline->look();
}

}  // namespace kinex

#endif
