// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verbs/interrupt.h"

#include <chrono>
#include <cstddef>
#include <optional>

namespace kinex::verbs {

namespace {

std::atomic<bool> interrupt_seen{false};
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void note_interrupt(int) { interrupt_seen.store(true, std::memory_order_relaxed); }

}  // namespace

InterruptGuard::InterruptGuard() {
  interrupt_seen = false;
  struct sigaction action = {};
  sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    const bool is_pipe = kSignals[i] == SIGPIPE;
    action.sa_handler = is_pipe ? SIG_IGN : note_interrupt;
    action.sa_flags = is_pipe ? 0 : static_cast<int>(SA_RESETHAND | SA_RESTART);
    sigaction(kSignals[i], &action, &before_[i]);
    // What is ignored stays so: SIGHUP under nohup, SIGINT of a script's job in the background.
    if (!is_pipe && before_[i].sa_handler == SIG_IGN) sigaction(kSignals[i], &before_[i], nullptr);
  }
}

InterruptGuard::~InterruptGuard() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &before_[i], nullptr);
}

std::function<bool()> InterruptGuard::go_on_a_while() const {
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kAWhile{500};
  return [this, asked = std::optional<Clock::time_point>()]() mutable {
    if (!interrupted()) return true;
    if (!asked) asked = Clock::now();
    return Clock::now() - *asked < kAWhile;
  };
}

const std::atomic<bool>& InterruptGuard::flag() const { return interrupt_seen; }

}  // namespace kinex::verbs
