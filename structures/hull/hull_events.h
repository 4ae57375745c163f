// SPDX-License-Identifier: GPL-3.0-or-later
// HullEvents: the external events of a convex hull, in one form for all structures that maintain
// it.
//
// An instant changes the cycle of hull vertices from what it was just before to what it is just
// after. The difference is reported in this order:
//   1. a "leave" for each point that is no longer a vertex, by id
//   2. an "enter" for each new vertex, by id
//   3. one "turn", if the points that stayed are in another cyclic order (several points must meet
//      for that, or all lie on one line): the first of them with another successor, its old and its
//      new one
// So methods that have nothing else in common report the same events, in the same order, at the
// same instants.
//
// Replay. A "leave" takes its point out of the cycle. An "enter" names the point and the two
// neighbours between which it comes, counter-clockwise. (In a cycle of one vertex that vertex is
// both neighbours; in an empty cycle only the point is named.) Each event applies to the cycle left
// by the one before. A "turn" carries the whole cycle before and after (Event::gone, Event::came).
// So does the "settled" that corrects a cycle which passes a point twice, in an inexact arithmetic.
//
// Cost: O(h log h) for h vertices per instant at which the hull may have changed, and O(h) for each
// vertex that comes or goes; where one vertex has come or gone between two neighbours, O(1).
#ifndef KINEX_STRUCTURES_HULL_HULL_EVENTS_H
#define KINEX_STRUCTURES_HULL_HULL_EVENTS_H

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/engine/kernel.h"
#include "core/engine/structure.h"
#include "structures/hull/hull_ring.h"

namespace kinex {

class HullEvents {
 public:
  // The structure's first event kinds are these three, in this order.
  enum Kind : std::uint8_t { kLeave, kEnter, kTurn };
  static constexpr std::uint8_t kKinds = 3;
  // "leave", "enter", "turn" and `own`, and the common kinds.
  static std::vector<std::string_view> kinds(const std::vector<std::string_view>& own);

  HullEvents(Kernel& kernel, StructureId id) : kernel_(&kernel), id_(id) {}

  // Sets the hull just before the next instant; nothing is reported. Cycles start at their smallest
  // id.
  void begin(std::vector<ObjectId> cycle) { set(std::move(cycle)); }
  // The hull just after an instant at which it may have changed: reports the difference.
  void settle(std::vector<ObjectId> cycle);
  // As settle(), where the only change is that `point` came between `from` and `to`, or left from
  // between them. Returns false, with nothing done, if the cycle of before contradicts that.
  bool entered(ObjectId point, ObjectId from, ObjectId to);
  bool left(ObjectId point, ObjectId from, ObjectId to);
  // As reported so far. O(h).
  std::vector<ObjectId> cycle() const { return crossed_.empty() ? ring_.cycle() : crossed_; }
  const HullRing& ring() const { return ring_; }
  std::size_t bytes() const;

 private:
  void set(std::vector<ObjectId> cycle);
  void report_enter(ObjectId point, std::vector<ObjectId>& told, const std::vector<ObjectId>& cycle);

  Kernel* kernel_;
  StructureId id_;
  HullRing ring_;
  std::vector<ObjectId> crossed_;  // a cycle that passes a point twice; else empty
};

}  // namespace kinex

#endif
