// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/tree_events.h"

#include <array>
#include <utility>

namespace kinex {

bool TreeEvents::instant_is_over(StructureId structure) const {
  return !kernel_->instant_is_shared(structure) && !kernel_->failure_is_due();
}

void TreeEvents::repaired(const Edge& before, const Edge& after) {
  const bool over_now = instant_is_over(id_) && instant_is_over(reads_);
  if (over_now && tell()) return;
  kernel_->report(id_, inside_, {before[0], before[1], after[0], after[1]}, false);
  if (any()) kernel_->settle_later(id_);
}

// False, with nothing reported, if nothing has changed.
bool TreeEvents::tell() {
  const AttributeDifference change = changes_.net();
  changes_.clear();
  if (change.gone.size() != change.came.size()) {
    kernel_->report_settled(id_, change.gone, change.came);
    return true;
  }
  for (std::size_t i = 0; i + 1 < change.gone.size(); i += 2) {
    const std::array<ObjectId, 2> gone{change.gone[i], change.gone[i + 1]};
    const std::array<ObjectId, 2> came{change.came[i], change.came[i + 1]};
    kernel_->report(id_, swap_, {gone[0], gone[1], came[0], came[1]}, true, gone, came);
  }
  return !change.gone.empty();
}

}  // namespace kinex
