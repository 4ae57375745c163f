// SPDX-License-Identifier: GPL-3.0-or-later
// GMP's memory, for the program: its end is an exception (GMP itself would abort), and a long
// operation on huge numbers can be stopped in the midst.
//
// Both throw through GMP. Its functions keep no state and hold no locks; what they have allocated for
// themselves is lost, which is little where the program ends soon after. One thing is not safe: some
// of them free the memory of the result just before they allocate a larger one, and so would leave it
// dangling. Therefore what has been freed is really freed only with the next allocation that
// succeeds; where one throws, it is left to its owner. Numbers that were being written to hold
// anything then, and may only be destroyed.
#ifndef KINEX_EXPERIMENTS_GMP_MEMORY_H
#define KINEX_EXPERIMENTS_GMP_MEMORY_H

#include "core/stop.h"

namespace kinex {

// Once, at the program's start. From then on, while a thread has a GmpGuard, an allocation of GMP or
// MPFR for which there is no memory throws std::bad_alloc; without one it ends the program with a
// message and exit code 3.
void install_gmp_memory();

// While it lives, GMP in this thread looks at `deadline` (null: none) whenever it allocates much, and
// throws Stopped. The innermost one counts.
class GmpGuard {
 public:
  explicit GmpGuard(Deadline* deadline = nullptr);
  ~GmpGuard();
  GmpGuard(const GmpGuard&) = delete;
  GmpGuard& operator=(const GmpGuard&) = delete;

 private:
  Deadline* before_;
};

}  // namespace kinex

#endif
