// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/view/attribute_state.h"

#include <utility>

namespace kinex::view {

AttributeState::AttributeState(const Structure& structure)
    : structure_(structure), local_(dynamic_cast<const LocalPairs*>(&structure)) {}

const Attribute& AttributeState::begin() {
  attribute_ = structure_.attribute();
  pairs_.reset();
  if (local_ != nullptr) pairs_.emplace(attribute_);
  named_.clear();
  far_ = false;
  return attribute_;
}

void AttributeState::note_event(std::span<const ObjectId> ids, bool common) {
  if (local_ == nullptr) return;
  far_ = far_ || common;
  named_.insert(named_.end(), ids.begin(), ids.end());
}

AttributeChange AttributeState::read() {
  if (pairs_ && !far_) return pairs_->update(*local_, std::exchange(named_, {}));
  const Attribute before = value();
  return difference(before, begin());
}

}  // namespace kinex::view
