// SPDX-License-Identifier: GPL-3.0-or-later
// The cost of exact arithmetic: the time of `exact` over that of the same structure in doubles,
// from the rows of the benchmark `speed`.
#ifndef KINEX_EXPERIMENTS_BENCH_RATIOS_H
#define KINEX_EXPERIMENTS_BENCH_RATIOS_H

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace kinex::bench {

struct Ratio {
  std::string structure, scene;
  int degree = 0, n = 0;
  double value = 0;  // 0: doubles handle other events, or do not end
};

// The rows of `speed` among JSON lines that compare `exact` with `double`. Throws InputError, with
// `file` and the line, for text that is not JSON.
std::vector<Ratio> exact_over_double(std::string_view lines, const std::string& file);

// Markdown: a sentence with the ranges for random motion, scenes full of ties or of new plans, worst
// cases and collisions, and the worst row of each; then a table by structure. Empty without rows.
std::string ratios_text(const std::vector<Ratio>& ratios);

}  // namespace kinex::bench

#endif
