// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/parts/link_cut_forest.h"

#include <utility>

namespace kinex {

LinkCutForest::Node LinkCutForest::node_of(Node edge) {
  const Node node = vertices_ + edge;
  if (node >= nodes_.size()) nodes_.resize(node + std::size_t{1});
  return node;
}

bool LinkCutForest::is_splay_root(Node x) const {
  const Node parent = nodes_[x].parent;
  return parent == kNone || (nodes_[parent].child[0] != x && nodes_[parent].child[1] != x);
}

void LinkCutForest::push_down(Node x) {
  if (!nodes_[x].reversed) return;
  nodes_[x].reversed = false;
  std::swap(nodes_[x].child[0], nodes_[x].child[1]);
  for (const Node child : nodes_[x].child) {
    if (child != kNone) nodes_[child].reversed = !nodes_[child].reversed;
  }
}

void LinkCutForest::rotate(Node x) {
  const Node p = nodes_[x].parent, above = nodes_[p].parent;
  const int side = nodes_[p].child[1] == x ? 1 : 0;
  if (!is_splay_root(p)) nodes_[above].child[nodes_[above].child[1] == p ? 1 : 0] = x;
  nodes_[x].parent = above;
  const Node inner = nodes_[x].child[1 - side];
  nodes_[p].child[side] = inner;
  if (inner != kNone) nodes_[inner].parent = p;
  nodes_[x].child[1 - side] = p;
  nodes_[p].parent = x;
}

// Makes x the root of its splay tree.
void LinkCutForest::splay(Node x) {
  above_.assign(1, x);
  while (!is_splay_root(above_.back())) above_.push_back(nodes_[above_.back()].parent);
  while (!above_.empty()) {
    push_down(above_.back());
    above_.pop_back();
  }
  while (!is_splay_root(x)) {
    const Node p = nodes_[x].parent;
    if (!is_splay_root(p)) {
      const Node g = nodes_[p].parent;
      const bool straight = (nodes_[g].child[1] == p) == (nodes_[p].child[1] == x);
      rotate(straight ? p : x);
    }
    rotate(x);
  }
}

// The path from the root of the tree to x becomes one splay tree, with x at its root and end.
void LinkCutForest::access(Node x) {
  Node last = kNone;
  for (Node y = x; y != kNone; y = nodes_[y].parent) {
    splay(y);
    nodes_[y].child[1] = last;
    last = y;
  }
  splay(x);
}

void LinkCutForest::make_root(Node x) {
  access(x);
  nodes_[x].reversed = !nodes_[x].reversed;
}

LinkCutForest::Node LinkCutForest::find_root(Node x) {
  access(x);
  push_down(x);
  while (nodes_[x].child[0] != kNone) {
    x = nodes_[x].child[0];
    push_down(x);
  }
  splay(x);
  return x;
}

void LinkCutForest::join(Node x, Node y) {
  make_root(x);
  nodes_[x].parent = y;
}

// Requires neighbours.
void LinkCutForest::part(Node x, Node y) {
  make_root(x);
  access(y);
  push_down(y);
  nodes_[nodes_[y].child[0]].parent = kNone;
  nodes_[y].child[0] = kNone;
}

void LinkCutForest::link(Node edge, Node u, Node v) {
  const Node e = node_of(edge);
  nodes_[e] = {};
  join(u, e);
  join(e, v);
}

void LinkCutForest::cut(Node edge, Node u, Node v) {
  const Node e = node_of(edge);
  part(u, e);
  part(e, v);
}

bool LinkCutForest::on_path(Node edge, Node u, Node v) {
  const Node e = node_of(edge);
  make_root(u);
  access(v);
  // The path is one splay tree, without a node above it. If it contains e, then e is its root next,
  // and v is near below.
  splay(e);
  if (nodes_[e].parent != kNone) return false;
  Node x = v;
  while (!is_splay_root(x)) x = nodes_[x].parent;
  return x == e;
}

std::vector<LinkCutForest::Node> LinkCutForest::path(Node u, Node v) {
  make_root(u);
  access(v);
  std::vector<Node> edges;
  above_.clear();
  Node x = v;
  while (x != kNone || !above_.empty()) {
    while (x != kNone) {
      push_down(x);
      above_.push_back(x);
      x = nodes_[x].child[0];
    }
    x = above_.back();
    above_.pop_back();
    if (x >= vertices_) edges.push_back(x - vertices_);
    x = nodes_[x].child[1];
  }
  return edges;
}

}  // namespace kinex
