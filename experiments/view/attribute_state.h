// SPDX-License-Identifier: GPL-3.0-or-later
// AttributeState: the attribute of a structure as it was read last. Where the structure offers that
// (LocalPairs), what its failures changed is read near the objects that its events name.
#ifndef KINEX_EXPERIMENTS_VIEW_ATTRIBUTE_STATE_H
#define KINEX_EXPERIMENTS_VIEW_ATTRIBUTE_STATE_H

#include <optional>
#include <span>
#include <vector>

#include "core/engine/structure.h"
#include "experiments/view/attribute_change.h"
#include "experiments/view/pairs_by_object.h"

namespace kinex::view {

class AttributeState {
 public:
  // The structure must outlive it.
  explicit AttributeState(const Structure& structure);

  // Reads all of it.
  const Attribute& begin();
  // An event that was reported since the attribute was read. `common`: as all structures have (CommonEvent).
  void note_event(std::span<const ObjectId> ids, bool common);
  // A call has ended since. `failure`: of certificate_failed.
  void note_call(bool failure) { far_ = far_ || !failure; }
  // Reads it again: what has changed; its event is not set.
  AttributeChange read();
  // As it was read last.
  Attribute value() const { return pairs_ ? pairs_->attribute() : attribute_; }

 private:
  const Structure& structure_;
  const LocalPairs* local_;  // the same structure, or nullptr
  Attribute attribute_;      // if there is no pairs_
  std::optional<PairsByObject> pairs_;
  std::vector<ObjectId> named_;  // by events since then
  bool far_ = false;             // more may have changed
};

}  // namespace kinex::view

#endif
