// SPDX-License-Identifier: GPL-3.0-or-later
// How long an experiment took, also when it was resumed.
#ifndef KINEX_EXPERIMENTS_LAB_TIME_TAKEN_H
#define KINEX_EXPERIMENTS_LAB_TIME_TAKEN_H

#include <string>

namespace kinex::lab {

struct TimeTaken {
  double now = 0;     // seconds by the clock, of this command
  // Of what earlier commands had finished: the sum over its parts, seconds by the clock. Parts that ran
  // side by side count each for itself.
  double before = 0;
};

// "42 s", "5 min", "2.3 h".
std::string duration_text(double seconds);
// "5 min"; "5 min, 4 min of them by earlier commands".
std::string duration_text(const TimeTaken& taken);

}  // namespace kinex::lab

#endif
