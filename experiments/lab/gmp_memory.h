// SPDX-License-Identifier: GPL-3.0-or-later
// GMP's memory, for the program: exhaustion is an exception (GMP itself would abort), and a long
// operation on huge numbers can be stopped midway.
//
// Both throw through GMP. GMP's functions keep no state and hold no locks; their temporary
// allocations leak, which is little if the program ends soon after. One case would be unsafe: some
// functions free the memory of the result just before they allocate a larger block, and would leave
// it dangling. Therefore freed memory is released only with the next successful allocation; if that
// throws, the memory stays with its owner. The values and the sizes of numbers that were being written
// are then unspecified; such numbers may only be destroyed.
#ifndef KINEX_EXPERIMENTS_LAB_GMP_MEMORY_H
#define KINEX_EXPERIMENTS_LAB_GMP_MEMORY_H

#include "core/numbers/stop.h"

namespace kinex::lab {

// To be called once, at the program's start. From then on an allocation of GMP or MPFR for which
// there is no memory throws std::bad_alloc in a thread that has a GmpGuard, and otherwise ends the
// program with a message and exit code 3.
void install_gmp_memory();

// During its lifetime GMP in this thread checks `deadline` (null: none) at every large allocation,
// and throws Stopped when the run must stop. Of nested guards the innermost is in force.
class GmpGuard {
 public:
  explicit GmpGuard(Deadline* deadline = nullptr);
  ~GmpGuard();
  GmpGuard(const GmpGuard&) = delete;
  GmpGuard& operator=(const GmpGuard&) = delete;

 private:
  Deadline* before_;
};

}  // namespace kinex::lab

#endif
