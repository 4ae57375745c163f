// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/hull/static_hull.h"

#include <algorithm>

namespace kinex {
namespace {

// Merge sort: contradictory signs (inexact arithmetics) do no harm.
void sort_by_slope(const HullSigns& signs, std::vector<ObjectId>& ids) {
  std::vector<ObjectId> out(ids.size());
  for (std::size_t width = 1; width < ids.size(); width *= 2) {
    for (std::size_t low = 0; low < ids.size(); low += 2 * width) {
      const std::size_t middle = std::min(low + width, ids.size());
      const std::size_t high = std::min(low + 2 * width, ids.size());
      std::size_t i = low, j = middle;
      for (std::size_t k = low; k < high; ++k) {
        const bool first = j == high || (i < middle && signs.slopes_hold(ids[i], ids[j]));
        out[k] = first ? ids[i++] : ids[j++];
      }
    }
    ids.swap(out);
  }
}

}  // namespace

std::vector<ObjectId> static_hull(const HullSigns& signs, std::span<const ObjectId> objects) {
  std::vector<ObjectId> sorted(objects.begin(), objects.end());
  sort_by_slope(signs, sorted);
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
  std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
  return cycle;
}

}  // namespace kinex
