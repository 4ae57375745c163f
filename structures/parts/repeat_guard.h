// SPDX-License-Identifier: GPL-3.0-or-later
// RepeatGuard: detects that an inexact arithmetic cycles.
//
// A polynomial of degree D turns negative at most (D + 1) / 2 times. A certificate for the same
// query that fails far more often under the same motions contradicts itself.
//
// A table of 64 entries: two queries of one entry displace each other, and counting starts again.
// So an answer may come late. Cost: O(1) time, constant space.
#ifndef KINEX_STRUCTURES_PARTS_REPEAT_GUARD_H
#define KINEX_STRUCTURES_PARTS_REPEAT_GUARD_H

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/engine/certificate.h"

namespace kinex {

class RepeatGuard {
 public:
  // Counts a failure of a certificate for `query`. True from the 33rd failure that is counted on.
  bool failed(const Query& query) {
    std::size_t hash = query.predicate;
    for (std::size_t i = 0; i < query.arity; ++i) hash = 31 * hash + query.ids[i];
    Entry& entry = entries_[hash % entries_.size()];
    if (entry.query != query) entry = {query, 0};
    return ++entry.times > kMostTimes;
  }
  // Forgets all counts: motions have changed.
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
