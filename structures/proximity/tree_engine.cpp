// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/tree_engine.h"

#include <algorithm>

#include "structures/proximity/tree_by_cycles.h"
#include "structures/proximity/tree_by_list.h"

namespace kinex {

void TreeEngine::enter(Item item) {
  if (state_.size() <= item) state_.resize(item + std::size_t{1}, State::kAbsent);
  state_[item] = State::kOutside;
  ++size_;
}

void TreeEngine::leave(Item item) {
  state_[item] = State::kAbsent;
  --size_;
}

void TreeEngine::put_in(Item item) {
  const auto [u, v] = edges_->ends(item);
  state_[item] = State::kInside;
  forest_.link(item, u, v);
  events_->came(ids(item));
}

void TreeEngine::take_out(Item item) {
  const auto [u, v] = edges_->ends(item);
  state_[item] = State::kOutside;
  forest_.cut(item, u, v);
  events_->gone(ids(item));
}

// No edge is left; nothing is reported.
void TreeEngine::clear() {
  forest_.clear();
  state_.clear();
  size_ = 0;
}

std::vector<ObjectId> TreeEngine::about(std::span<const Item> items) const {
  std::vector<ObjectId> result;
  for (const Item item : items) {
    for (const ObjectId id : ids(item)) {
      if (id == kNoObject || std::find(result.begin(), result.end(), id) != result.end()) continue;
      result.push_back(id);
    }
  }
  return result;
}

std::vector<Item> TreeEngine::present() const {
  std::vector<Item> result;
  for (Item item = 0; item < state_.size(); ++item) {
    if (has(item)) result.push_back(item);
  }
  return result;
}

std::unique_ptr<TreeEngine> make_tree_engine(TreeProof proof, Kernel& kernel, StructureId id,
                                             const TreeEdges& edges, TreeEvents& events,
                                             std::size_t vertices) {
  if (proof == TreeProof::kList) {
    return std::make_unique<TreeByList>(kernel, id, edges, events, vertices);
  }
  return std::make_unique<TreeByCycles>(kernel, id, edges, events, vertices);
}

}  // namespace kinex
