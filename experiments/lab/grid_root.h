// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes that shrink with the number of objects by a root, on the grid of random coordinates.
#ifndef KINEX_EXPERIMENTS_LAB_GRID_ROOT_H
#define KINEX_EXPERIMENTS_LAB_GRID_ROOT_H

#include <cstdint>

#include "experiments/lab/workload_parts.h"

namespace kinex::lab {

// n^(-power/root) in units of the grid, rounded down: integers alone decide. 1 <= root <= 3, n^power < 2^63.
inline std::int64_t grid_over_root(std::int64_t n, int root, int power = 1) {
  std::int64_t most = 1, divisor = 1;  // the largest u with u^root <= 2^(20 root) / n^power
  for (int k = 0; k < root; ++k) most *= kGridUnits;
  for (int k = 0; k < power; ++k) divisor *= n;
  most /= divisor;
  std::int64_t low = 0, above = kGridUnits + 1;
  while (above - low > 1) {
    const std::int64_t middle = low + (above - low) / 2;
    std::int64_t raised = 1;
    for (int k = 0; k < root; ++k) raised *= middle;
    (raised <= most ? low : above) = middle;
  }
  return low;
}

}  // namespace kinex::lab

#endif
