// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/meeting_events.h"

#include <span>
#include <utility>

namespace kinex {

void MeetingEvents::repaired(ObjectId a, ObjectId b, MeetingEventKind inside) {
  if (kernel_->instant_is_over(id_) && tell()) return;
  report_inside(inside, a, b);
  if (any()) kernel_->settle_later(id_);
}

void MeetingEvents::tied(ObjectId a, ObjectId b) {
  report_inside(kMeetingTie, a, b);
  if (any()) kernel_->settle_later(id_);
}

void MeetingEvents::report_inside(MeetingEventKind kind, ObjectId a, ObjectId b) {
  if (a == b) {
    kernel_->report(id_, kind, {a}, false);
  } else {
    kernel_->report(id_, kind, {a, b}, false);
  }
}

// False, with nothing reported, if nothing has changed.
bool MeetingEvents::tell() {
  const AttributeDifference change = changes_.take();
  for (std::size_t i = 0; i + 1 < change.gone.size(); i += 2) {
    const std::span<const ObjectId> pair(&change.gone[i], 2);
    kernel_->report(id_, kPart, {pair[0], pair[1]}, true, pair, {});
  }
  for (std::size_t i = 0; i + 1 < change.came.size(); i += 2) {
    const std::span<const ObjectId> pair(&change.came[i], 2);
    kernel_->report(id_, kMeet, {pair[0], pair[1]}, true, {}, pair);
  }
  return !change.gone.empty() || !change.came.empty();
}

}  // namespace kinex
