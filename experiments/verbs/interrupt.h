// SPDX-License-Identifier: GPL-3.0-or-later
// InterruptGuard: while it lives, the first Ctrl-C (SIGINT), SIGTERM or SIGHUP sets a flag instead
// of ending the program, and writing to a pipe whose reader has gone fails as any other write does.
//
// The verbs that run something (run, verify, reproduce, trade, view, ccd) create one as soon as
// there are results to keep. All others do not handle signals, and the program ends at once: verbs
// that only read (check, diff, roots), verbs that write one file at their end (gen, import), and
// run and view while they read their scene.
#ifndef KINEX_EXPERIMENTS_VERBS_INTERRUPT_H
#define KINEX_EXPERIMENTS_VERBS_INTERRUPT_H

#include <array>
#include <atomic>
#include <csignal>
#include <functional>

namespace kinex::verbs {

// Only one may exist at a time: signal handlers are global. A second signal of the same kind ends
// the program.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
  bool interrupted() const { return flag().load(std::memory_order_relaxed); }
  // The flag itself, for SimulatorOptions::interrupt.
  const std::atomic<bool>& flag() const;
  // A `go_on` for optional work on finished results, such as plots: after an interruption it
  // returns false half a second after its first call.
  std::function<bool()> go_on_a_while() const;

 private:
  static constexpr std::array<int, 4> kSignals{SIGINT, SIGTERM, SIGHUP, SIGPIPE};
  std::array<struct sigaction, kSignals.size()> before_;
};

}  // namespace kinex::verbs

#endif
