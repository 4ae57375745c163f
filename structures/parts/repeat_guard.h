// SPDX-License-Identifier: GPL-3.0-or-later
// RepeatGuard: detects that an inexact arithmetic cycles.
//
// A polynomial of degree D becomes negative at most about D / 2 times. If a certificate for the
// same query fails far more often under the same motions, its sign contradicts itself.
#ifndef KINEX_STRUCTURES_PARTS_REPEAT_GUARD_H
#define KINEX_STRUCTURES_PARTS_REPEAT_GUARD_H

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/engine/certificate.h"

namespace kinex {

class RepeatGuard {
 public:
  // A certificate for `query` has failed. True if that happens too often.
  bool failed(const Query& query) {
    std::size_t hash = query.predicate;
    for (std::size_t i = 0; i < query.arity; ++i) hash = 31 * hash + query.ids[i];
    Entry& entry = entries_[hash % entries_.size()];
    if (entry.query != query) entry = {query, 0};
    return ++entry.times > kMostTimes;
  }
  // Motions have changed.
  void clear() { entries_.fill({}); }

 private:
  static constexpr std::uint32_t kMostTimes = 32;
  struct Entry {
    Query query;
    std::uint32_t times = 0;
  };
  std::array<Entry, 64> entries_{};
};

}  // namespace kinex

#endif
