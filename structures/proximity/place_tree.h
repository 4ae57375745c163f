// SPDX-License-Identifier: GPL-3.0-or-later
// PlaceTree: a weight-balanced binary tree whose leaves are objects in an order. It knows no order: an
// object comes behind another one, and leaves.
//
//           1             The subtree of a child has at most 7/10 of the leaves of its parent. An
//         /   \           insertion makes two leaves of one, an erasure one of two; then the highest
//        2     3          node on the way that is out of balance gets a new subtree, as balanced as
//       / \   / \         can be. What an owner keeps at inner nodes is to be made anew below that
//      4   5 c   d        node, and nowhere else.
//     / \   \ ...
//    a   b
//
// Depth: ceil(log2 n) for n leaves that were built, at most 2 ceil(log2 n) in any case, since
// (7/10)^k n >= 1 at depth k.
//
// Cost: a way O(log n). An insertion or erasure O(log n), and O(m) for a new subtree of m leaves, of
// whose leaves then Omega(m) have come or gone since the last time: amortised O(log n).
//
// Source: Overmars, "The design of dynamic data structures" (1983): partial rebuilding.
#ifndef KINEX_STRUCTURES_PROXIMITY_PLACE_TREE_H
#define KINEX_STRUCTURES_PROXIMITY_PLACE_TREE_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/motion/scene.h"

namespace kinex {

class PlaceTree {
 public:
  using Node = std::uint32_t;
  static constexpr Node kNone = 0xffffffffu;
  struct Step {  // an inner node on the way to a leaf
    Node node;
    bool right;  // the leaf is below its right child
  };

  // Of objects below this number.
  explicit PlaceTree(std::size_t objects) : leaf_of_(objects, kNone) {}

  std::size_t size() const { return root_ == kNone ? 0 : nodes_[root_].leaves; }
  // kNone: there are no leaves.
  Node root() const { return root_; }
  // Nodes are below this number.
  std::size_t capacity() const { return nodes_.size(); }
  bool has(ObjectId object) const { return leaf_of_[object] != kNone; }
  // 1 for the root, 2v and 2v + 1 for the children of v, modulo 2^64.
  std::uint64_t number(Node node) const { return nodes_[node].number; }
  // The number of inner nodes above it.
  std::size_t depth(Node node) const;
  // The inner nodes above the leaf of an object, from the root on.
  std::vector<Step> way_to(ObjectId object) const;
  // The inner nodes of a subtree, each before its children.
  std::vector<Node> inner_nodes(Node subtree) const;
  // The objects below a node, in order.
  std::vector<ObjectId> objects(Node subtree) const;

  // In place of what was there.
  void build(std::span<const ObjectId> order);
  // Two objects exchange their leaves.
  void exchange(ObjectId a, ObjectId b);
  // The node whose subtree an insertion behind `previous` (kNoObject: in front of all others), or the
  // erasure of an object, makes anew; kNone: the tree is empty. Nothing changes.
  Node subtree_to_insert(ObjectId previous) const;
  Node subtree_to_erase(ObjectId object) const;
  // Require the subtree that the above return. Its node stays, and so do all that are not below it;
  // if the only leaf is erased there are none.
  void insert(ObjectId object, ObjectId previous, Node subtree);
  void erase(ObjectId object, Node subtree);

  // Links, numbers and balance.
  bool consistent() const;
  std::size_t bytes() const {
    return nodes_.capacity() * sizeof(TreeNode) + free_.capacity() * sizeof(Node) +
           leaf_of_.capacity() * sizeof(Node);
  }

 private:
  struct TreeNode {
    Node parent = kNone;
    std::array<Node, 2> child{kNone, kNone};  // of an inner node
    ObjectId object = kNoObject;              // of a leaf
    std::size_t leaves = 0;
    std::uint64_t number = 1;
  };

  bool is_leaf(Node node) const { return nodes_[node].object != kNoObject; }
  Node new_node();
  // A node gets these leaves, in place of nothing.
  void fill(Node node, std::span<const ObjectId> order);
  void replace(Node subtree, const std::vector<ObjectId>& order);
  // The highest node from `node` on upwards that is out of balance if its subtree gets one leaf more,
  // +1, or one fewer, -1; `node` itself if none is.
  Node highest_out_of_balance(Node node, Node from, int change) const;
  void add_leaves(Node from, int change);

  std::vector<TreeNode> nodes_;
  std::vector<Node> free_;
  std::vector<Node> leaf_of_;  // by object
  Node root_ = kNone;
};

}  // namespace kinex

#endif
