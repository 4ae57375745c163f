// SPDX-License-Identifier: GPL-3.0-or-later
// MemberPairs: the objects that are there, and all pairs of them: for structures that keep something
// for each pair.
#ifndef KINEX_STRUCTURES_PARTS_MEMBER_PAIRS_H
#define KINEX_STRUCTURES_PARTS_MEMBER_PAIRS_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/motion/scene.h"

namespace kinex {

class MemberPairs {
 public:
  using Pair = std::array<ObjectId, 2>;  // ids ascending

  // `objects`: ascending.
  void assign(std::span<const ObjectId> objects) {
    members_.assign(objects.begin(), objects.end());
  }
  // Calls visit(pair) for each pair that comes, or goes, with the object; the others ascend. O(n).
  template <class Visit>
  void insert(ObjectId object, const Visit& visit) {
    each_with(object, visit);
    members_.insert(std::lower_bound(members_.begin(), members_.end(), object), object);
  }
  template <class Visit>
  void erase(ObjectId object, const Visit& visit) {
    members_.erase(std::lower_bound(members_.begin(), members_.end(), object));
    each_with(object, visit);
  }

  const std::vector<ObjectId>& members() const { return members_; }  // ascending
  // Those for which counts(a, b) holds, ascending. O(n^2).
  template <class Counts>
  std::vector<Pair> all(const Counts& counts) const {
    std::vector<Pair> result;
    for (std::size_t i = 0; i < members_.size(); ++i) {
      for (std::size_t j = i + 1; j < members_.size(); ++j) {
        if (counts(members_[i], members_[j])) result.push_back({members_[i], members_[j]});
      }
    }
    return result;
  }
  // The number of all pairs.
  std::size_t pairs() const {
    const std::size_t n = members_.size();
    return n == 0 ? 0 : n * (n - 1) / 2;
  }
  std::size_t bytes() const { return members_.capacity() * sizeof(ObjectId); }

 private:
  template <class Visit>
  void each_with(ObjectId object, const Visit& visit) const {
    for (const ObjectId other : members_) {
      visit(Pair{std::min(object, other), std::max(object, other)});
    }
  }

  std::vector<ObjectId> members_;
};

}  // namespace kinex

#endif
