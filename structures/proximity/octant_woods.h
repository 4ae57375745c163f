// SPDX-License-Identifier: GPL-3.0-or-later
// OctantWoods: of every point, which point comes next in each of four octants around it: two
// Schnyder woods on the orders by x, y, x + y and x - y (octant_orders.h).
//
//   wood    orders f1, f2, f3      cone 1               cone 2                cone 3
//   first   -y, x, y - x           y < x < 0, by -y     0 < y < x, by x       x < 0 < y
//   second  x, y, -(x + y)         0 < -y < x, by x     0 < -x < y, by y      x, y < 0
//
// (Coordinates are relative to the point: "by -y" is first the one with the largest y.) The four
// octants are, up to a half turn, one of each two opposite ones. The quadrants, by y - x and by
// -(x + y), make the figures whole. Every closest pair pq is a pair of a point and the next one in
// an octant: in its octant q is strictly the first (octant_pairs.h has the lemma).
//
// A cone is a number: 0, 1, 2 in the first wood, 3, 4, 5 in the second.
#ifndef KINEX_STRUCTURES_PROXIMITY_OCTANT_WOODS_H
#define KINEX_STRUCTURES_PROXIMITY_OCTANT_WOODS_H

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "structures/proximity/octant_orders.h"
#include "structures/proximity/schnyder_wood.h"

namespace kinex {

class OctantWoods {
 public:
  static constexpr std::size_t kWoods = 2;
  static constexpr std::size_t kCones = kWoods * SchnyderWood::kColours;
  // a comes before b along the axis, right after now.
  using Before = std::function<bool(OctantAxis axis, ObjectId a, ObjectId b)>;
  // next(cone, p) is another one; it was `old` (kNoObject: no point).
  using Changed = std::function<void(std::size_t cone, ObjectId p, ObjectId old)>;
  // The points along each axis.
  using Lists = std::array<std::vector<ObjectId>, kOctantAxes>;
  // An order of a wood: an axis, from its first point on or from its last.
  struct Order {
    OctantAxis axis;
    bool reversed;
  };

  OctantWoods(std::size_t objects, const Before& before, const Changed& changed);

  // False for the two cones that are quadrants.
  static bool is_octant(std::size_t cone) { return cone % SchnyderWood::kColours != 2; }
  // The orders of a wood.
  static const std::array<Order, SchnyderWood::kColours>& orders(std::size_t wood);

  std::size_t objects() const { return objects_; }
  ObjectId next(std::size_t cone, ObjectId p) const {
    return woods_[cone / SchnyderWood::kColours].next(cone % SchnyderWood::kColours, p);
  }
  SchnyderWood& wood(std::size_t i) { return woods_[i]; }
  const SchnyderWood& wood(std::size_t i) const { return woods_[i]; }

  // One wood of these points, or both. O(n log n).
  void make(std::size_t wood, const Lists& lists);
  void make(const Lists& lists) {
    for (std::size_t wood = 0; wood < kWoods; ++wood) make(wood, lists);
  }

  void check(AuditReport& report) const {
    for (const SchnyderWood& wood : woods_) wood.check(report);
  }
  std::size_t bytes() const { return woods_[0].bytes() + woods_[1].bytes(); }

 private:
  std::size_t objects_;
  std::vector<SchnyderWood> woods_;
};

}  // namespace kinex

#endif
