// SPDX-License-Identifier: GPL-3.0-or-later
// MeetingEvents: the external events of a set of pairs that meet, in one form for all structures
// that maintain it.
//
// An instant changes the set from what it was just before to what it is just after: one event
// "part" for each pair that is gone, in ascending order, then one event "meet" for each that came.
// They are reported when nothing is left to be repaired at the instant. So structures that have
// nothing else in common report the same changes at the same instants.
#ifndef KINEX_STRUCTURES_PROXIMITY_MEETING_EVENTS_H
#define KINEX_STRUCTURES_PROXIMITY_MEETING_EVENTS_H

#include <cstddef>
#include <cstdint>

#include "core/engine/kernel.h"
#include "core/engine/structure.h"
#include "structures/parts/tuple_changes.h"

namespace kinex {

// The kinds of events of all structures of this form, by rank.
enum MeetingEventKind : std::uint8_t {
  kMeet,           // external: the two objects of a pair that came
  kPart,           // external: those of a pair that is gone
  kMeetingInside,  // internal: a failure was repaired that changes nothing, or nothing yet
  kMeetingTie,     // internal: two objects touch identically from now on
  kMeetingCell,    // internal, of disc_pairs_grid alone: an object has moved to the next cell
};

class MeetingEvents {
 public:
  MeetingEvents(Kernel& kernel, StructureId id) : kernel_(&kernel), id_(id) {}

  // The pair meets, or does so no longer, from now on.
  void changed(ObjectId a, ObjectId b, bool meets) {
    if (meets) {
      changes_.came({a, b});
    } else {
      changes_.gone({a, b});
    }
  }
  // Discards the changes that have not been reported.
  void begin() { changes_.clear(); }
  // A failure about these two objects (or one: a == b) was repaired. Reports at least one event, of
  // this kind if nothing changes.
  void repaired(ObjectId a, ObjectId b, MeetingEventKind inside = kMeetingInside);
  // Reports a tie that was put in order.
  void tied(ObjectId a, ObjectId b);
  // The instant is over: reports what has changed.
  void over() { tell(); }
  // The set before the changes that have not been reported; `now`: the present one.
  Attribute told(Attribute now) const { return changes_.undone(std::move(now)); }
  bool any() const { return changes_.size() > 0; }
  std::size_t bytes() const { return changes_.bytes(); }

 private:
  void report_inside(MeetingEventKind kind, ObjectId a, ObjectId b);
  bool tell();

  Kernel* kernel_;
  StructureId id_;
  EdgeChanges changes_;
};

}  // namespace kinex

#endif
