// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/hull/static_hull.h"

#include <algorithm>

#include "structures/hull/hull_ring.h"
#include "structures/parts/merge_sort.h"

namespace kinex {

std::vector<ObjectId> static_hull(const HullSigns& signs, std::span<const ObjectId> objects) {
  std::vector<ObjectId> sorted(objects.begin(), objects.end());
  merge_sort(sorted, [&](ObjectId a, ObjectId b) { return signs.slopes_hold(a, b); });
  std::vector<ObjectId> distinct;
  for (const ObjectId id : sorted) {
    if (!distinct.empty() && signs.equal(distinct.back(), id)) {
      distinct.back() = std::min(distinct.back(), id);
    } else {
      distinct.push_back(id);
    }
  }
  if (distinct.size() <= 1) return distinct;
  std::vector<ObjectId> cycle;
  const auto extend = [&](ObjectId id, std::size_t base) {
    while (cycle.size() >= base + 2 &&
           signs.turn(cycle[cycle.size() - 2], cycle.back(), id) != Sign::kPositive) {
      cycle.pop_back();
    }
    cycle.push_back(id);
  };
  for (const ObjectId id : distinct) extend(id, 0);
  const std::size_t lower = cycle.size() - 1;
  for (std::size_t i = distinct.size() - 1; i-- > 0;) extend(distinct[i], lower);
  cycle.pop_back();  // the first one again
  start_at_smallest(cycle);
  return cycle;
}

}  // namespace kinex
