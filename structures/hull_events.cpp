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

// The place of `id` on the cycle; the number of vertices if it is not there or there twice.
std::size_t HullEvents::only_place(ObjectId id) const {
  const auto first = std::find(cycle_.begin(), cycle_.end(), id);
  if (first != cycle_.end() && std::find(first + 1, cycle_.end(), id) != cycle_.end()) {
    return cycle_.size();
  }
  return static_cast<std::size_t>(first - cycle_.begin());
}

void HullEvents::start_at_smallest() {
  std::rotate(cycle_.begin(), std::min_element(cycle_.begin(), cycle_.end()), cycle_.end());
}

bool HullEvents::entered(ObjectId point, ObjectId from, ObjectId to) {
  const std::size_t size = cycle_.size();
  const std::size_t i = only_place(from);
  if (size < 2 || i == size || cycle_[i + 1 == size ? 0 : i + 1] != to) return false;
  if (std::find(cycle_.begin(), cycle_.end(), point) != cycle_.end()) return false;
  cycle_.insert(cycle_.begin() + static_cast<std::ptrdiff_t>(i) + 1, point);
  if (point < cycle_.front()) start_at_smallest();
  kernel_->report(id_, kEnter, {point}, true);
  return true;
}

bool HullEvents::left(ObjectId point, ObjectId from, ObjectId to) {
  const std::size_t size = cycle_.size();
  const std::size_t i = only_place(point);
  if (size < 3 || i == size || cycle_[i == 0 ? size - 1 : i - 1] != from ||
      cycle_[i + 1 == size ? 0 : i + 1] != to) {
    return false;
  }
  cycle_.erase(cycle_.begin() + static_cast<std::ptrdiff_t>(i));
  if (i == 0) start_at_smallest();
  kernel_->report(id_, kLeave, {point}, true);
  return true;
}

std::size_t HullEvents::bytes() const {
  return (cycle_.capacity() + before_.capacity() + after_.capacity()) * sizeof(ObjectId);
}

}  // namespace kinex
