// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

#include "structures/proximity/point_grid.h"

namespace kinex {

bool PointGrid::has_small_cells(const Snapshot& snapshot) const {
  if (lines() == 0) return true;
  const Rational most = lines_.width() * Rational(Integer(5), Integer(4));
  for (const auto& [cell, points] : cells_) {
    for (std::size_t i = 0; i < axes(); ++i) {
      const auto at = [&](ObjectId id) -> const Rational& {
        return snapshot.position(id, static_cast<int>(i));
      };
      const auto [low, high] = std::minmax_element(
          points.begin(), points.end(), [&](ObjectId a, ObjectId b) { return at(a) < at(b); });
      if (most < at(*high) - at(*low)) return false;
    }
  }
  return true;
}

bool PointGrid::is_wide_enough(const Snapshot& snapshot) const {
  if (lines() == 0) return true;
  const auto radius = static_cast<int>(axes());
  return std::all_of(cells_.begin(), cells_.end(), [&](const auto& cell) {
    return std::all_of(cell.second.begin(), cell.second.end(), [&](ObjectId disc) {
      return Rational(2) * snapshot.position(disc, radius) < lines_.width();
    });
  });
}

void PointGrid::audit(const Snapshot& snapshot, AuditReport& report) const {
  for (const auto& [cell, points] : cells_) {
    for (const ObjectId point : points) {
      for (std::size_t i = 0; i < axes(); ++i) {
        report.check(
            lines_.is_in_column(i, cell[i], snapshot.position(point, static_cast<int>(i))),
            [point = point] { return "outside of its cell: point " + std::to_string(point); });
      }
    }
  }
}

}  // namespace kinex
