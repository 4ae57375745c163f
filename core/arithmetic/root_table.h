// SPDX-License-Identifier: GPL-3.0-or-later
// RootTable: the exact numbers of those failure times that needed one. Equal instants share an
// entry.
#ifndef KINEX_CORE_ARITHMETIC_ROOT_TABLE_H
#define KINEX_CORE_ARITHMETIC_ROOT_TABLE_H

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "core/numbers/real_root.h"

namespace kinex {

// Handles are small integers; 0 is none. Entries are reference counted, freed ones are reused, those of
// rational numbers with their memory. Every function is O(1) (add: amortised).
class RootTable {
 public:
  // A new entry with one reference.
  std::uint32_t add(RealRoot root) {
    const std::uint32_t handle = take();
    Slot& slot = slots_[handle - 1];
    if (slot.root == nullptr) {
      slot.root = std::make_unique<RealRoot>(std::move(root));
    } else {
      *slot.root = std::move(root);
    }
    return handle;
  }
  std::uint32_t add(const Rational& value) {
    const std::uint32_t handle = take();
    Slot& slot = slots_[handle - 1];
    if (slot.root == nullptr) {
      slot.root = std::make_unique<RealRoot>(value);
    } else {
      slot.root->set(value);
    }
    return handle;
  }
  // One more reference; returns the handle.
  std::uint32_t share(std::uint32_t handle) {
    if (handle != 0) ++slots_[handle - 1].references;
    return handle;
  }
  // One reference less; the last one frees the entry.
  void release(std::uint32_t handle) {
    if (handle == 0) return;
    Slot& slot = slots_[handle - 1];
    if (--slot.references == 0) {
      if (!slot.root->is_rational()) slot.root.reset();
      free_.push_back(handle);
      --live_;
    }
  }
  // Requires a live handle. The reference stays valid until the entry is freed.
  RealRoot& operator[](std::uint32_t handle) { return *slots_[handle - 1].root; }
  const RealRoot& operator[](std::uint32_t handle) const { return *slots_[handle - 1].root; }
  std::size_t live() const { return live_; }
  std::size_t bytes() const {
    return slots_.capacity() * sizeof(Slot) + free_.capacity() * sizeof(std::uint32_t) +
           slots_.size() * (sizeof(RealRoot) + 128);
  }

 private:
  std::uint32_t take() {
    if (free_.empty()) {
      slots_.push_back({});
      free_.push_back(static_cast<std::uint32_t>(slots_.size()));
    }
    const std::uint32_t handle = free_.back();
    free_.pop_back();
    slots_[handle - 1].references = 1;
    ++live_;
    return handle;
  }

  struct Slot {
    std::unique_ptr<RealRoot> root;
    std::uint32_t references = 0;
  };
  std::vector<Slot> slots_;
  std::vector<std::uint32_t> free_;
  std::size_t live_ = 0;
};

}  // namespace kinex

#endif
