// SPDX-License-Identifier: GPL-3.0-or-later
// Ties: certificates of one part that have become identically zero, by their tags, until somebody
// has put the level items in the order of the owner's rule.
//
// A certificate that is identically zero never fails, so a part notes it where it is made, and where
// a new motion makes it so.
#ifndef KINEX_STRUCTURES_PARTS_TIES_H
#define KINEX_STRUCTURES_PARTS_TIES_H

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/motion/scene.h"
#include "structures/parts/slots.h"

namespace kinex {

class Ties {
 public:
  // Slots::set, and its tie is noted.
  void set(Slots& slots, CertificateId& slot, const Query& query, std::uint32_t tag) {
    if (slots.set(slot, query, tag) == Outlook::kIdenticallyZero) tags_.push_back(tag);
  }
  // The ties that came with the new motions of these objects. O(1) per certificate of theirs.
  void note_of(const Slots& slots, std::span<const ObjectId> objects) {
    for (const ObjectId object : objects) {
      for (const CertificateId c : slots.kernel().certificates_of(object)) {
        if (slots.is_tie(c) && slots.owns(c)) tags_.push_back(slots.kernel().tag(c));
      }
    }
  }
  // Calls settle(tag), the latest first, until none is left: also for those noted meanwhile. A tag
  // may come twice, or its certificate may have changed since: `settle` looks.
  template <class Settle>
  void settle(const Settle& settle) {
    while (!tags_.empty()) {
      const std::uint32_t tag = tags_.back();
      tags_.pop_back();
      settle(tag);
    }
  }
  bool empty() const { return tags_.empty(); }
  void clear() { tags_.clear(); }
  std::size_t bytes() const { return tags_.capacity() * sizeof(std::uint32_t); }

 private:
  std::vector<std::uint32_t> tags_;
};

}  // namespace kinex

#endif
