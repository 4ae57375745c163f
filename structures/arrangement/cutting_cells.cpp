// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/arrangement/cutting_cells.h"

#include <algorithm>
#include <optional>

namespace kinex {

bool CuttingCells::collect(const Trapezoids2& trapezoids) {
  next_.clear();
  std::optional<Trapezoid> before;  // its wall is at the left side of the next one
  return trapezoids.walls().each_trapezoid(trapezoids.lines().slopes(),
                                           [&](const Trapezoid& one, bool goes_on) {
                                             if (before) next_.at(*before) = one;
                                             next_.emplace(one, one);
                                             before = goes_on ? std::optional(one) : std::nullopt;
                                           });
}

void CuttingCells::add_new() {
  for (const auto& [trapezoid, next] : next_) {
    if (places_.contains(trapezoid)) continue;
    if (free_.empty()) {
      free_.push_back(static_cast<Cell>(cells_.size()));
      cells_.emplace_back();
    }
    const Cell cell = free_.back();
    free_.pop_back();
    cells_[cell].trapezoid = trapezoid;
    places_.emplace(trapezoid, cell);
  }
  for (const auto& [trapezoid, next] : next_) {
    cells_[places_.at(trapezoid)].behind = next == trapezoid ? kNone : places_.at(next);
  }
}

bool CuttingCells::is_crossed(Cell cell, ObjectId line) const {
  const std::vector<ObjectId>& lines = cells_[cell].lines;
  return std::binary_search(lines.begin(), lines.end(), line);
}

void CuttingCells::add_line(Cell cell, ObjectId line) {
  std::vector<ObjectId>& lines = cells_[cell].lines;
  const auto place = std::lower_bound(lines.begin(), lines.end(), line);
  if (place == lines.end() || *place != line) lines.insert(place, line);
}

void CuttingCells::remove_line(Cell cell, ObjectId line) {
  std::vector<ObjectId>& lines = cells_[cell].lines;
  const auto place = std::lower_bound(lines.begin(), lines.end(), line);
  if (place != lines.end() && *place == line) lines.erase(place);
}

std::size_t CuttingCells::bytes() const {
  std::size_t result = cells_.capacity() * sizeof(Content) + free_.capacity() * sizeof(Cell) +
                       places_.size() * (sizeof(Trapezoid) + 64) +
                       next_.size() * (2 * sizeof(Trapezoid) + 48);
  for (const Content& cell : cells_) result += cell.lines.capacity() * sizeof(ObjectId);
  return result;
}

}  // namespace kinex
