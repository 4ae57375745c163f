// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/octant_woods.h"

#include <algorithm>
#include <span>

namespace kinex {
namespace {

using WoodOrders = std::array<OctantWoods::Order, SchnyderWood::kColours>;

constexpr WoodOrders kWoodOrders[OctantWoods::kWoods] = {
    {{{kAlongY, true}, {kAlongX, false}, {kAlongDifference, true}}},
    {{{kAlongX, false}, {kAlongY, false}, {kAlongSum, true}}},
};

}  // namespace

const WoodOrders& OctantWoods::orders(std::size_t wood) { return kWoodOrders[wood]; }

OctantWoods::OctantWoods(std::size_t objects, const Before& before, const Changed& changed)
    : objects_(objects) {
  for (std::size_t wood = 0; wood < kWoods; ++wood) {
    const WoodOrders& by = kWoodOrders[wood];
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

void OctantWoods::make(std::size_t wood, const Lists& lists) {
  std::array<std::vector<ObjectId>, SchnyderWood::kColours> points;
  std::array<std::span<const ObjectId>, SchnyderWood::kColours> spans;
  for (std::size_t order = 0; order < points.size(); ++order) {
    const Order& by = kWoodOrders[wood][order];
    points[order] = lists[by.axis];
    if (by.reversed) std::reverse(points[order].begin(), points[order].end());
    spans[order] = points[order];
  }
  woods_[wood].make(spans);
}

}  // namespace kinex
