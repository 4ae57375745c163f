// SPDX-License-Identifier: GPL-3.0-or-later
// Lines that overtake each other one after the other.
#ifndef KINEX_EXPERIMENTS_FAMILIES_POINTS_POWER_LINES_H
#define KINEX_EXPERIMENTS_FAMILIES_POINTS_POWER_LINES_H

#include <string>

#include "core/motion/scene.h"

namespace kinex::families {

inline std::string function_name(int i) { return "f" + std::to_string(i); }

// Adds the lines f0, f1, .., fn-1 with f_j(t) = j t - (2n)^j, t >= 0: j overtakes i < j once, after
// all pairs of smaller numbers.
void add_power_lines(int n, Scene& scene);

}  // namespace kinex::families

#endif
