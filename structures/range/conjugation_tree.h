// SPDX-License-Identifier: GPL-3.0-or-later
// ConjugationTrees: static trees over linear motions along one axis: which coordinates are in an
// interval, at any time. In the dual plane (dual_points.h): which points are in a strip.
//
// A node of more than kLeaf points halves them by a line, and both of its halves are halved by one
// common line (halving_line.h). Every inner node stores the convex hull of its points as two chains:
// its largest and its least coordinate at any time are on these. A search compares all points of a
// leaf with the interval at once, and all vertices of both chains, unless these are long. Their
// motions are side by side in tables (coordinate_table.h), and all trees share their memory: what a
// search waits for is memory.
//
//      A1 \ | B1         a line that cuts neither of the two lines in their crossing misses one of
//    ------\|-------     A1, A2, B1, B2. So of n points a line crosses F(n) = F(n/2) + F(n/4) + 2
//      A2   |\ B2        nodes: O(n^0.695), exponent log2 of the golden ratio
//
// Cost: space n log n for the chains, O(n) in practice; building expected O(n log^2 n) signs of degree
// 0 in t. The hard bound on what a query looks at is computed from the recurrence.
//
// Source: Edelsbrunner, Welzl, "Halfplanar range search in linear space and O(n^0.695) query time"
// (1986). The chains in place of cells are ours.
#ifndef KINEX_STRUCTURES_RANGE_CONJUGATION_TREE_H
#define KINEX_STRUCTURES_RANGE_CONJUGATION_TREE_H

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/arithmetic/coordinate_table.h"
#include "core/engine/audit.h"
#include "core/numbers/big_array.h"
#include "structures/parts/query_trace.h"
#include "structures/range/dual_points.h"

namespace kinex {

// Positions at one time, and a box.
class BoxAt {
 public:
  virtual ~BoxAt() = default;
  // The coordinate of a is smaller than that of b.
  virtual bool precedes(int axis, ObjectId a, ObjectId b) = 0;
  // Which objects are out of the box on this axis? They are those of the table from `place` on,
  // OutOfInterval::kMost at most.
  virtual OutOfInterval out(int axis, const CoordinateTable& table, std::size_t place,
                            std::span<const ObjectId> objects) = 0;
};

// The sides of the box that may have points of a node on both of their sides.
struct CrossedSides {
  bool low = true, high = true;
  bool decided() const { return !low && !high; }
};

class ConjugationTrees {
 public:
  static constexpr std::size_t kLeaf = 32;  // the most points of a leaf
  static_assert(kLeaf <= OutOfInterval::kMost);
  using Ref = std::uint32_t;
  static constexpr Ref kNone = 0;
  using Seen = CrossedSides;

  // Nodes that a search has to look at, the latest first. Each is replaced by two below it, so there
  // is room for a tree of any depth.
  class OpenNodes {
   public:
    bool empty() const { return size_ == 0; }
    void push(Ref node, Seen seen) { nodes_[size_++] = {node, seen}; }
    std::pair<Ref, Seen> pop() { return nodes_[--size_]; }

   private:
    std::array<std::pair<Ref, Seen>, 34> nodes_;
    std::size_t size_ = 0;
  };

  explicit ConjugationTrees(const DualPoints& points) : points_(&points) {}

  // A tree of these objects; returns its root. Requires linear motions.
  Ref add(std::span<const ObjectId> objects);
  // Call it after the last add() and before the first search.
  void finish();

