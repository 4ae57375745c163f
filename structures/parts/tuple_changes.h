// SPDX-License-Identifier: GPL-3.0-or-later
// TupleChanges: the edges, or cells, that have joined and left an attribute, in order, and their net
// effect. (In an inexact arithmetic one may be present twice.)
#ifndef KINEX_STRUCTURES_PARTS_TUPLE_CHANGES_H
#define KINEX_STRUCTURES_PARTS_TUPLE_CHANGES_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "core/engine/structure.h"
#include "core/motion/scene.h"

namespace kinex {

template <std::size_t kWidth>
class TupleChanges {
 public:
  using Tuple = std::array<ObjectId, kWidth>;  // in any order

  void came(const Tuple& tuple) { add(tuple, true); }
  void gone(const Tuple& tuple) { add(tuple, false); }
  void add(const AttributeDifference& difference);
  void clear() { changes_.clear(); }
  // Keeps only the first `count` changes.
  void cut(std::size_t count) { changes_.resize(count); }
  std::size_t size() const { return changes_.size(); }
  // The difference before against after: a tuple that left and joined again, or the reverse, does
  // not count. O(k log k) for k changes.
  AttributeDifference net() const;
  // net(), and forgets the changes.
  AttributeDifference take();
  // The attribute as it was before the changes.
  Attribute undone(Attribute after) const;
  std::size_t bytes() const { return changes_.capacity() * sizeof(Change); }

 private:
  struct Change {
    Tuple tuple{};  // ascending
    bool came = false;
  };
  void add(Tuple tuple, bool came) {
    std::sort(tuple.begin(), tuple.end());
    changes_.push_back({tuple, came});
  }

  std::vector<Change> changes_;
};

// Edges that come and go: of two objects each.
using EdgeChanges = TupleChanges<2>;
// Triangles of a triangulation in the plane that come and go: of three objects each.
using TriangleChanges = TupleChanges<3>;
// Cells of a triangulation in space that come and go: of four objects each.
using CellChanges = TupleChanges<4>;

}  // namespace kinex

#endif
