// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/octant_pairs.h"

#include <algorithm>
#include <utility>

namespace kinex {
namespace {

// splitmix64: priorities of treaps that are the same everywhere.
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

}  // namespace

OctantPairs::OctantPairs(PlacesAlong alpha, PlacesAlong beta, PlacesAlong projection,
                         std::size_t objects, Offered offered)
    : alpha_(alpha),
      beta_(beta),
      projection_(projection),
      objects_(objects),
      offered_(std::move(offered)) {}

// ---- aggregates and offers

ObjectId OctantPairs::later(ObjectId a, ObjectId b) const {
  if (a == kNoObject || b == kNoObject) return a == kNoObject ? b : a;
  return projection_.before(a, b) ? b : a;
}

ObjectId OctantPairs::earlier(ObjectId a, ObjectId b) const {
  if (a == kNoObject || b == kNoObject) return a == kNoObject ? b : a;
  return projection_.before(a, b) ? a : b;
}

void OctantPairs::set_offer(TreapNode& node, std::size_t i, ObjectId looker, ObjectId seen) {
  Pair pair{kNoObject, kNoObject};
  if (looker != kNoObject && seen != kNoObject)
    pair = std::minmax(looker, seen).first == looker ? Pair{looker, seen} : Pair{seen, looker};
  if (node.offers[i] == pair) return;
  if (node.offers[i][0] != kNoObject) offered_(node.offers[i], -1);
  node.offers[i] = pair;
  if (pair[0] != kNoObject) offered_(pair, 1);
}

// From its children.
void OctantPairs::renew(Node t) {
  TreapNode& node = nodes_[t];
  ObjectId last[2], first[2];
  for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
    const Node child = node.child[side];
    last[side] = child == kNone ? kNoObject : nodes_[child].last;
    first[side] = child == kNone ? kNoObject : nodes_[child].first;
  }
  const ObjectId looker = node.looks ? node.object : kNoObject;
  const ObjectId seen = node.looks ? kNoObject : node.object;
  node.last = later(later(last[0], last[1]), looker);
  node.first = earlier(earlier(first[0], first[1]), seen);
  set_offer(node, 0, last[0], earlier(seen, first[1]));
  set_offer(node, 1, looker, first[1]);
}

void OctantPairs::renew_upwards(Node t) {
  for (; t != kNone; t = nodes_[t].parent) renew(t);
}

// ---- treaps

// t takes the place of its parent, which becomes its child. The aggregates above stay.
void OctantPairs::rotate_up(Node t) {
  const Node p = nodes_[t].parent, g = nodes_[p].parent;
  const std::size_t side = nodes_[p].child[1] == t ? 1 : 0;
  const Node inner = nodes_[t].child[1 - side];
  nodes_[p].child[side] = inner;
  if (inner != kNone) nodes_[inner].parent = p;
  nodes_[t].child[1 - side] = p;
  nodes_[p].parent = t;
  nodes_[t].parent = g;
  if (g != kNone) nodes_[g].child[nodes_[g].child[1] == p ? 1 : 0] = t;
}

void OctantPairs::insert(std::size_t tree, std::size_t depth, ObjectId object, bool looks) {
  Node t;
  if (free_.empty()) {
    t = static_cast<Node>(nodes_.size());
    nodes_.emplace_back();
  } else {
    t = free_.back();
    free_.pop_back();
  }
  TreapNode& node = nodes_[t];
  node.object = object;
  node.looks = looks;
  node.priority = mixed(tree * objects_ + object);
  node_of(depth, object) = t;
  Node above = kNone;
  std::size_t side = 0;
  for (Node s = root_[tree]; s != kNone; s = nodes_[s].child[side]) {
    above = s;
    side = beta_.before(nodes_[s].object, object) ? 1 : 0;
  }
  node.parent = above;
  if (above != kNone) nodes_[above].child[side] = t;
  while (nodes_[t].parent != kNone && nodes_[nodes_[t].parent].priority < nodes_[t].priority) {
    const Node down = nodes_[t].parent;
    rotate_up(t);
    renew(down);
  }
  if (nodes_[t].parent == kNone) root_[tree] = t;
  renew_upwards(t);
}

void OctantPairs::erase(std::size_t tree, std::size_t depth, ObjectId object) {
  const Node t = node_of(depth, object);
  node_of(depth, object) = kNone;
  for (;;) {  // downwards, until it is a leaf
    const auto [left, right] = nodes_[t].child;
    if (left == kNone && right == kNone) break;
    const bool up_left =
        right == kNone || (left != kNone && nodes_[left].priority > nodes_[right].priority);
    const Node up = up_left ? left : right;
    rotate_up(up);
    if (nodes_[up].parent == kNone) root_[tree] = up;
  }
  TreapNode& node = nodes_[t];
  const Node above = node.parent;
  if (above == kNone) {
    root_[tree] = kNone;
  } else {
    nodes_[above].child[nodes_[above].child[1] == t ? 1 : 0] = kNone;
  }
  set_offer(node, 0, kNoObject, kNoObject);
  set_offer(node, 1, kNoObject, kNoObject);
  node = TreapNode{};
  free_.push_back(t);
  renew_upwards(above);
}

// ---- the tree over places

// The inner nodes above a leaf, from the root.
std::vector<OctantPairs::Step> OctantPairs::way_to(std::uint32_t place) const {
  std::vector<Step> way;
  std::size_t tree = 1;
  std::uint32_t begin = 0, end = static_cast<std::uint32_t>(size_);
  while (end - begin > 1) {
    const std::uint32_t middle = begin + (end - begin) / 2;
    way.push_back({tree, middle});
    const bool right = place >= middle;
    (right ? begin : end) = middle;
    tree = 2 * tree + (right ? 1 : 0);
  }
  return way;
}

