// SPDX-License-Identifier: GPL-3.0-or-later
// InterruptGuard: while it lives, the first Ctrl-C sets a flag instead of ending the program.
#ifndef KINEX_EXPERIMENTS_VERBS_INTERRUPT_H
#define KINEX_EXPERIMENTS_VERBS_INTERRUPT_H

#include <csignal>

namespace kinex {

// One at a time: a signal's handler has no owner. A second Ctrl-C ends the program as usual.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
  bool interrupted() const;

 private:
  struct sigaction before_;
};

}  // namespace kinex

#endif
