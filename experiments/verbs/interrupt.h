// SPDX-License-Identifier: GPL-3.0-or-later
// InterruptGuard: while it lives, the first Ctrl-C (SIGINT), SIGTERM or SIGHUP sets a flag instead
// of ending the program, and writing to a pipe whose reader has gone fails as any other write does.
//
// The verbs that run something (run, verify, reproduce, trade, view, ccd) have one from where there
// is something to keep. Those that only read (check, diff, roots), those that write one file when
// they are done (gen, import), and run and view as long as they read their scene leave signals
// alone: the program ends at once.
#ifndef KINEX_EXPERIMENTS_VERBS_INTERRUPT_H
#define KINEX_EXPERIMENTS_VERBS_INTERRUPT_H

#include <array>
#include <atomic>
#include <csignal>
#include <functional>

namespace kinex {

// One at a time: a signal's handler has no owner. A second signal of the kind ends the program.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
  bool interrupted() const { return flag().load(std::memory_order_relaxed); }
  // The flag itself, for SimulatorOptions::interrupt.
  const std::atomic<bool>& flag() const;
  // For what is made of finished work, such as plots, that may be left out: after an interruption
  // it returns false half a second after its first call.
  std::function<bool()> go_on_a_while() const;

 private:
  static constexpr std::array<int, 4> kSignals{SIGINT, SIGTERM, SIGHUP, SIGPIPE};
  std::array<struct sigaction, kSignals.size()> before_;
};

}  // namespace kinex

#endif
