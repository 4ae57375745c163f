// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/shared_bound.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace kinex::verify {

namespace {

// True if two bounds are the same function of n, as far as a picture shows: where both have sizes, at two of
// them at least.
bool is_same_bound(const std::vector<lab::FitPoint>& a, const std::vector<lab::FitPoint>& b) {
  constexpr double kSame = 0.1;  // some two pixels of a picture of five decades
  std::size_t compared = 0;
  for (const auto* both : {&a, &b}) {
    const std::vector<lab::FitPoint>& other = both == &a ? b : a;
    for (const lab::FitPoint& point : *both) {
      const auto after = std::find_if(other.begin(), other.end(),
                                      [&](const lab::FitPoint& q) { return q.n >= point.n; });
      if (after == other.end() || (after == other.begin() && after->n > point.n)) continue;
      double there = std::log(after->count);
      if (after->n > point.n) {  // on the straight line, in logarithms
        const lab::FitPoint& before = *std::prev(after);
        const double along = std::log(point.n / before.n) / std::log(after->n / before.n);
        there = std::log(before.count) + along * std::log(after->count / before.count);
      }
      if (std::fabs(std::log(point.count) - there) > kSame) return false;
      ++compared;
    }
  }
  return compared >= 2;
}

}  // namespace

std::vector<SharedBound> shared_bounds(const std::vector<std::vector<lab::FitPoint>>& bounds) {
  std::vector<SharedBound> shared;
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    const std::vector<lab::FitPoint>& bound = bounds[i];
    if (bound.empty()) continue;
    const auto same = std::find_if(shared.begin(), shared.end(), [&](const SharedBound& one) {
      return is_same_bound(one.points, bound);
    });
    if (same == shared.end()) {
      shared.push_back({{i}, bound});
      continue;
    }
    same->families.push_back(i);
    for (const lab::FitPoint& point : bound) {
      const bool known = std::any_of(same->points.begin(), same->points.end(),
                                     [&](const lab::FitPoint& p) { return p.n == point.n; });
      if (!known) same->points.push_back(point);
    }
    std::sort(same->points.begin(), same->points.end(),
              [](const lab::FitPoint& a, const lab::FitPoint& b) { return a.n < b.n; });
  }
  return shared;
}

}  // namespace kinex::verify
