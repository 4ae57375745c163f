// SPDX-License-Identifier: GPL-3.0-or-later
// LimbCells: memory for numbers of one limb, which nearly all numbers of a scene are. For gmp_memory.cpp.
#ifndef KINEX_EXPERIMENTS_LAB_LIMB_CELLS_H
#define KINEX_EXPERIMENTS_LAB_LIMB_CELLS_H

#include <cstddef>
#include <new>

namespace kinex::lab {

// Cells of 8 bytes from large blocks, and a list of those that have been given back: no lock, no header, a
// quarter of what malloc takes. One per thread; a cell may be given back in another thread than it came from.
// Blocks are never returned to the system. The cells of a thread that ends are for the next that begins.
class LimbCells {
 public:
  static constexpr std::size_t kBytes = 8;

  LimbCells() = default;
  ~LimbCells();
  LimbCells(const LimbCells&) = delete;
  LimbCells& operator=(const LimbCells&) = delete;

  // nullptr: memory is exhausted.
  void* take() {
    if (free_ != nullptr) {
      Slot* const slot = free_;
      free_ = slot->next;
      return slot;
    }
    if (fresh_ == end_ && !refill()) return nullptr;
    return free_ != nullptr ? take() : static_cast<void*>(fresh_++);
  }
  void give_back(void* cell) { free_ = new (cell) Slot{free_}; }
  // Whether it is a cell, of whatever thread. O(blocks), with a lock.
  static bool is_cell(const void* memory);

 private:
  union Slot {
    Slot* next;
    unsigned char bytes[kBytes];
  };
  // Cells of ended threads, or a new block.
  bool refill();

  Slot* free_ = nullptr;
  Slot* fresh_ = nullptr;  // never used yet, up to end_
  Slot* end_ = nullptr;
};

}  // namespace kinex::lab

#endif
