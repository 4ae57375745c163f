// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/hull_events.h"

#include <algorithm>
#include <utility>

namespace kinex {
namespace {

// The members of `cycle` that are in `kept` (sorted), from the smallest on.
std::vector<ObjectId> restricted(const std::vector<ObjectId>& cycle,
                                 const std::vector<ObjectId>& kept) {
  std::vector<ObjectId> result;
  for (const ObjectId id : cycle) {
    if (std::binary_search(kept.begin(), kept.end(), id)) result.push_back(id);
  }
  std::rotate(result.begin(), std::min_element(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace

std::vector<std::string_view> HullEvents::kinds(const std::vector<std::string_view>& own) {
  std::vector<std::string_view> all{"leave", "enter", "turn"};
  all.insert(all.end(), own.begin(), own.end());
  return common_event_kinds(std::move(all));
}

void HullEvents::settle(std::vector<ObjectId> cycle) {
  if (cycle == cycle_) return;
  before_ = cycle_;
  after_ = cycle;
  std::sort(before_.begin(), before_.end());
  std::sort(after_.begin(), after_.end());
  const auto report_missing = [this](const std::vector<ObjectId>& from,
                                     const std::vector<ObjectId>& in, Kind kind) {
    for (const ObjectId id : from) {
      if (!std::binary_search(in.begin(), in.end(), id)) kernel_->report(id_, kind, {id}, true);
    }
  };
  report_missing(before_, after_, kLeave);
  report_missing(after_, before_, kEnter);
  report_turn(cycle);
  cycle_ = std::move(cycle);
}

void HullEvents::report_turn(const std::vector<ObjectId>& cycle) {
  const std::vector<ObjectId> old = restricted(cycle_, after_);
  const std::vector<ObjectId> fresh = restricted(cycle, before_);
  for (std::size_t i = 0; i + 1 < std::min(old.size(), fresh.size()); ++i) {
    if (old[i + 1] == fresh[i + 1]) continue;
    kernel_->report(id_, kTurn, {old[i], old[i + 1], fresh[i + 1]}, true);
    return;
  }
}

std::size_t HullEvents::bytes() const {
  return (cycle_.capacity() + before_.capacity() + after_.capacity()) * sizeof(ObjectId);
}

}  // namespace kinex
