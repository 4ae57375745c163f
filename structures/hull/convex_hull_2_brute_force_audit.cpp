// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>

#include "structures/hull/convex_hull_2_brute_force.h"

namespace kinex {

// With left turns alone the cycle has as many lexicographically lowest vertices as it winds around.
bool ConvexHull2BruteForce::holds_at(const Snapshot& snapshot) const {
  const auto is_lower = [&](ObjectId a, ObjectId b) {
    for (const int axis : {0, 1}) {
      const Rational &at = snapshot.position(a, axis), &other = snapshot.position(b, axis);
      if (at != other) return at < other;
    }
    return false;
  };
  std::size_t lowest = 0;
  const std::size_t h = cycle_.size();
  for (std::size_t i = 0; i < h; ++i) {
    const ObjectId here = cycle_[i];
    if (is_lower(here, cycle_[(i + 1) % h]) && is_lower(here, cycle_[(i + h - 1) % h])) ++lowest;
  }
  return h < 3 || lowest == 1;
}

}  // namespace kinex
