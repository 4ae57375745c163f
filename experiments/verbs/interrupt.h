// SPDX-License-Identifier: GPL-3.0-or-later
// InterruptGuard: while it lives, the first Ctrl-C (SIGINT) or SIGTERM sets a flag instead of
// ending the program.
#ifndef KINEX_EXPERIMENTS_VERBS_INTERRUPT_H
#define KINEX_EXPERIMENTS_VERBS_INTERRUPT_H

#include <array>
#include <csignal>

namespace kinex {

// One at a time: a signal's handler has no owner. A second signal of the kind ends the program.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
  bool interrupted() const;

 private:
  static constexpr std::array<int, 2> kSignals{SIGINT, SIGTERM};
  std::array<struct sigaction, kSignals.size()> before_;
};

}  // namespace kinex

#endif
