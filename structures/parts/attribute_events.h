// SPDX-License-Identifier: GPL-3.0-or-later
// AttributeEvents: the external events of a small attribute, one for each instant that changes it.
//
// An instant changes the attribute from its value just before to its value just after. Where
// several certificates fail at one instant a structure may pass through values that belong to no
// time; its own events are then internal, and the change is reported once, when the instant is
// over. Where a single failure is all that happens, the structure's own event is the external one.
// So structures that have nothing else in common report the same changes at the same instants.
// Objects that come or go cause no external event.
//
//   in certificate_failed   repaired(..)          in instant_over, or instant_settled   over(..)
//   in watched_changed      watched_changed(..)   in build, insert, erase, rebuild      begin(..)
//
// The change is reported
//   of a kind that was given      as this event of {old, new}: one-object attributes only; a change
//                                 from or to no object is not reported
//   otherwise                     as the common event "settled", with the whole difference
//
// Cost: O(attribute) per failure.
#ifndef KINEX_STRUCTURES_PARTS_ATTRIBUTE_EVENTS_H
#define KINEX_STRUCTURES_PARTS_ATTRIBUTE_EVENTS_H

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <vector>

#include "core/engine/kernel.h"
#include "core/engine/structure.h"

namespace kinex {

// The ids of an attribute, or its one object (kNoObject: none). For parameters only: a view.
class AttributeIds {
 public:
  AttributeIds(ObjectId object) : object_(object) {}
  AttributeIds(std::span<const ObjectId> ids) : ids_(ids), many_(true) {}
  AttributeIds(const std::vector<ObjectId>& ids) : ids_(ids), many_(true) {}
  std::span<const ObjectId> ids() const {
    if (many_) return ids_;
    return {&object_, object_ == kNoObject ? 0u : 1u};
  }

 private:
  ObjectId object_ = kNoObject;
  std::span<const ObjectId> ids_;
  bool many_ = false;
};

class AttributeEvents {
 public:
  // A one-object attribute whose changes are events of the kind `replace`.
  AttributeEvents(Kernel& kernel, StructureId id, std::uint8_t replace)
      : kernel_(&kernel), id_(id), replace_(replace), told_{Attribute::Shape::kObject, {}} {}
  AttributeEvents(Kernel& kernel, StructureId id, Attribute::Shape shape, std::uint8_t width = 2)
      : kernel_(&kernel), id_(id), told_{shape, {}, width} {}

  // Sets the attribute just before the next instant; nothing is reported.
  void begin(AttributeIds now) { told_.ids.assign(now.ids().begin(), now.ids().end()); }
  // A failure was repaired, and the attribute is `now`: reports the event `kind` of `ids`, and the
  // change of the attribute if the instant is over. `reads`: a structure that is watched.
  void repaired(std::uint8_t kind, std::initializer_list<ObjectId> ids, AttributeIds now,
                std::optional<StructureId> reads = {});
  // The structure `watched` changed, and the attribute is `now`.
  void watched_changed(StructureId watched, AttributeIds now);
  // The instant is over, and the attribute is `now`: reports the change, if any.
  void over(AttributeIds now);
  // As last reported.
  const Attribute& told() const { return told_; }
  ObjectId object() const { return told_.ids.empty() ? kNoObject : told_.ids[0]; }
  std::size_t bytes() const { return told_.ids.capacity() * sizeof(ObjectId); }

 private:
  bool is_told(AttributeIds now) const;

  Kernel* kernel_;
  StructureId id_;
  std::optional<std::uint8_t> replace_;
  Attribute told_;
};

}  // namespace kinex

#endif
