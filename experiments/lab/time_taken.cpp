// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/time_taken.h"

#include <fmt/format.h>

namespace kinex::lab {

std::string duration_text(double seconds) {
  if (seconds < 100) return fmt::format("{:.0f} s", seconds < 1 ? 1 : seconds);
  if (seconds < 6000) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

std::string duration_text(const TimeTaken& taken) {
  const std::string all = duration_text(taken.now + taken.before);
  if (taken.before <= 0) return all;
  return all + ", " + duration_text(taken.before) + " of them by earlier commands";
}

}  // namespace kinex::lab
