// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/maximum_of_list.h"

namespace kinex {

std::vector<std::string_view> MaximumOfList::event_kinds() const {
  return common_event_kinds({"replace"});
}

void MaximumOfList::build(std::span<const ObjectId>) { winner_ = list_->extreme(extremum_); }

// Objects that came or went are no events of motion: what is new with them is not reported.
void MaximumOfList::look(bool report) {
  const ObjectId old = winner_;
  winner_ = list_->extreme(extremum_);
  if (!report || old == winner_ || old == kNoObject || winner_ == kNoObject) return;
  kernel_->report(id_, kReplace, {old, winner_}, true);
}

Attribute MaximumOfList::attribute() const {
  Attribute result{Attribute::Shape::kObject, {}};
  if (winner_ != kNoObject) result.ids.push_back(winner_);
  return result;
}

std::vector<BoundCheck> MaximumOfList::bounds(const BoundContext& context) const {
  return {at_most(std::string(name()) + ".certificates", "it reads the list's", Integer(0),
                  Integer(static_cast<std::int64_t>(context.ledger->max_live)))};
}

}  // namespace kinex
