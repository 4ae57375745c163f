// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of `bench/run speed` that structures of points share.
#ifndef KINEX_EXPERIMENTS_FAMILIES_POINTS_SPEED_ROWS_H
#define KINEX_EXPERIMENTS_FAMILIES_POINTS_SPEED_ROWS_H

#include <vector>

#include "experiments/lab/speed_row.h"

namespace kinex::families {

// Random motion in `double` and `exact`.
lab::SpeedRow random_row(const char* structure, int degree, int n, std::uint64_t events = 0);
// Scenes full of new plans (walks): 308 objects, each with `plans` of them.
lab::SpeedRow plans_row(const char* structure, int plans, int scale);
// Adds small scenes, for the cost of a run apart from its events; then ties, simultaneous and
// degenerate events, with at most `most` objects, and always with 30.
void add_common_rows(std::vector<lab::SpeedRow>& rows, const char* structure, int scale, int most);

}  // namespace kinex::families

#endif
