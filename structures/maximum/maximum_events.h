// SPDX-License-Identifier: GPL-3.0-or-later
// MaximumEvents: the external events of a maximum, in one form for all structures that maintain it.
//
// An instant changes the maximum from its value just before to its value just after. If the two
// differ, this is one external event with the old maximum and the new one as its ids. Where several
// objects meet at one instant a structure may pass through some that all have the largest key at
// it: its own events are then internal, and the change is reported once, as a "replace", when the
// instant is settled. Where a single failure is all that happens, and the structure's own event
// states just this change, that event is the external one. So methods that have nothing else in
// common report the same changes at the same instants. Objects that come or go cause no external
// event.
//
// Cost: O(1) per failure.
#ifndef KINEX_STRUCTURES_MAXIMUM_MAXIMUM_EVENTS_H
#define KINEX_STRUCTURES_MAXIMUM_MAXIMUM_EVENTS_H

#include <cstddef>
#include <cstdint>

#include "core/engine/kernel.h"
#include "core/engine/structure.h"

namespace kinex {

class MaximumEvents {
 public:
  // `replace`: the kind of the structure's events that report a change of the maximum.
  MaximumEvents(Kernel& kernel, StructureId id, std::uint8_t replace)
      : kernel_(&kernel), id_(id), replace_(replace) {}

  // Sets the maximum just before the next instant (kNoObject: none); nothing is reported.
  void begin(ObjectId winner) { winner_ = winner; }
  // A failure was repaired, and `winner` is the maximum now: reports the event `kind` of {old,
  // fresh}, and the change of the maximum if the instant is over.
  void repaired(std::uint8_t kind, ObjectId old, ObjectId fresh, ObjectId winner);
  // The structure `watched` changed, and `winner` is the maximum now.
  void watched_changed(StructureId watched, ObjectId winner);
  // The instant is over, and `winner` is the maximum: reports the change, if any.
  void settle(ObjectId winner);
  // The maximum as last reported, also as an attribute.
  ObjectId winner() const { return winner_; }
  Attribute told() const {
    Attribute result{Attribute::Shape::kObject, {}};
    if (winner_ != kNoObject) result.ids.push_back(winner_);
    return result;
  }

 private:
  bool instant_is_over(StructureId structure) const;

  Kernel* kernel_;
  StructureId id_;
  std::uint8_t replace_;
  ObjectId winner_ = kNoObject;
};

}  // namespace kinex

#endif
