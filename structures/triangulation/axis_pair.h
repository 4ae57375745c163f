// SPDX-License-Identifier: GPL-3.0-or-later
// Two axes of space, on which points that are all in one plane are projected.
#ifndef KINEX_STRUCTURES_TRIANGULATION_AXIS_PAIR_H
#define KINEX_STRUCTURES_TRIANGULATION_AXIS_PAIR_H

#include <array>

namespace kinex {

struct AxisPair {  // two axes of space
  int first = 0, second = 1;  // ascending
};

// All pairs, in the order in which they are tried.
inline constexpr std::array<AxisPair, 3> kAxisPairs{AxisPair{0, 1}, {0, 2}, {1, 2}};

}  // namespace kinex

#endif
