// SPDX-License-Identifier: GPL-3.0-or-later
// ConjugationTree: a static tree over linear motions along one axis: which coordinates are in an
// interval, at any time. In the dual plane (dual_points.h): which points are in a strip.
//
// A node of more than kLeaf points halves them by a line, and both of its halves are halved by one
// common line (halving_line.h). Every inner node stores the convex hull of its points as two chains:
// its largest and its least coordinate at any time are found there by binary search.
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

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/engine/audit.h"
#include "structures/parts/query_trace.h"
#include "structures/range/dual_points.h"

namespace kinex {

// Positions at one time, and a box.
class BoxAt {
 public:
  virtual ~BoxAt() = default;
  // The coordinate of a is smaller than that of b.
  virtual bool precedes(int axis, ObjectId a, ObjectId b) = 0;
  virtual bool is_below(int axis, ObjectId object) = 0;   // before the low side of the box
  virtual bool is_beyond(int axis, ObjectId object) = 0;  // after the high side
  bool holds(int axis, ObjectId object) {
    return !is_below(axis, object) && !is_beyond(axis, object);
  }
};

class ConjugationTree {
 public:
  static constexpr std::size_t kLeaf = 8;  // the most points of a leaf
  using Ref = std::uint32_t;
  static constexpr Ref kRoot = 0;

  // A vertex of a chain.
  struct Vertex {
    ObjectId object = kNoObject;
    std::uint32_t place = 0xffffffffu;  // in the order of the leaves
  };
  // What is known of a node: the sides of the box that may have points of it on both of their
  // sides, and, once it is crossed, its extreme points. Of two halves one has the least point of
  // their node, which is before the low side if that is crossed, and not beyond the high side.
  struct Seen {
    bool low = true, high = true;
    Vertex least, largest;
    bool decided() const { return !low && !high; }
    // An object of the node, without signs that are known.
    bool holds(BoxAt& box, int axis, ObjectId object) const {
      return !(low && box.is_below(axis, object)) && !(high && box.is_beyond(axis, object));
    }
  };

  // Of these objects. Requires linear motions.
  ConjugationTree(const DualPoints& points, std::vector<ObjectId> objects);

  int axis() const { return axis_; }
  std::size_t size() const { return order_.size(); }
  std::size_t nodes() const { return nodes_.size(); }
  bool is_leaf(Ref node) const { return nodes_[node].below == kRoot; }
  // The two halves of an inner node are neighbours.
  Ref below(Ref node, std::size_t half) const {
    return nodes_[node].below + static_cast<Ref>(half);
  }
  std::span<const ObjectId> objects(Ref node) const {
    return {order_.data() + nodes_[node].first, order_.data() + nodes_[node].end};
  }
  // Where an inner node is. `seen` is what is known of the node above, which is crossed (at the root:
  // nothing), and then of this one. Where a half has an extreme point of its node, that takes no
  // signs.
  NodePlace place(Ref node, BoxAt& box, Seen& seen) const;
  // Appends the objects in the interval of this axis, and the nodes looked at to `trace`, if there
  // is one. Returns the number of nodes looked at and points tested.
  std::uint64_t search(BoxAt& box, std::vector<ObjectId>& out, QueryTrace* trace) const;
  // Appends a node that a query looks at. Those of leaves are crossed.
  void add_to(QueryTrace* trace, Ref node, NodePlace place) const {
    if (trace == nullptr) return;
    trace->push_back({place, {objects(node).begin(), objects(node).end()}});
  }
  // The hard bound of search() for n objects. O(log n).
  static std::uint64_t most_looked_at(std::uint64_t n);
  // The most points of a node of each level, from n down to those of leaves.
  static std::vector<std::uint64_t> sizes_below(std::uint64_t n);

  // The halves are halves, and the chains are extreme at this time.
  void check(const Snapshot& now, AuditReport& report) const;
  std::size_t bytes() const {
    return nodes_.capacity() * sizeof(Node) + order_.capacity() * sizeof(ObjectId) +
           chains_.capacity() * sizeof(Vertex);
  }

 private:
  struct Node {
    std::uint32_t first = 0, end = 0;              // its objects in order_
    std::uint32_t lower = 0, upper = 0, stop = 0;  // its chains in chains_, by slope
    Ref below = kRoot;                             // kRoot: a leaf
  };

  void halve(Ref node, const DualPoints& points);
  void make_chains(Ref node, const DualPoints& points, const std::vector<std::uint32_t>& rank);
  Vertex least(Ref node, BoxAt& box) const;
  Vertex largest(Ref node, BoxAt& box) const;

  int axis_;
  std::vector<Node> nodes_;
  std::vector<ObjectId> order_;  // by leaves
  std::vector<Vertex> chains_;   // of inner nodes
};

}  // namespace kinex

#endif