  int axis() const { return points_->axis(); }
  Ref nodes() const { return static_cast<Ref>(nodes_.size()); }  // of all trees, numbered from 1
  bool is_leaf(Ref node) const { return nodes_[node].below == kNone; }
  // The two halves of an inner node are neighbours.
  Ref below(Ref node, std::size_t half) const {
    return nodes_[node].below + static_cast<Ref>(half);
  }
  std::span<const ObjectId> objects(Ref node) const {
    return {order_.data() + nodes_[node].first, order_.data() + nodes_[node].end};
  }
  // The objects of all trees, and the places of a node's among them.
  std::span<const ObjectId> order() const { return order_; }
  std::size_t first_place(Ref node) const { return nodes_[node].first; }
  const CoordinateTable& table() const { return in_order_; }
  // Where an inner node is. `seen` is what is known of the node above, which is crossed (at the root:
  // nothing), and then of this one.
  NodePlace place(Ref node, BoxAt& box, Seen& seen) const;
  // Which objects of a leaf are in the box on an axis? Bit i: the i-th one. `table` has the motions
  // along that axis at the places of these trees.
  std::uint64_t inside(Ref leaf, BoxAt& box, int axis, const CoordinateTable& table) const;
  // Appends the objects of a tree in the interval of this axis, and the nodes looked at to `trace`, if
  // there is one. Returns the number of nodes looked at and points tested.
  std::uint64_t search(Ref root, BoxAt& box, std::vector<ObjectId>& out, QueryTrace* trace) const;
  // Appends the objects of a leaf whose bits are set.
  void add_some(Ref leaf, std::uint64_t bits, std::vector<ObjectId>& out) const {
    const ObjectId* const first = order_.data() + nodes_[leaf].first;
    for (; bits != 0; bits &= bits - 1) out.push_back(first[std::countr_zero(bits)]);
  }
  // Appends a node that a query looks at. Those of leaves are crossed.
  void add_to(QueryTrace* trace, Ref node, NodePlace place) const {
    if (trace == nullptr) return;
    trace->push_back({place, {objects(node).begin(), objects(node).end()}});
  }
  // Prefetches the motions that a search of this node compares first.
  void prefetch(Ref node) const {
    const Node& there = nodes_[node];
    if (there.below == kNone) {
      in_order_.prefetch(there.first, there.end - there.first);
    } else {
      in_chains_.prefetch(there.lower, std::size_t{there.stop} - there.lower);
    }
  }
  // The hard bound of search() for n objects. O(log n).
  static std::uint64_t most_looked_at(std::uint64_t n);
  // The most points of a node of each level, from n down to those of leaves.
  static std::vector<std::uint64_t> sizes_below(std::uint64_t n);

  // The halves are halves, and the chains are extreme at this time.
  void check(const Snapshot& now, AuditReport& report) const;
  std::size_t bytes() const {
    return nodes_.capacity() * sizeof(Node) + order_.capacity() * sizeof(ObjectId) +
           chains_.capacity() * sizeof(ObjectId) + in_order_.bytes() + in_chains_.bytes();
  }

 private:
  struct Node {
    std::uint32_t first = 0, end = 0;              // its objects in order_
    std::uint32_t lower = 0, upper = 0, stop = 0;  // its chains in chains_, by slope
    Ref below = kNone;                             // kNone: a leaf
  };
  // Of both chains of a node: some vertex is out of the box on the side that it is extreme towards, or
  // all are out on the other side.
  struct Out {
    bool low, high;                 // some of the lower chain before the box; of the upper one after it
    bool all_before, all_after;  // all of the upper chain before the box; of the lower one after it
  };

  void halve(Ref node);
  void make_chains(Ref node);
  Out out_of(const Node& node, BoxAt& box) const;
  Out out_of_long(const Node& node, BoxAt& box) const;
  std::uint32_t extreme(BoxAt& box, bool is_upper, std::uint32_t from, std::uint32_t end) const;

  const DualPoints* points_;
  BigArray<Node> nodes_ = BigArray<Node>(1);  // the first one is none
  BigArray<ObjectId> order_;    // by leaves
  BigArray<ObjectId> chains_;   // of inner nodes
  CoordinateTable in_order_, in_chains_;
  std::vector<std::uint32_t> rank_;  // while trees are added: by slope, of the objects of the last one
};

}  // namespace kinex

#endif
