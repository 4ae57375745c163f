// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/gmp_memory.h"

#include <gmp.h>
#include <unistd.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <string_view>
#include <utility>

#ifndef __has_feature
#define __has_feature(x) 0
#endif
#if defined(__SANITIZE_ADDRESS__) || __has_feature(address_sanitizer)
// What GMP and MPFR keep for themselves in a function that Stopped leaves is lost, once a run.
extern "C" const char* __lsan_default_suppressions();
const char* __lsan_default_suppressions() {
  return "leak:__gmp_tmp_reentrant_alloc\nleak:mpfr_allocate_func\nleak:libmpfr\nleak:libgmp\n";
}
#endif

namespace kinex {
namespace {

// Block sizes in bytes at which the deadline is checked: at some blocks, at each.
constexpr std::size_t kLarge = 256, kHuge = 16384;
// Small blocks come from functions that may not throw. When memory is exhausted, this reserve is
// released for them.
constexpr std::size_t kSmall = 64;
constexpr std::size_t kReserve = 1 << 18;
std::atomic<void*> reserve{nullptr};

struct ThreadState {
  int guards = 0;
  Deadline* deadline = nullptr;
  void* freed = nullptr;  // see the header
};
thread_local ThreadState state;

[[noreturn]] void give_up() {
  constexpr std::string_view kMessage = "kinex: gave up: there is not enough memory\n";
  static_cast<void>(!::write(STDERR_FILENO, kMessage.data(), kMessage.size()));
  ::_exit(3);
}

[[noreturn]] void no_memory(bool small) {
  if (state.guards == 0 || small) give_up();
  state.freed = nullptr;
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
    state.freed = nullptr;
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
  void* block = obtain(size, [size] { return std::malloc(size); });
  std::free(std::exchange(state.freed, nullptr));
  return block;
}

void* reallocate(void* block, std::size_t, std::size_t size) {
  look_at_deadline(size);
  return obtain(size, [block, size] { return std::realloc(block, size); });
}

void release(void* block, std::size_t) {
  if (state.guards == 0) return std::free(block);
  std::free(std::exchange(state.freed, block));
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
  if (--state.guards == 0) std::free(std::exchange(state.freed, nullptr));
}

}  // namespace kinex
