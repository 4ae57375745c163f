// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/cone_woods.h"

#include <algorithm>
#include <array>
#include <span>

namespace kinex {

ConeWoods::ConeWoods(const ConeFrame& frame, std::size_t objects, const Before& before,
                     const Changed& changed)
    : frame_(&frame), objects_(objects) {
  for (std::size_t wood = 0; wood < frame.woods.size(); ++wood) {
    const auto& by = frame.woods[wood];
    woods_.emplace_back(
        objects,
        [before, &by](std::size_t order, ObjectId a, ObjectId b) {
          return by[order].reversed ? before(by[order].axis, b, a) : before(by[order].axis, a, b);
        },
        [changed, wood](std::size_t colour, ObjectId p, ObjectId old) {
          changed(wood * SchnyderWood::kColours + colour, p, old);
        });
  }
}

void ConeWoods::make(std::size_t wood, const Lists& lists) {
  std::array<std::vector<ObjectId>, SchnyderWood::kColours> points;
  std::array<std::span<const ObjectId>, SchnyderWood::kColours> spans;
  for (std::size_t order = 0; order < points.size(); ++order) {
    const ConeFrame::Order& by = frame_->woods[wood][order];
    points[order] = lists[by.axis];
    if (by.reversed) std::reverse(points[order].begin(), points[order].end());
    spans[order] = points[order];
  }
  woods_[wood].make(spans);
}

std::size_t ConeWoods::bytes() const {
  std::size_t total = 0;
  for (const SchnyderWood& wood : woods_) total += wood.bytes();
  return total;
}

}  // namespace kinex
