// SPDX-License-Identifier: GPL-3.0-or-later
// LineHull: the upper convex hull of lines' dual points, for lines that come, go and change.
//
// key_i(t) = slope_i t + height_i is the point (slope_i, height_i). The best line at t is the
// extreme vertex of the hull in direction (t, 1), and the next one to win is the next vertex to the
// right. For a minimum all points are mirrored in the origin.
//
// A balanced tree has the slopes in order in its leaves (lines of one slope share a leaf: the best
// of them counts). Every inner node keeps the bridge of its two halves, the hull edge that spans
// them. The hulls themselves are not stored: a search for a bridge or an extreme vertex descends
// along bridges.
//
//              .o=========o.       the bridge of a node
//           .o'             'o.
//         o'                   'o
//        left half  |  right half       slope -->
//
// Cost: a bridge takes O(log n) signs; an insertion, erasure or change O(log n) bridges, so
// O(log^2 n) signs, amortised (unbalanced subtrees are rebuilt), and a move of memory for lines of
// one slope; building O(n log n); best() O(log n) signs; next() O(log n), no signs. Space O(n).
//
// Ties. Of equal lines the smallest id counts; points on an edge of the hull are no vertices.
//
// Source: Overmars, van Leeuwen, "Maintenance of configurations in the plane" (1981), for bridges
// and the case analysis; Galperin, Rivest, "Scapegoat trees" (1993), for the balance.
#ifndef KINEX_STRUCTURES_MAXIMUM_LINE_HULL_H
#define KINEX_STRUCTURES_MAXIMUM_LINE_HULL_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/engine/kernel.h"
#include "structures/parts/key_order.h"

namespace kinex {

// The predicates on lines. For a minimum they are those on the mirrored points.
class LineOrder {
 public:
  // Throws std::invalid_argument for a key that is not linear.
  LineOrder(Kernel& kernel, const Contest& contest, int dimension);

  // The sign of slope_b - slope_a.
  Sign slopes(ObjectId a, ObjectId b) const;
  // True if c is on or above the line through a and b, where a's slope is the smaller one.
  bool above(ObjectId a, ObjectId b, ObjectId c) const;
  // True if at the slope of e the line ab is strictly above the line cd.
  bool meets_before(ObjectId a, ObjectId b, ObjectId c, ObjectId d, ObjectId e) const;
  // True if a is better right after now, ties by id.
  bool beats(ObjectId a, ObjectId b) const { return contest_->beats(a, b); }

 private:
  Kernel* kernel_;
  const Contest* contest_;
  bool mirrored_;
  PredicateId slope_order_, turn_, meeting_;
};

class LineHull {
 public:
  LineHull(const LineOrder& order, std::size_t objects)
      : order_(&order), leaf_of_(objects, kNone) {}

  // Replaces the contents by these.
  void build(std::vector<ObjectId> members);
  void insert(ObjectId object);
  void erase(ObjectId object);
  // The lines of these have changed.
  void change(std::span<const ObjectId> objects);

  bool empty() const { return root_ == kNone; }
  std::size_t size() const { return size_; }
  bool contains(ObjectId object) const { return leaf_of_[object] != kNone; }
  // All members, ascending.
  std::vector<ObjectId> members() const;
  // The best line right after now. Requires !empty().
  ObjectId best() const;
  // The vertex after this one; kNoObject at the end. Requires that `object` is a vertex.
  ObjectId next(ObjectId object) const;
  // The vertices in the order in which they win. O(n log n) for n of them.
  std::vector<ObjectId> vertices() const;
  // The number of edges between the root and the deepest leaf. O(n).
  std::size_t height() const;
  // Describes a defect of the tree, for invariants; empty if there is none. O(n), no signs.
  std::string complaint() const;
  std::size_t bytes() const;

 private:
  using Place = std::uint32_t;
  static constexpr Place kNone = 0xffffffffu;
  struct Node {
    Place parent = kNone;
    std::array<Place, 2> child{kNone, kNone};   // both or none
    std::array<Place, 2> bridge{kNone, kNone};  // leaves; of a leaf itself, twice
    Place first = kNone;                        // the leftmost leaf below
    std::uint32_t leaves = 0;                   // 0: not in use
  };

  bool is_leaf(Place p) const { return nodes_[p].child[0] == kNone; }
  ObjectId line(Place leaf) const { return groups_[leaf].front(); }
  Place new_node();
  void free_node(Place p);
  Place new_leaf(ObjectId object);
  void sort(std::vector<ObjectId>& members) const;
  Place build_tree(std::span<const Place> leaves);
  void refresh(Place p);
  void refresh_above(const std::vector<Place>& leaves);
  void rebalance_above(Place leaf);
  void find_bridge(Place p);
  bool place_in_group(Place leaf, ObjectId object);
  Place detach(ObjectId object);
  void put_in_place_of(Place old, Place fresh);

  const LineOrder* order_;
  std::vector<Node> nodes_;
  std::vector<std::vector<ObjectId>> groups_;  // per leaf: lines of one slope, the best one first
  std::vector<Place> free_;
  std::vector<Place> leaf_of_;  // per object
  Place root_ = kNone;
  std::size_t size_ = 0;
};

}  // namespace kinex

#endif
