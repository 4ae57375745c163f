// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/limb_cells.h"

#include <cstdlib>
#include <mutex>
#include <utility>

namespace kinex::lab {

namespace {

constexpr std::size_t kCellsInBlock = 8000;

// Lists of ended threads. Never destroyed: threads may end after main().
struct Left {
  std::mutex mutex;
  void* list = nullptr;
};
Left& left() {
  static Left* const all = new Left;
  return *all;
}

}  // namespace

bool LimbCells::refill() {
  {
    const std::lock_guard lock(left().mutex);
    free_ = static_cast<Slot*>(std::exchange(left().list, nullptr));
  }
  if (free_ != nullptr) return true;
  fresh_ = static_cast<Slot*>(std::malloc(kCellsInBlock * sizeof(Slot)));
  end_ = fresh_ == nullptr ? nullptr : fresh_ + kCellsInBlock;
  return fresh_ != nullptr;
}

LimbCells::~LimbCells() {
  while (fresh_ != end_) give_back(fresh_++);
  if (free_ == nullptr) return;
  Slot* last = free_;
  while (last->next != nullptr) last = last->next;
  const std::lock_guard lock(left().mutex);
  last->next = static_cast<Slot*>(left().list);
  left().list = free_;
  free_ = nullptr;
}

}  // namespace kinex::lab
