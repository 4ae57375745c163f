// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/hull/hull_events.h"

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
  if (result.empty()) return result;
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
  for (std::vector<ObjectId>* ids : {&before_, &after_}) {
    std::sort(ids->begin(), ids->end());
    ids->erase(std::unique(ids->begin(), ids->end()), ids->end());
  }
  const std::vector<ObjectId> old = restricted(cycle_, after_), fresh = restricted(cycle, before_);
  for (const ObjectId id : before_) {
    if (std::binary_search(after_.begin(), after_.end(), id)) continue;
    cycle_.erase(std::remove(cycle_.begin(), cycle_.end(), id), cycle_.end());
    kernel_->report(id_, kLeave, {id}, true);
  }
  for (const ObjectId id : after_) {
    if (!std::binary_search(before_.begin(), before_.end(), id)) report_enter(id, cycle);
  }
  start_at_smallest();
  if (cycle_ != cycle) {
    const std::size_t size = std::min(old.size(), fresh.size());
    std::size_t i = 0;
    while (i + 1 < size && old[i + 1] == fresh[i + 1]) ++i;
    if (i + 1 < size) {
      kernel_->report(id_, kTurn, {old[i], old[i + 1], fresh[i + 1]}, true, cycle_, cycle);
    } else {
      kernel_->report_settled(id_, cycle_, cycle);
    }
  }
  cycle_ = std::move(cycle);
}

// Inserts it behind the nearest predecessor on the new cycle that is present already.
void HullEvents::report_enter(ObjectId point, const std::vector<ObjectId>& cycle) {
  if (std::find(cycle_.begin(), cycle_.end(), point) != cycle_.end()) return;
  const std::size_t size = cycle.size();
  auto at = cycle_.end();
  std::size_t i =
      static_cast<std::size_t>(std::find(cycle.begin(), cycle.end(), point) - cycle.begin());
  for (std::size_t steps = 1; steps < size && at == cycle_.end(); ++steps) {
    i = i == 0 ? size - 1 : i - 1;
    at = std::find(cycle_.begin(), cycle_.end(), cycle[i]);
  }
  if (at == cycle_.end()) {
    cycle_ = {point};
    return kernel_->report(id_, kEnter, {point}, true);
  }
  const ObjectId from = *at, to = at + 1 == cycle_.end() ? cycle_.front() : *(at + 1);
  cycle_.insert(at + 1, point);
  kernel_->report(id_, kEnter, {point, from, to}, true);
}

// The place of `id` on the cycle; the number of vertices if it is absent or occurs twice.
std::size_t HullEvents::only_place(ObjectId id) const {
  const auto first = std::find(cycle_.begin(), cycle_.end(), id);
  if (first != cycle_.end() && std::find(first + 1, cycle_.end(), id) != cycle_.end()) {
    return cycle_.size();
  }
  return static_cast<std::size_t>(first - cycle_.begin());
}

void HullEvents::start_at_smallest() {
  if (cycle_.empty()) return;
  std::rotate(cycle_.begin(), std::min_element(cycle_.begin(), cycle_.end()), cycle_.end());
}

bool HullEvents::entered(ObjectId point, ObjectId from, ObjectId to) {
  const std::size_t size = cycle_.size();
  const std::size_t i = only_place(from);
  if (size < 2 || i == size || cycle_[i + 1 == size ? 0 : i + 1] != to) return false;
  if (std::find(cycle_.begin(), cycle_.end(), point) != cycle_.end()) return false;
  cycle_.insert(cycle_.begin() + static_cast<std::ptrdiff_t>(i) + 1, point);
  if (point < cycle_.front()) start_at_smallest();
  kernel_->report(id_, kEnter, {point, from, to}, true);
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
