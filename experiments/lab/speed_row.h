// SPDX-License-Identifier: GPL-3.0-or-later
// SpeedRow: a scene whose whole run is timed in several arithmetics (`bench/run speed`).
#ifndef KINEX_EXPERIMENTS_LAB_SPEED_ROW_H
#define KINEX_EXPERIMENTS_LAB_SPEED_ROW_H

#include <cstdint>
#include <vector>

namespace kinex::lab {

struct SpeedRow {
  const char* structure;
  const char* workload;
  int degree;
  int n;
  std::vector<const char*> arithmetics;  // the first is the reference of the ratios
  std::uint64_t events = 0;              // the run stops after so many; 0: at the end of the scene
  int m = 0;
  int inverse_separation = 0;  // of two bodies: 1 / separation; 0: the workload's default
  int turns = -1;
};

// size / scale, but at least 8.
inline int scaled_size(int size, int scale) { return size / scale < 8 ? 8 : size / scale; }

}  // namespace kinex::lab

#endif
