// SPDX-License-Identifier: GPL-3.0-or-later
// OctantPairs: pairs of points among which is every closest pair whose second point is in a given
// octant of the first: a range tree of two levels, by places in three orders alone.
//
// The octant p + K is "behind p in the orders alpha and beta", and u is its projection. A point is
// in K of another iff it is behind in alpha and in beta.
//
//              z                 A static balanced tree over the places of alpha. Its inner node z
//            /   \               has a treap, by beta, of the points below it: those of the left
//     lookers     seen           child are lookers, those of the right child are seen.
//
//              t                 A treap node t knows the last looker and the first seen, by u, of
//            /   \               its subtree, and offers two pairs:
//      looker     seen             (last looker on its left, first seen of itself and its right)
//                                  (itself, if it is a looker, first seen on its right)
//
// Lemma. If q is in p + K and pq is a closest pair, then q is strictly the first point of p + K by
// u, and p strictly the last of q - K. (For K = {0 <= y < x}, p = 0, q = (1, b): a point (a, c) of K
// with a <= 1 is nearer to q than p is.) So every closest pair is offered where p and q separate.
//
// Cost, for n points: n ceil(log2 n) treap nodes, two offers each. Two neighbours that change
// places in an order: O(log^2 n) steps.
//
// Source: after Basch, Guibas, Zhang, "Proximity problems on moving points" (1997), and Agarwal,
// Kaplan, Sharir, "Kinetic and dynamic data structures for closest pair and all nearest neighbors"
// (2008); octants and offers are ours.
#ifndef KINEX_STRUCTURES_PROXIMITY_OCTANT_PAIRS_H
#define KINEX_STRUCTURES_PROXIMITY_OCTANT_PAIRS_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/engine/audit.h"
#include "core/motion/scene.h"

namespace kinex {

// The places of points in a list, from either end.
class PlacesAlong {
 public:
  // `place`: by object; it outlives this.
  PlacesAlong(const std::vector<std::uint32_t>& place, bool reversed)
      : place_(&place), reversed_(reversed) {}
  bool before(ObjectId a, ObjectId b) const { return ((*place_)[a] < (*place_)[b]) != reversed_; }
  // Of n points.
  std::uint32_t place(ObjectId a, std::size_t n) const {
    const std::uint32_t place = (*place_)[a];
    return reversed_ ? static_cast<std::uint32_t>(n) - 1 - place : place;
  }

 private:
  const std::vector<std::uint32_t>* place_;
  bool reversed_;
};

class OctantPairs {
 public:
  using Pair = std::array<ObjectId, 2>;
  // offered(pair, +1) when a node offers it, offered(pair, -1) when it ceases to.
  using Offered = std::function<void(const Pair&, int)>;

  OctantPairs(PlacesAlong alpha, PlacesAlong beta, PlacesAlong projection, std::size_t objects,
              Offered offered);

  // The points are these, in any order, at their places.
  void build(std::span<const ObjectId> points);
  // Two neighbours have changed places in the order.
  void alpha_changed(ObjectId a, ObjectId b);
  void beta_changed(ObjectId a, ObjectId b);
  void projection_changed(ObjectId a, ObjectId b);

  // Links, orders, aggregates and offers, by brute force.
  void check(AuditReport& report) const;
  std::size_t bytes() const;

 private:
  using Node = std::uint32_t;
  static constexpr Node kNone = 0xffffffffu;
  struct TreapNode {
    ObjectId object = kNoObject;
    bool looks = false;
    std::uint64_t priority = 0;
    std::array<Node, 2> child{kNone, kNone};
    Node parent = kNone;
    ObjectId last = kNoObject, first = kNoObject;  // looker and seen, of the subtree
    std::array<Pair, 2> offers{Pair{kNoObject, kNoObject}, Pair{kNoObject, kNoObject}};
  };
  // A node of the tree over places, on the way to a leaf.
  struct Step {
    std::size_t tree;      // its number: 1 for the root, 2v and 2v + 1 for the children of v
    std::uint32_t middle;  // the first place of its right child
  };

  std::vector<Step> way_to(std::uint32_t place) const;
  ObjectId later(ObjectId a, ObjectId b) const;
  ObjectId earlier(ObjectId a, ObjectId b) const;
  void set_offer(TreapNode& node, std::size_t i, ObjectId looker, ObjectId seen);
  void renew(Node t);
  void renew_upwards(Node t);
  void rotate_up(Node t);
  void insert(std::size_t tree, std::size_t depth, ObjectId object, bool looks);
  void erase(std::size_t tree, std::size_t depth, ObjectId object);
  Node& node_of(std::size_t depth, ObjectId object) { return node_of_[depth][object]; }
  void check_subtree(Node t, Node parent, std::vector<ObjectId>& order, AuditReport& report) const;

  PlacesAlong alpha_, beta_, projection_;
  std::size_t objects_;
  Offered offered_;
  std::size_t size_ = 0;
  std::vector<Node> root_;                  // of the treap of a tree node
  std::vector<std::vector<Node>> node_of_;  // by depth and object
  std::vector<TreapNode> nodes_;
  std::vector<Node> free_;
};

}  // namespace kinex

#endif
