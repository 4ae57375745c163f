// SPDX-License-Identifier: GPL-3.0-or-later
// WorstCase: of many counts, each with a hard bound of its own, the one with the least slack.
#ifndef KINEX_STRUCTURES_RANGE_WORST_CASE_H
#define KINEX_STRUCTURES_RANGE_WORST_CASE_H

#include <cstdint>

namespace kinex {

struct WorstCase {
  std::uint64_t bound = 0, observed = 0;
  bool seen = false;

  void note(std::uint64_t count, std::uint64_t most) {
    // The one with the least slack; then the larger one.
    const auto slack = static_cast<std::int64_t>(most) - static_cast<std::int64_t>(count);
    const auto least = static_cast<std::int64_t>(bound) - static_cast<std::int64_t>(observed);
    if (seen && (slack > least || (slack == least && count <= observed))) return;
    seen = true;
    bound = most;
    observed = count;
  }
};

}  // namespace kinex

#endif
