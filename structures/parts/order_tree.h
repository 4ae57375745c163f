// SPDX-License-Identifier: GPL-3.0-or-later
// OrderTree: a balanced search tree over the places of a sequence, not over keys. A place is a
// number that the owner chooses. The tree does not know what stands at a place, so the owner can
// exchange what stands at two places without touching the tree.
//
// A treap. Priorities are a fixed function of the place's number, so the shape depends on the
// sequence alone; expected depth O(log n) (Seidel and Aragon, "Randomized search trees", 1996).
// Place numbers should be small: the tree takes room up to the largest one.
#ifndef KINEX_STRUCTURES_PARTS_ORDER_TREE_H
#define KINEX_STRUCTURES_PARTS_ORDER_TREE_H

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kinex {

class OrderTree {
 public:
  using Place = std::uint32_t;
  static constexpr Place kNone = 0xffffffffu;

  bool empty() const { return root_ == kNone; }
  Place root() const { return root_; }
  Place left(Place p) const { return nodes_[p].left; }
  Place right(Place p) const { return nodes_[p].right; }

  // Replaces the contents with these distinct places, in this order. O(n).
  void build(const std::vector<Place>& places);
  // Adds `place`, which must not be in the tree, right after `before`, which must be; kNone: in
  // front of all. Expected O(log n) time and O(1) rotations.
  void insert_after(Place before, Place place);
  // Requires that the place is in the tree. Expected O(log n) time and O(1) rotations.
  void erase(Place place);
  void clear();
  // All places in order, for audits. O(n).
  std::vector<Place> in_order() const;
  // True if parents and children agree and priorities are heap-ordered. For audits; O(n).
  bool consistent() const;
  std::size_t bytes() const { return nodes_.capacity() * sizeof(Node); }

 private:
  struct Node {
    Place parent = kNone, left = kNone, right = kNone;
  };
  static std::uint64_t priority(Place p);
  void make_room(Place p) {
    if (nodes_.size() <= p) nodes_.resize(p + std::size_t{1});
  }
  void replace_child(Place parent, Place child, Place by);
  void rotate_up(Place p);

  std::vector<Node> nodes_;
  Place root_ = kNone;
};

}  // namespace kinex

#endif
