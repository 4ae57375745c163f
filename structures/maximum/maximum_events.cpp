// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/maximum/maximum_events.h"

namespace kinex {

// True if only one certificate of the structure failed at this instant, and none made since fails
// at it too. Certificates of one instant leave the queue by structure: none of another can precede.
bool MaximumEvents::instant_is_over(StructureId structure) const {
  if (kernel_->instant_is_shared(structure)) return false;
  return !kernel_->failure_is_due();
}

void MaximumEvents::repaired(std::uint8_t kind, ObjectId old, ObjectId fresh, ObjectId winner) {
  const bool over = instant_is_over(id_);
  const bool says_all = over && winner != winner_ && old == winner_ && fresh == winner;
  kernel_->report(id_, kind, {old, fresh}, says_all);
  if (says_all) return begin(winner);
  if (over) return settle(winner);
  kernel_->settle_later(id_);
}

void MaximumEvents::watched_changed(StructureId watched, ObjectId winner) {
  if (instant_is_over(watched)) return settle(winner);
  kernel_->settle_later(id_);
}

void MaximumEvents::settle(ObjectId winner) {
  const ObjectId old = winner_;
  winner_ = winner;
  if (old == winner || old == kNoObject || winner == kNoObject) return;
  kernel_->report(id_, replace_, {old, winner}, true);
}

}  // namespace kinex
