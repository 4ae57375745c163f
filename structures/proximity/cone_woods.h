// SPDX-License-Identifier: GPL-3.0-or-later
// ConeWoods: of every point, which point comes next in each of some cones around it: Schnyder woods
// on the orders along some axes (cone_frame.h, turned_order.h).
//
// A cone is a number: a wood has three, in the order of its colours.
#ifndef KINEX_STRUCTURES_PROXIMITY_CONE_WOODS_H
#define KINEX_STRUCTURES_PROXIMITY_CONE_WOODS_H

#include <cstddef>
#include <functional>
#include <vector>

#include "structures/proximity/cone_frame.h"
#include "structures/proximity/schnyder_wood.h"

namespace kinex {

class ConeWoods {
 public:
  // a comes before b along the axis, right after now.
  using Before = std::function<bool(std::size_t axis, ObjectId a, ObjectId b)>;
  // next(cone, p) has changed; it was `old` (kNoObject: no point).
  using Changed = std::function<void(std::size_t cone, ObjectId p, ObjectId old)>;
  // The points along each axis.
  using Lists = std::vector<std::vector<ObjectId>>;

  // `frame` outlives it.
  ConeWoods(const ConeFrame& frame, std::size_t objects, const Before& before,
            const Changed& changed);

  const ConeFrame& frame() const { return *frame_; }
  std::size_t objects() const { return objects_; }
  ObjectId next(std::size_t cone, ObjectId p) const {
    return woods_[cone / SchnyderWood::kColours].next(cone % SchnyderWood::kColours, p);
  }
  // Prefetches what next() reads of the point. No effect on results.
  void prefetch(ObjectId p) const {
    for (const SchnyderWood& wood : woods_) wood.prefetch_next(p);
  }
  std::size_t size() const { return woods_.size(); }
  SchnyderWood& wood(std::size_t i) { return woods_[i]; }
  const SchnyderWood& wood(std::size_t i) const { return woods_[i]; }

  // One wood of these points, which needs the lists along its own axes, or all woods. O(n log n) for
  // each.
  void make(std::size_t wood, const Lists& lists);
  void make(const Lists& lists) {
    for (std::size_t wood = 0; wood < woods_.size(); ++wood) make(wood, lists);
  }

  void check(AuditReport& report) const {
    for (const SchnyderWood& wood : woods_) wood.check(report);
  }
  std::size_t bytes() const;

 private:
  const ConeFrame* frame_;
  std::size_t objects_;
  std::vector<SchnyderWood> woods_;
};

}  // namespace kinex

#endif
