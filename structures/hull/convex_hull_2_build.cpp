// SPDX-License-Identifier: GPL-3.0-or-later
// ConvexHull2: the static algorithm. The tree, and the merge of two chains at a node.
#include <algorithm>
#include <utility>

#include "structures/hull/convex_hull_2.h"

namespace kinex {

// ---- storage

ConvexHull2::Index ConvexHull2::allocate_edge(Index node, ObjectId point) {
  Index e;
  if (free_edges_.empty()) {
    e = static_cast<Index>(edges_.size());
    edges_.emplace_back();
  } else {
    e = free_edges_.back();
    free_edges_.pop_back();
    edges_[e] = Edge();
  }
  edges_[e].point = point;
  edges_[e].node = node;
  return e;
}

void ConvexHull2::free_edge(Index edge) {
  drop_all(edge);
  edges_[edge].node = kNone;
  free_edges_.push_back(edge);
}

ConvexHull2::Index ConvexHull2::allocate_tree_node() {
  if (!free_tree_nodes_.empty()) {
    const Index t = free_tree_nodes_.back();
    free_tree_nodes_.pop_back();
    tree_[t] = TreeNode();
    nodes_[2 * t] = nodes_[2 * t + 1] = Node();
    return t;
  }
  tree_.emplace_back();
  nodes_.resize(2 * tree_.size());
  return static_cast<Index>(tree_.size() - 1);
}

void ConvexHull2::free_chain(Index node) {
  for (Index e = nodes_[node].first; e != kNone;) {
    const Index next = edges_[e].next;
    free_edge(e);
    e = next;
  }
  nodes_[node].first = nodes_[node].last = kNone;
}

// Appends a line at the right end of a chain.
ConvexHull2::Index ConvexHull2::append(Index node, ObjectId point) {
  const Index e = allocate_edge(node, point);
  join(node, nodes_[node].last, e);
  join(node, e, kNone);
  return e;
}

// ---- the merge of one node, linear in the chains of its children

void ConvexHull2::merge(Index node) {
  merge_corners(node);
  merge_purple(node);
  merge_certificates(node);
}

void ConvexHull2::merge_both(Index t) {
  for (unsigned h = 0; h < kHalves; ++h) merge(2 * t + h);
}

// The corners of both chains in the order of x, with their contenders and sides.
void ConvexHull2::merge_corners(Index node) {
  std::array<Index, 2> lines = end_lines(node, 0);  // blue, red: where the sweep is
  for (const bool red : {false, true}) {
    for (Index e = lines[red]; e != kNone; e = edges_[e].next) {
      edges_[e].red = red;
      edges_[e].merge = node;
    }
  }
  const Half side = half(node);
  nodes_[node].height = static_cast<std::uint8_t>(tree_[node / 2].height);
  nodes_[node].red[0] = signs_.slopes_hold(edges_[lines[1]].point, edges_[lines[0]].point);
  for (;;) {
    const bool blue_left = edges_[lines[0]].next != kNone;
    const bool red_left = edges_[lines[1]].next != kNone;
    if (!blue_left && !red_left) break;
    const bool red =
        red_left && (!blue_left || signs_.corners_hold(side, corner(lines[1]), corner(lines[0])));
    const Index v = lines[red], other = lines[!red];
    edges_[v].contender = other;
    edges_[v].above = signs_.above(side, corner(v), edges_[other].point);
    join_corners(node, nodes_[node].tail, v);
    join_corners(node, v, kNone);
    lines[red] = edges_[v].next;
  }
  nodes_[node].red[1] = signs_.slopes_hold(edges_[lines[0]].point, edges_[lines[1]].point);
}

// The upper of the two chains, from left to right.
void ConvexHull2::merge_purple(Index node) {
  const auto show = [this, node](Index line) {
    if (edges_[line].up != kNone) {
      give_up("a line shows twice on an envelope");
      return;
    }
    const Index up = append(node, edges_[line].point);
    edges_[line].up = up;
  };
  bool red_shows = nodes_[node].red[0];
  std::array<Index, 2> lines = end_lines(node, 0);
  const auto cross = [&] {
    for (const Index line : lines) ++edges_[line].crossings;
    red_shows = !red_shows;
    show(lines[red_shows]);
  };
  show(lines[red_shows]);
  for (Index v = nodes_[node].head; v != kNone; v = edges_[v].right) {
    if (red_above(v) != red_shows) cross();
    lines[edges_[v].red] = edges_[v].next;
    if (edges_[v].above) show(edges_[v].next);
  }
  if (nodes_[node].red[1] != red_shows) cross();
}

void ConvexHull2::merge_certificates(Index node) {
  if (corrupt_) return;
  for (const int end : {0, 1}) refresh_end(node, end);
  for (const int which : {0, 1}) {
    for (Index e = nodes_[child(node, which)].first; e != kNone; e = edges_[e].next) {
      refresh_claim(e, kNone);
    }
  }
  for (Index v = nodes_[node].head; v != kNone; v = edges_[v].right) {
    refresh_x(v);
    refresh_y(v);
  }
}

// ---- the tree

void ConvexHull2::make_leaf(Index t, ObjectId object) {
  leaf_of_[object] = t;
  for (unsigned h = 0; h < kHalves; ++h) append(2 * t + h, object);
  tree_[t].leaves = 1;
  tree_[t].height = 0;
}

void ConvexHull2::update_sizes(Index t) {
  TreeNode& node = tree_[t];
  const TreeNode& a = tree_[node.children[0]];
  const TreeNode& b = tree_[node.children[1]];
  node.leaves = a.leaves + b.leaves;
  node.height = 1 + std::max(a.height, b.height);
}

// Builds and merges a balanced tree; returns its root.
ConvexHull2::Index ConvexHull2::build_tree(std::span<const ObjectId> objects) {
  const Index t = allocate_tree_node();
  if (objects.size() == 1) {
    make_leaf(t, objects[0]);
    return t;
  }
  const std::size_t half_size = objects.size() / 2;
  const Index a = build_tree(objects.first(half_size));
  const Index b = build_tree(objects.subspan(half_size));
  tree_[t].children[0] = a;
  tree_[t].children[1] = b;
  tree_[a].parent = tree_[b].parent = t;
  update_sizes(t);
  merge_both(t);
  return t;
}

void ConvexHull2::construct(std::span<const ObjectId> objects) {
  if (corrupt_) return;
  root_ = objects.empty() ? kNone : build_tree(objects);
  work_off();
}

void ConvexHull2::build(std::span<const ObjectId> objects) {
  tree_.reserve(2 * objects.size());
  nodes_.reserve(4 * objects.size());
  construct(objects);
  reset_hull();
}

void ConvexHull2::rebuild() {
  construct_anew();
  reset_hull();
}

void ConvexHull2::construct_anew() {
  std::vector<ObjectId> members;
  for (ObjectId id = 0; id < leaf_of_.size(); ++id) {
    if (leaf_of_[id] != kNone) members.push_back(id);
  }
  for (Index e = 0; e < edges_.size(); ++e) {
    if (edges_[e].node != kNone) drop_all(e);
  }
  for (Index node = 0; node < nodes_.size(); ++node) {
    for (const Slot slot : {kSlotLeft, kSlotRight}) drop(slot, node);
  }
  edges_.clear();
  free_edges_.clear();
  nodes_.clear();
  tree_.clear();
  free_tree_nodes_.clear();
  stale_.clear();
  todo_.clear();
  construct(members);
}

void ConvexHull2::reset_hull() {
  root_changes_ = 0;
  if (!corrupt_) events_.begin(hull_cycle());
}

}  // namespace kinex
