// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/tree_engine.h"

#include <algorithm>

#include "structures/proximity/tree_by_clusters.h"
#include "structures/proximity/tree_by_cycles.h"
#include "structures/proximity/tree_by_forests.h"
#include "structures/proximity/tree_by_list.h"
#include "structures/proximity/tree_by_short_cycles.h"

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

void TreeEngine::count_in(Item item) {
  state_[item] = State::kInside;
  ++inside_;
  events_->came(ids(item));
}

void TreeEngine::count_out(Item item) {
  state_[item] = State::kOutside;
  --inside_;
  events_->gone(ids(item));
}

void TreeEngine::put_in(Item item) {
  const auto [u, v] = edges_->ends(item);
  count_in(item);
  forest_.link(item, u, v);
}

void TreeEngine::take_out(Item item) {
  const auto [u, v] = edges_->ends(item);
  count_out(item);
  forest_.cut(item, u, v);
}

// No edge is left; nothing is reported.
void TreeEngine::clear() {
  forest_.clear();
  state_.clear();
  size_ = inside_ = 0;
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

std::vector<Item> TreeEngine::tree() const {
  std::vector<Item> result;
  for (Item item = 0; item < state_.size(); ++item) {
    if (in_tree(item)) result.push_back(item);
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

bool TreeEngine::may_go_on(std::uint64_t steps) {
  const std::uint64_t edges = size();
  if (kernel_->is_exact() || steps < 1000 + edges * edges) return true;
  kernel_->corrupt(id_, "no end of swaps while points come or go");
  return false;
}

std::unique_ptr<TreeEngine> make_tree_engine(const TreeMethod& method, Kernel& kernel, StructureId id,
                                             const TreeEdges& edges, TreeEvents& events,
                                             std::size_t vertices) {
  switch (method.proof) {
    case TreeProof::kList:
      return std::make_unique<TreeByList>(kernel, id, edges, events, vertices);
    case TreeProof::kCycles:
      return std::make_unique<TreeByCycles>(kernel, id, edges, events, vertices);
    case TreeProof::kShortCycles:
      return std::make_unique<TreeByShortCycles>(kernel, id, dynamic_cast<const AdjacentEdges&>(edges),
                                                 events, vertices);
    case TreeProof::kClusters:
      return std::make_unique<TreeByClusters>(kernel, id, edges, events, vertices, method.cluster);
    default:
      return std::make_unique<TreeByForests>(kernel, id, edges, events, vertices, method.items);
  }
}

}  // namespace kinex
