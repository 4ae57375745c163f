// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/maximum/maximum_of_list.h"

namespace kinex {

std::vector<std::string_view> MaximumOfList::event_kinds() const {
  return common_event_kinds({"replace"});
}

void MaximumOfList::build(std::span<const ObjectId>) { events_.begin(extreme()); }

// The changes of a rebuild of the list are reported; insertions and erasures were handled already.
void MaximumOfList::watched_changed(const Event* event) {
  if (event == nullptr) return events_.over(extreme());
  events_.watched_changed(event->structure, extreme());
}

Attribute MaximumOfList::attribute() const {
  Attribute result{Attribute::Shape::kObject, {}};
  if (winner() != kNoObject) result.ids.push_back(winner());
  return result;
}

std::vector<BoundCheck> MaximumOfList::bounds(const BoundContext& context) const {
  return {at_most(std::string(name()) + ".certificates", "it reads the list's", Integer(0),
                  Integer(static_cast<std::int64_t>(context.ledger->max_live)))};
}

}  // namespace kinex
