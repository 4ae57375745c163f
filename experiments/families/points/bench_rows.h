// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of benchmarks that structures of points share, and those of no structure.
#ifndef KINEX_EXPERIMENTS_FAMILIES_POINTS_BENCH_ROWS_H
#define KINEX_EXPERIMENTS_FAMILIES_POINTS_BENCH_ROWS_H

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "experiments/lab/bench_row.h"

namespace kinex::families {

// Random motion in `double` and `exact`.
lab::BenchRow random_row(std::string_view structure, int degree, int n, std::uint64_t events = 0);
// Scenes full of new plans (walks): 308 objects, each with `plans` of them.
lab::BenchRow plans_row(std::string_view structure, int plans, int scale);
// Adds small scenes, for the cost of a run apart from its events; then ties, simultaneous and
// degenerate events, with at most `most` objects, and always with 30.
void add_common_rows(std::vector<lab::BenchRow>& rows, std::string_view structure, int scale,
                     int most);

// Random motion in the plane, for a benchmark other than `speed`.
lab::BenchRow plane_row(std::string_view benchmark, std::string_view structure, int degree, int n,
                        int rounds);
// `scheduling`: n objects of degree 1 to 3 in `exact` and `double`; in `sturm` as many as `slow` says
// by degree.
void add_scheduling_rows(std::vector<lab::BenchRow>& rows, std::string_view structure, int scale,
                         int n, const std::array<int, 3>& slow);
// `queue`: the first 30,000 events.
lab::BenchRow queue_row(std::string_view structure, int degree, int n, int scale);
// `fall_through`: scenes that doubles resolve, and then two that they do not.
void add_fall_through_rows(std::vector<lab::BenchRow>& rows, std::string_view structure, int scale);
// `requires`: few that move among many, zeros beyond the degree, weights that are not read.
void add_requires_rows(std::vector<lab::BenchRow>& rows, std::string_view structure, int scale);
// .. and these attributes of one scene: a row of the last one's family.
lab::BenchRow shared_row(const std::vector<std::string_view>& structures, int scale);

// Those of no structure: `loading`.
std::vector<lab::BenchRow> point_bench_rows(int scale);

}  // namespace kinex::families

#endif
