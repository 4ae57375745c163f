// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/limb_cells.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <mutex>
#include <utility>
#include <vector>

namespace kinex::lab {

namespace {

constexpr std::size_t kCellsInBlock = 8000;

// What threads share. Never destroyed: threads may end after main().
struct Shared {
  std::mutex mutex;
  void* list = nullptr;             // the cells of ended threads
  std::vector<const void*> blocks;  // where they begin
};
Shared& shared() {
  static Shared* const all = new Shared;
  return *all;
}

}  // namespace

bool LimbCells::refill() {
  const std::lock_guard lock(shared().mutex);
  free_ = static_cast<Slot*>(std::exchange(shared().list, nullptr));
  if (free_ != nullptr) return true;
  fresh_ = static_cast<Slot*>(std::malloc(kCellsInBlock * sizeof(Slot)));
  end_ = fresh_ == nullptr ? nullptr : fresh_ + kCellsInBlock;
  if (fresh_ == nullptr) return false;
  try {
    shared().blocks.push_back(fresh_);
  } catch (const std::bad_alloc&) {
    std::free(std::exchange(fresh_, nullptr));
    end_ = nullptr;
    return false;
  }
  return true;
}

bool LimbCells::is_cell(const void* memory) {
  const std::lock_guard lock(shared().mutex);
  const std::less<const void*> before;
  return std::any_of(shared().blocks.begin(), shared().blocks.end(), [&](const void* block) {
    return !before(memory, block) &&
           before(memory, static_cast<const Slot*>(block) + kCellsInBlock);
  });
}

LimbCells::~LimbCells() {
  while (fresh_ != end_) give_back(fresh_++);
  if (free_ == nullptr) return;
  Slot* last = free_;
  while (last->next != nullptr) last = last->next;
  const std::lock_guard lock(shared().mutex);
  last->next = static_cast<Slot*>(shared().list);
  shared().list = free_;
  free_ = nullptr;
}

}  // namespace kinex::lab
