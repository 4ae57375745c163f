// SPDX-License-Identifier: GPL-3.0-or-later
// EdgeChanges: the edges that have joined and left an attribute, in order, and their net effect.
// (In an inexact arithmetic an edge may be present twice.)
#ifndef KINEX_STRUCTURES_PARTS_EDGE_CHANGES_H
#define KINEX_STRUCTURES_PARTS_EDGE_CHANGES_H

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/engine/structure.h"
#include "core/motion/scene.h"

namespace kinex {

class EdgeChanges {
 public:
  void came(ObjectId a, ObjectId b) { changes_.push_back({std::min(a, b), std::max(a, b), true}); }
  void gone(ObjectId a, ObjectId b) { changes_.push_back({std::min(a, b), std::max(a, b), false}); }
  void add(const AttributeDifference& difference);
  void clear() { changes_.clear(); }
  // Keeps only the first `count` changes.
  void cut(std::size_t count) { changes_.resize(count); }
  std::size_t size() const { return changes_.size(); }
  // The difference before against after: an edge that left and joined again, or the reverse, does
  // not count. O(k log k) for k changes.
  AttributeDifference net() const;
  // The attribute as it was before the changes.
  Attribute undone(Attribute after) const;
  std::size_t bytes() const { return changes_.capacity() * sizeof(Change); }

 private:
  struct Change {
    ObjectId a = kNoObject, b = kNoObject;
    bool came = false;
  };
  std::vector<Change> changes_;
};

}  // namespace kinex

#endif