void OctantPairs::build(std::span<const ObjectId> points) {
  for (TreapNode& node : nodes_) {
    set_offer(node, 0, kNoObject, kNoObject);
    set_offer(node, 1, kNoObject, kNoObject);
  }
  nodes_.clear();
  free_.clear();
  size_ = points.size();
  std::size_t depth = 0;
  while ((std::size_t{1} << depth) < size_) ++depth;
  root_.assign(std::size_t{2} << depth, kNone);
  node_of_.assign(depth, std::vector<Node>(objects_, kNone));
  for (const ObjectId object : points) {
    const std::uint32_t place = alpha_.place(object, size_);
    std::size_t level = 0;
    for (const Step& step : way_to(place)) {
      insert(step.tree, level++, object, place < step.middle);
    }
  }
}

// ---- two neighbours that have changed places

// Below the node at which they part each takes the other's place; at it they change their roles.
void OctantPairs::alpha_changed(ObjectId a, ObjectId b) {
  if (alpha_.before(b, a)) std::swap(a, b);  // a is in front now
  const std::uint32_t front = alpha_.place(a, size_);
  const std::vector<Step> left = way_to(front), right = way_to(front + 1);
  std::size_t parting = 0;
  while (left[parting].middle != front + 1) ++parting;
  for (std::size_t level = parting + 1; level < left.size(); ++level) {
    erase(left[level].tree, level, b);
  }
  for (std::size_t level = parting + 1; level < right.size(); ++level) {
    erase(right[level].tree, level, a);
  }
  for (std::size_t level = parting + 1; level < left.size(); ++level) {
    insert(left[level].tree, level, a, front < left[level].middle);
  }
  for (std::size_t level = parting + 1; level < right.size(); ++level) {
    insert(right[level].tree, level, b, front + 1 < right[level].middle);
  }
  nodes_[node_of(parting, a)].looks = true;
  nodes_[node_of(parting, b)].looks = false;
  renew_upwards(node_of(parting, a));
  renew_upwards(node_of(parting, b));
}

// In every treap that has both they are neighbours: they change nodes.
void OctantPairs::beta_changed(ObjectId a, ObjectId b) {
  const std::vector<Step> one = way_to(alpha_.place(a, size_));
  const std::vector<Step> other = way_to(alpha_.place(b, size_));
  for (std::size_t level = 0; level < std::min(one.size(), other.size()); ++level) {
    if (one[level].tree != other[level].tree) return;
    const Node s = node_of(level, a), t = node_of(level, b);
    std::swap(nodes_[s].object, nodes_[t].object);
    std::swap(nodes_[s].looks, nodes_[t].looks);
    std::swap(node_of(level, a), node_of(level, b));
    renew_upwards(s);
    renew_upwards(t);
  }
}

void OctantPairs::projection_changed(ObjectId a, ObjectId b) {
  const std::vector<Step> one = way_to(alpha_.place(a, size_));
  const std::vector<Step> other = way_to(alpha_.place(b, size_));
  for (std::size_t level = 0; level < std::min(one.size(), other.size()); ++level) {
    if (one[level].tree != other[level].tree) return;
    const Node s = node_of(level, a), t = node_of(level, b);
    if (nodes_[s].looks != nodes_[t].looks) return;  // they part here
    renew_upwards(s);
    renew_upwards(t);
  }
}

// ---- checks

void OctantPairs::check_subtree(Node t, Node parent, std::vector<ObjectId>& order,
                                AuditReport& report) const {
  if (t == kNone) return;
  const TreapNode& node = nodes_[t];
  report.check(node.parent == parent, [] { return "a broken link in a treap"; });
  const std::size_t begin = order.size();
  check_subtree(node.child[0], t, order, report);
  const std::size_t own = order.size();
  order.push_back(node.object);
  check_subtree(node.child[1], t, order, report);
  const auto looks = [&](ObjectId object) {
    for (const auto& level : node_of_) {
      if (level[object] == kNone) continue;
      Node top = level[object];
      while (nodes_[top].parent != kNone) top = nodes_[top].parent;
      Node mine = t;
      while (nodes_[mine].parent != kNone) mine = nodes_[mine].parent;
      if (top == mine) return nodes_[level[object]].looks;
    }
    return false;
  };
  ObjectId last = kNoObject, first = kNoObject, before = kNoObject, after = kNoObject;
  for (std::size_t i = begin; i < order.size(); ++i) {
    if (looks(order[i])) {
      last = later(last, order[i]);
      if (i < own) before = later(before, order[i]);
    } else {
      first = earlier(first, order[i]);
      if (i >= own) after = earlier(after, order[i]);
    }
  }
  report.check(node.last == last && node.first == first,
               [] { return "a wrong aggregate in a treap"; });
  Pair offer{kNoObject, kNoObject};
  if (before != kNoObject && after != kNoObject) {
    offer = {std::min(before, after), std::max(before, after)};
  }
  report.check(node.offers[0] == offer, [] { return "a wrong offer"; });
}

void OctantPairs::check(AuditReport& report) const {
  for (const Node root : root_) {
    std::vector<ObjectId> order;
    check_subtree(root, kNone, order, report);
    for (std::size_t i = 1; i < order.size(); ++i) {
      report.check(beta_.before(order[i - 1], order[i]), [] { return "a treap in another order"; });
    }
  }
}

std::size_t OctantPairs::bytes() const {
  std::size_t total = root_.capacity() * sizeof(Node) + nodes_.capacity() * sizeof(TreapNode) +
                      free_.capacity() * sizeof(Node);
  for (const auto& level : node_of_) total += level.capacity() * sizeof(Node);
  return total;
}

}  // namespace kinex
