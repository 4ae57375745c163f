// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/hull/hull_events.h"

#include <algorithm>
#include <utility>

#include "structures/parts/sort_unique.h"

namespace kinex {
namespace {

// The members of `cycle` that are in `kept` (sorted), from the smallest on.
std::vector<ObjectId> restricted(const std::vector<ObjectId>& cycle,
                                 const std::vector<ObjectId>& kept) {
  std::vector<ObjectId> result;
  for (const ObjectId id : cycle) {
    if (std::binary_search(kept.begin(), kept.end(), id)) result.push_back(id);
  }
  start_at_smallest(result);
  return result;
}

}  // namespace

std::vector<std::string_view> HullEvents::kinds(const std::vector<std::string_view>& own) {
  std::vector<std::string_view> all{"leave", "enter", "turn"};
  all.insert(all.end(), own.begin(), own.end());
  return common_event_kinds(std::move(all));
}

void HullEvents::set(std::vector<ObjectId> cycle) {
  crossed_.clear();
  if (ring_.assign(cycle)) return;
  ring_.assign({});
  crossed_ = std::move(cycle);
}

void HullEvents::settle(std::vector<ObjectId> cycle) {
  std::vector<ObjectId> told = this->cycle();
  if (cycle == told) return;
  std::vector<ObjectId> before = told, after = cycle;
  sort_unique(before);
  sort_unique(after);
  const std::vector<ObjectId> old = restricted(told, after), fresh = restricted(cycle, before);
  for (const ObjectId id : before) {
    if (std::binary_search(after.begin(), after.end(), id)) continue;
    told.erase(std::remove(told.begin(), told.end(), id), told.end());
    kernel_->report(id_, kLeave, {id}, true);
  }
  for (const ObjectId id : after) {
    if (!std::binary_search(before.begin(), before.end(), id)) report_enter(id, told, cycle);
  }
  start_at_smallest(told);
  if (told != cycle) {
    const std::size_t size = std::min(old.size(), fresh.size());
    std::size_t i = 0;
    while (i + 1 < size && old[i + 1] == fresh[i + 1]) ++i;
    if (i + 1 < size) {
      kernel_->report(id_, kTurn, {old[i], old[i + 1], fresh[i + 1]}, true, told, cycle);
    } else {
      kernel_->report_settled(id_, told, cycle);
    }
  }
  set(std::move(cycle));
}

// Inserts it behind the nearest predecessor on the new cycle that is present already.
void HullEvents::report_enter(ObjectId point, std::vector<ObjectId>& told,
                              const std::vector<ObjectId>& cycle) {
  if (std::find(told.begin(), told.end(), point) != told.end()) return;
  const std::size_t size = cycle.size();
  auto at = told.end();
  std::size_t i =
      static_cast<std::size_t>(std::find(cycle.begin(), cycle.end(), point) - cycle.begin());
  for (std::size_t steps = 1; steps < size && at == told.end(); ++steps) {
    i = i == 0 ? size - 1 : i - 1;
    at = std::find(told.begin(), told.end(), cycle[i]);
  }
  if (at == told.end()) {
    told = {point};
    return kernel_->report(id_, kEnter, {point}, true);
  }
  const ObjectId from = *at, to = at + 1 == told.end() ? told.front() : *(at + 1);
  told.insert(at + 1, point);
  kernel_->report(id_, kEnter, {point, from, to}, true);
}

bool HullEvents::entered(ObjectId point, ObjectId from, ObjectId to) {
  if (!ring_.enter(point, from, to)) return false;
  kernel_->report(id_, kEnter, {point, from, to}, true);
  return true;
}

bool HullEvents::left(ObjectId point, ObjectId from, ObjectId to) {
  if (!ring_.leave(point, from, to)) return false;
  kernel_->report(id_, kLeave, {point}, true);
  return true;
}

std::size_t HullEvents::bytes() const {
  return ring_.bytes() + crossed_.capacity() * sizeof(ObjectId);
}

}  // namespace kinex
