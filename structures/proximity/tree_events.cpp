// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/tree_events.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace kinex {
namespace {

// The number of ids of an edge.
std::size_t width(const EdgeIds& edge) { return edge[1] == kNoObject ? 1 : 2; }

void append(std::vector<ObjectId>& ids, const EdgeIds& edge) {
  ids.insert(ids.end(), edge.begin(), edge.begin() + static_cast<std::ptrdiff_t>(width(edge)));
}

}  // namespace

void TreeEvents::count(const EdgeIds& edge, int change) {
  const auto place = changes_.try_emplace(edge, 0).first;
  place->second += change;
  if (place->second == 0) changes_.erase(place);
}

AttributeDifference TreeEvents::net() const {
  AttributeDifference result;
  for (const auto& [edge, times] : changes_) append(times > 0 ? result.came : result.gone, edge);
  return result;
}

Attribute TreeEvents::told(Attribute now) const {
  std::vector<EdgeIds> edges;
  const std::size_t w = now.width;
  for (std::size_t i = 0; i + w <= now.ids.size(); i += w) {
    const EdgeIds edge{now.ids[i], w == 1 ? kNoObject : now.ids[i + 1]};
    if (!changes_.contains(edge)) edges.push_back(edge);
  }
  for (const auto& [edge, times] : changes_) {
    if (times < 0) edges.push_back(edge);
  }
  std::sort(edges.begin(), edges.end());
  now.ids.clear();
  for (const EdgeIds& edge : edges) append(now.ids, edge);
  return now;
}

void TreeEvents::report(TreeEventKind kind, const EdgeIds& before, const EdgeIds& after,
                        bool external) {
  const std::span<const ObjectId> gone(before.data(), width(before));
  const std::span<const ObjectId> came(after.data(), width(after));
  const auto told = [external](std::span<const ObjectId> ids) {
    return external ? ids : std::span<const ObjectId>();
  };
  if (width(before) == 1) {
    kernel_->report(id_, kind, {before[0], after[0]}, external, told(gone), told(came));
  } else {
    kernel_->report(id_, kind, {before[0], before[1], after[0], after[1]}, external, told(gone),
                    told(came));
  }
}

void TreeEvents::repaired(const EdgeIds& before, const EdgeIds& after) {
  const bool over_now =
      kernel_->instant_is_over(id_) && (!reads_ || kernel_->instant_is_over(*reads_));
  if (over_now && tell()) return;
  report(kTreeInside, before, after, false);
  if (any()) kernel_->settle_later(id_);
}

// False, with nothing reported, if nothing has changed.
bool TreeEvents::tell() {
  if (changes_.empty()) return false;
  gone_.clear();
  came_.clear();
  for (const auto& [edge, times] : changes_) (times > 0 ? came_ : gone_).push_back(edge);
  if (gone_.size() != came_.size()) {
    const AttributeDifference change = net();
    changes_.clear();
    kernel_->report_settled(id_, change.gone, change.came);
    return true;
  }
  changes_.clear();
  for (std::size_t i = 0; i < gone_.size(); ++i) report(kTreeSwap, gone_[i], came_[i], true);
  return true;
}

}  // namespace kinex
