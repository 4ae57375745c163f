// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/parts/attribute_events.h"

#include <algorithm>

namespace kinex {

bool AttributeEvents::is_told(AttributeIds now) const {
  return std::ranges::equal(told_.ids, now.ids());
}

void AttributeEvents::repaired(std::uint8_t kind, std::initializer_list<ObjectId> ids,
                               AttributeIds now, std::optional<StructureId> reads) {
  const bool over_now =
      kernel_->instant_is_over(id_) && (!reads || kernel_->instant_is_over(*reads));
  bool says_all = over_now && !is_told(now);
  if (replace_) {
    says_all = says_all && *ids.begin() == object() && now.ids().size() == 1 &&
               *(ids.end() - 1) == now.ids()[0];
    kernel_->report(id_, kind, ids, says_all);
  } else if (says_all) {
    const AttributeDifference change = difference_between(
        told_, {told_.shape, {now.ids().begin(), now.ids().end()}, told_.width});
    kernel_->report(id_, kind, ids, true, change.gone, change.came);
  } else {
    kernel_->report(id_, kind, ids, false);
  }
  if (says_all) return begin(now);
  if (over_now) return over(now);
  kernel_->settle_later(id_);
}

void AttributeEvents::watched_changed(StructureId watched, AttributeIds now) {
  if (kernel_->instant_is_over(watched)) return over(now);
  kernel_->settle_later(id_);
}

void AttributeEvents::over(AttributeIds now) {
  if (is_told(now)) return;
  const Attribute before = told_;
  begin(now);
  if (!replace_) {
    const AttributeDifference change = difference_between(before, told_);
    kernel_->report_settled(id_, change.gone, change.came);
  } else if (!before.ids.empty() && !told_.ids.empty()) {
    kernel_->report(id_, *replace_, {before.ids[0], told_.ids[0]}, true);
  }
}

}  // namespace kinex
