// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of `bench/run speed` that structures of points share.
#ifndef KINEX_EXPERIMENTS_FAMILIES_POINTS_SPEED_ROWS_H
#define KINEX_EXPERIMENTS_FAMILIES_POINTS_SPEED_ROWS_H

#include <vector>

#include "experiments/lab/speed_row.h"

namespace kinex {

// Random motion in `double` and `exact`.
SpeedRow random_row(const char* structure, int degree, int n, std::uint64_t events = 0);
// Small scenes: the cost of a run apart from its events. Then ties, simultaneous and degenerate
// events, with at most `most` objects (and 30, whatever it is).
void add_common_rows(std::vector<SpeedRow>& rows, const char* structure, int scale, int most);

}  // namespace kinex

#endif
