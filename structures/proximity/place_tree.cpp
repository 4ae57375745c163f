// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/place_tree.h"

#include <algorithm>
#include <utility>

namespace kinex {
namespace {

// A child with so many of the leaves of its parent.
bool is_too_heavy(std::size_t child, std::size_t parent) { return 10 * child > 7 * parent; }

}  // namespace

// ---- the tree as it is

std::size_t PlaceTree::depth(Node node) const {
  std::size_t depth = 0;
  while (nodes_[node].parent != kNone) {
    node = nodes_[node].parent;
    ++depth;
  }
  return depth;
}

std::vector<PlaceTree::Step> PlaceTree::way_to(ObjectId object) const {
  std::vector<Step> way;
  for (Node node = leaf_of_[object]; nodes_[node].parent != kNone; node = nodes_[node].parent) {
    const Node parent = nodes_[node].parent;
    way.push_back({parent, nodes_[parent].child[1] == node});
  }
  std::reverse(way.begin(), way.end());
  return way;
}

std::vector<PlaceTree::Node> PlaceTree::inner_nodes(Node subtree) const {
  std::vector<Node> result, left{subtree};
  while (!left.empty()) {
    const Node node = left.back();
    left.pop_back();
    if (node == kNone || is_leaf(node)) continue;
    result.push_back(node);
    left.push_back(nodes_[node].child[1]);
    left.push_back(nodes_[node].child[0]);
  }
  return result;
}

std::vector<ObjectId> PlaceTree::objects(Node subtree) const {
  std::vector<ObjectId> result;
  std::vector<Node> left{subtree};
  while (!left.empty()) {
    const Node node = left.back();
    left.pop_back();
    if (node == kNone) continue;
    if (is_leaf(node)) {
      result.push_back(nodes_[node].object);
    } else {
      left.push_back(nodes_[node].child[1]);
      left.push_back(nodes_[node].child[0]);
    }
  }
  return result;
}

// ---- new subtrees

PlaceTree::Node PlaceTree::new_node() {
  if (free_.empty()) {
    nodes_.emplace_back();
    return static_cast<Node>(nodes_.size() - 1);
  }
  const Node node = free_.back();
  free_.pop_back();
  nodes_[node] = TreeNode{};
  return node;
}

void PlaceTree::fill(Node node, std::span<const ObjectId> order) {
  nodes_[node].leaves = order.size();
  if (order.size() == 1) {
    nodes_[node].object = order[0];
    leaf_of_[order[0]] = node;
    return;
  }
  const std::size_t middle = order.size() / 2;
  for (const bool right : {false, true}) {
    const Node child = new_node();
    nodes_[child].parent = node;
    nodes_[child].number = 2 * nodes_[node].number + (right ? 1 : 0);
    nodes_[node].child[right ? 1 : 0] = child;
    fill(child, right ? order.subspan(middle) : order.first(middle));
  }
}

void PlaceTree::replace(Node subtree, const std::vector<ObjectId>& order) {
  std::vector<Node> left;
  const auto leave = [&](Node node) {
    for (const Node child : nodes_[node].child) {
      if (child != kNone) left.push_back(child);
    }
    if (is_leaf(node)) leaf_of_[nodes_[node].object] = kNone;
  };
  leave(subtree);
  while (!left.empty()) {
    const Node node = left.back();
    left.pop_back();
    leave(node);
    free_.push_back(node);
  }
  nodes_[subtree].child = {kNone, kNone};
  nodes_[subtree].object = kNoObject;
  fill(subtree, order);
}

void PlaceTree::build(std::span<const ObjectId> order) {
  nodes_.clear();
  free_.clear();
  std::fill(leaf_of_.begin(), leaf_of_.end(), kNone);
  root_ = kNone;
  if (order.empty()) return;
  root_ = new_node();
  fill(root_, order);
}

void PlaceTree::exchange(ObjectId a, ObjectId b) {
  std::swap(leaf_of_[a], leaf_of_[b]);
  nodes_[leaf_of_[a]].object = a;
  nodes_[leaf_of_[b]].object = b;
}

// ---- leaves that come and go

PlaceTree::Node PlaceTree::highest_out_of_balance(Node node, Node from, int change) const {
  const auto then = [&](std::size_t leaves) { return change > 0 ? leaves + 1 : leaves - 1; };
  Node result = node;
  for (Node below = from, above = nodes_[from].parent; above != kNone;
       below = above, above = nodes_[above].parent) {
    const auto [left, right] = nodes_[above].child;
    const std::size_t changed = then(nodes_[below].leaves);
    const std::size_t other = nodes_[below == left ? right : left].leaves;
    if (is_too_heavy(std::max(changed, other), changed + other)) result = above;
  }
  return result;
}

PlaceTree::Node PlaceTree::subtree_to_insert(ObjectId previous) const {
  if (root_ == kNone) return kNone;
  Node leaf = previous == kNoObject ? root_ : leaf_of_[previous];
  while (!is_leaf(leaf)) leaf = nodes_[leaf].child[0];
  return highest_out_of_balance(leaf, leaf, 1);
}

// The parent of a leaf that goes: its other child has at most two leaves, or it was out of balance.
PlaceTree::Node PlaceTree::subtree_to_erase(ObjectId object) const {
  const Node leaf = leaf_of_[object], parent = nodes_[leaf].parent;
  return parent == kNone ? leaf : highest_out_of_balance(parent, parent, -1);
}

void PlaceTree::add_leaves(Node from, int change) {
  for (Node node = nodes_[from].parent; node != kNone; node = nodes_[node].parent) {
    nodes_[node].leaves += change > 0 ? std::size_t{1} : ~std::size_t{0};
  }
}

void PlaceTree::insert(ObjectId object, ObjectId previous, Node subtree) {
  if (subtree == kNone) return build(std::span(&object, 1));
  std::vector<ObjectId> order = objects(subtree);
  const auto behind = std::find(order.begin(), order.end(), previous);
  order.insert(behind == order.end() ? order.begin() : behind + 1, object);
  replace(subtree, order);
  add_leaves(subtree, 1);
}

void PlaceTree::erase(ObjectId object, Node subtree) {
  std::vector<ObjectId> order = objects(subtree);
  std::erase(order, object);
  if (order.empty()) return build({});
  replace(subtree, order);
  leaf_of_[object] = kNone;
  add_leaves(subtree, -1);
}

// ---- checks

bool PlaceTree::consistent() const {
  std::size_t leaves = 0;
  for (const Node node : leaf_of_) leaves += node == kNone ? 0 : 1;
  if (leaves != size()) return false;
  for (ObjectId object = 0; object < leaf_of_.size(); ++object) {
    if (has(object) && nodes_[leaf_of_[object]].object != object) return false;
  }
  for (const Node node : inner_nodes(root_)) {
    std::size_t sum = 0;
    for (const std::size_t side : {0, 1}) {
      const TreeNode& child = nodes_[nodes_[node].child[side]];
      if (child.parent != node || child.number != 2 * nodes_[node].number + side) return false;
      if (is_too_heavy(child.leaves, nodes_[node].leaves)) return false;
      sum += child.leaves;
    }
    if (sum != nodes_[node].leaves) return false;
  }
  return true;
}

}  // namespace kinex
