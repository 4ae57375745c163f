// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/gmp_memory.h"

#include <gmp.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <new>
#include <string_view>
#include <utility>

#include "experiments/lab/limb_cells.h"

#ifndef __has_feature
#define __has_feature(x) 0
#endif
#if defined(__SANITIZE_ADDRESS__) || __has_feature(address_sanitizer)
#define KINEX_ADDRESS_SANITIZER 1
// What GMP and MPFR keep for themselves in a function that Stopped leaves is lost, once a run.
extern "C" const char* __lsan_default_suppressions();
const char* __lsan_default_suppressions() {
  return "leak:__gmp_tmp_reentrant_alloc\nleak:mpfr_allocate_func\nleak:libmpfr\nleak:libgmp\n";
}
#endif

namespace kinex::lab {
namespace {

// Block sizes in bytes at which the deadline is checked: at some blocks, at each.
constexpr std::size_t kLarge = 256, kHuge = 16384;
// Small blocks come from functions that may not throw. When memory is exhausted, this reserve is
// released for them.
constexpr std::size_t kSmall = 64;
constexpr std::size_t kReserve = 1 << 18;
std::atomic<void*> reserve{nullptr};

// Blocks of a limb or less are cells, but for the address sanitizer, which is to see them.
#ifdef KINEX_ADDRESS_SANITIZER
constexpr std::size_t kCell = 0;
#else
constexpr std::size_t kCell = LimbCells::kBytes;
#endif

struct Block {
  void* memory = nullptr;
  std::size_t size = 0;
};

struct ThreadState {
  int guards = 0;
  Deadline* deadline = nullptr;
  Block freed;  // see the header
};
thread_local ThreadState state;
thread_local LimbCells limb_cells;
// An allocation has thrown. Functions note the size of the new block before they ask for it, so a number
// that was being written may say that its cell is larger than a cell.
std::atomic<bool> has_thrown{false};

void give_back(const Block& block) {
  if (block.memory == nullptr) return;
  if (block.size <= kCell || (has_thrown.load(std::memory_order_relaxed) && kCell > 0 &&
                              LimbCells::is_cell(block.memory))) {
    return limb_cells.give_back(block.memory);
  }
  std::free(block.memory);
}

// To be called before an allocation throws.
void leave_to_owner() {
  state.freed = {};
  has_thrown.store(true, std::memory_order_relaxed);
}

[[noreturn]] void give_up() {
  constexpr std::string_view kMessage = "kinex: gave up: there is not enough memory\n";
  static_cast<void>(!::write(STDERR_FILENO, kMessage.data(), kMessage.size()));
  ::_exit(3);
}

[[noreturn]] void no_memory(bool small) {
  if (state.guards == 0 || small) give_up();
  leave_to_owner();
  throw std::bad_alloc();
}

void look_at_deadline(std::size_t size) {
  if (size < kLarge || state.deadline == nullptr) return;
  try {
    if (size >= kHuge) {
      state.deadline->look();
    } else {
      state.deadline->poll();
    }
  } catch (...) {
    leave_to_owner();
    throw;
  }
}

// Calls `get`, which is malloc or realloc; a second time with the reserve given back.
template <class Get>
void* obtain(std::size_t size, const Get& get) {
  void* block = get();
  if (block == nullptr && size <= kSmall) {
    std::free(reserve.exchange(nullptr));
    block = get();
  }
  if (block == nullptr) no_memory(size <= kSmall);
  return block;
}

void* allocate(std::size_t size) {
  look_at_deadline(size);
  void* block = obtain(size, [size] { return size <= kCell ? limb_cells.take() : std::malloc(size); });
  give_back(std::exchange(state.freed, {}));
  return block;
}

void* reallocate(void* block, std::size_t before, std::size_t size) {
  look_at_deadline(size);
  if (before > kCell && size > kCell) {
    return obtain(size, [block, size] { return std::realloc(block, size); });
  }
  if (before <= kCell && size <= kCell) return block;
  void* moved = obtain(size, [size] { return size <= kCell ? limb_cells.take() : std::malloc(size); });
  std::memcpy(moved, block, std::min(before, size));
  give_back({block, before});
  return moved;
}

void release(void* block, std::size_t size) {
  if (state.guards == 0) return give_back({block, size});
  give_back(std::exchange(state.freed, {block, size}));
}

}  // namespace

void install_gmp_memory() {
  reserve = std::malloc(kReserve);
  mp_set_memory_functions(allocate, reallocate, release);
}

GmpGuard::GmpGuard(Deadline* deadline) : before_(std::exchange(state.deadline, deadline)) {
  ++state.guards;
}

GmpGuard::~GmpGuard() {
  state.deadline = before_;
  if (--state.guards == 0) give_back(std::exchange(state.freed, {}));
}

}  // namespace kinex::lab
