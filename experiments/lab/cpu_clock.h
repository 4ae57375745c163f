// SPDX-License-Identifier: GPL-3.0-or-later
// The CPU clock of a thread.
#ifndef KINEX_EXPERIMENTS_LAB_CPU_CLOCK_H
#define KINEX_EXPERIMENTS_LAB_CPU_CLOCK_H

#include <ctime>

namespace kinex::lab {

// CPU time of the calling thread in seconds, since an arbitrary time: for differences.
inline double cpu_seconds() {
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace kinex::lab

#endif
