// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/parts/order_tree.h"

#include "core/numbers/check.h"

namespace kinex {

// The finaliser of SplitMix64 (Steele, Lea, Flood 2014): a bijection, so no two places are equal.
std::uint64_t OrderTree::priority(Place p) {
  std::uint64_t z = (static_cast<std::uint64_t>(p) + 1) * 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

void OrderTree::clear() {
  nodes_.clear();
  root_ = kNone;
}

// The spine holds the right border of the tree so far, from the root down.
void OrderTree::build(const std::vector<Place>& places) {
  clear();
  std::vector<Place> spine;
  for (const Place p : places) {
    make_room(p);
    Place below = kNone;
    while (!spine.empty() && priority(spine.back()) < priority(p)) {
      below = spine.back();
      spine.pop_back();
    }
    nodes_[p].left = below;
    if (below != kNone) nodes_[below].parent = p;
    if (spine.empty()) {
      root_ = p;
    } else {
      nodes_[spine.back()].right = p;
      nodes_[p].parent = spine.back();
    }
    spine.push_back(p);
  }
}

void OrderTree::replace_child(Place parent, Place child, Place by) {
  if (parent == kNone) {
    root_ = by;
  } else if (nodes_[parent].left == child) {
    nodes_[parent].left = by;
  } else {
    nodes_[parent].right = by;
  }
  if (by != kNone) nodes_[by].parent = parent;
}

// Rotates p above its parent; the order of places is unchanged.
void OrderTree::rotate_up(Place p) {
  const Place parent = nodes_[p].parent;
  const Place grandparent = nodes_[parent].parent;
  const bool is_left = nodes_[parent].left == p;
  const Place inner = is_left ? nodes_[p].right : nodes_[p].left;
  (is_left ? nodes_[parent].left : nodes_[parent].right) = inner;
  if (inner != kNone) nodes_[inner].parent = parent;
  replace_child(grandparent, parent, p);
  (is_left ? nodes_[p].right : nodes_[p].left) = parent;
  nodes_[parent].parent = p;
}

void OrderTree::insert_after(Place before, Place place) {
  make_room(place);
  nodes_[place] = Node{};
  if (root_ == kNone) {
    require(before == kNone, "a place that is not in the tree");
    root_ = place;
    return;
  }
  // The free link just behind `before`: its right one, or the left one of its successor.
  Place at = before == kNone ? root_ : nodes_[before].right;
  if (at == kNone) {
    nodes_[before].right = place;
    nodes_[place].parent = before;
  } else {
    while (nodes_[at].left != kNone) at = nodes_[at].left;
    nodes_[at].left = place;
    nodes_[place].parent = at;
  }
  while (nodes_[place].parent != kNone && priority(nodes_[place].parent) < priority(place)) {
    rotate_up(place);
  }
}

void OrderTree::erase(Place place) {
  for (;;) {
    const Place l = nodes_[place].left, r = nodes_[place].right;
    if (l == kNone || r == kNone) {
      replace_child(nodes_[place].parent, place, l == kNone ? r : l);
      nodes_[place] = Node{};
      return;
    }
    rotate_up(priority(l) < priority(r) ? r : l);
  }
}

std::vector<OrderTree::Place> OrderTree::in_order() const {
  std::vector<Place> result, open;
  Place p = root_;
  while (p != kNone || !open.empty()) {
    for (; p != kNone; p = nodes_[p].left) open.push_back(p);
    p = open.back();
    open.pop_back();
    result.push_back(p);
    p = nodes_[p].right;
  }
  return result;
}

bool OrderTree::consistent() const {
  if (root_ != kNone && nodes_[root_].parent != kNone) return false;
  for (const Place p : in_order()) {
    for (const Place child : {nodes_[p].left, nodes_[p].right}) {
      if (child == kNone) continue;
      if (nodes_[child].parent != p || priority(p) < priority(child)) return false;
    }
  }
  return true;
}

}  // namespace kinex
