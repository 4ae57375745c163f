// SPDX-License-Identifier: GPL-3.0-or-later
// IdIndex: which ids have been seen, for scenes of very many objects.
#ifndef KINEX_EXPERIMENTS_FORMATS_ID_INDEX_H
#define KINEX_EXPERIMENTS_FORMATS_ID_INDEX_H

#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string_view>
#include <vector>

namespace kinex::formats {

// A hash table without nodes: one access to memory an id, where std::unordered_map has four.
class IdIndex {
 public:
  // Room for `most` ids, no more may be added.
  explicit IdIndex(std::size_t most) : slots_(std::bit_ceil(2 * most + 1)) {}

  // Adds the id under the next number, from 0, and returns that; if it was there, its first number. The text
  // must outlive this.
  std::size_t add(std::string_view id) {
    const std::size_t hash = std::hash<std::string_view>()(id);
    const auto mark = static_cast<std::uint32_t>(hash >> 32);
    for (std::size_t at = hash;; ++at) {
      Slot& slot = slots_[at & (slots_.size() - 1)];
      if (slot.number == kNone) {
        slot = {mark, static_cast<std::uint32_t>(ids_.size())};
        ids_.push_back(id);
        return slot.number;
      }
      if (slot.mark == mark && ids_[slot.number] == id) return slot.number;
    }
  }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  struct Slot {
    std::uint32_t mark = 0;  // a part of the hash: other ids are not looked at
    std::uint32_t number = kNone;
  };
  std::vector<Slot> slots_;
  std::vector<std::string_view> ids_;
};

}  // namespace kinex::formats

#endif
