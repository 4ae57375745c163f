// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/maximum/line_hull.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "predicates/predicates.h"

namespace kinex {

LineOrder::LineOrder(Kernel& kernel, const Contest& contest, int dimension)
    : kernel_(&kernel),
      contest_(&contest),
      mirrored_(contest.extremum() == Extremum::kMinimum),
      slope_order_(kernel.bind(make_line_slope_order(contest.order().key(), dimension))),
      turn_(kernel.bind(make_line_turn(contest.order().key(), dimension))),
      meeting_(kernel.bind(make_line_meeting(contest.order().key(), dimension))) {}

Sign LineOrder::slopes(ObjectId a, ObjectId b) const {
  return mirrored_ ? kernel_->sign_after(slope_order_, {b, a})
                   : kernel_->sign_after(slope_order_, {a, b});
}

// Mirroring in a point changes no turn.
bool LineOrder::above(ObjectId a, ObjectId b, ObjectId c) const {
  return kernel_->sign_after(turn_, {a, b, c}) != Sign::kNegative;
}

bool LineOrder::meets_before(ObjectId a, ObjectId b, ObjectId c, ObjectId d, ObjectId e) const {
  const Sign above = mirrored_ ? kernel_->sign_after(meeting_, {c, d, a, b, e})
                               : kernel_->sign_after(meeting_, {a, b, c, d, e});
  return above == Sign::kPositive;
}

// ---- nodes

LineHull::Place LineHull::new_node() {
  if (free_.empty()) {
    free_.push_back(static_cast<Place>(nodes_.size()));
    nodes_.emplace_back();
    groups_.emplace_back();
  }
  const Place p = free_.back();
  free_.pop_back();
  return p;
}

void LineHull::free_node(Place p) {
  nodes_[p] = Node();
  groups_[p].clear();
  free_.push_back(p);
}

LineHull::Place LineHull::new_leaf(ObjectId object) {
  const Place leaf = new_node();
  Node& node = nodes_[leaf];
  node.bridge = {leaf, leaf};
  node.first = leaf;
  node.leaves = 1;
  groups_[leaf].push_back(object);
  leaf_of_[object] = leaf;
  return leaf;
}

void LineHull::put_in_place_of(Place old, Place fresh) {
  const Place parent = nodes_[old].parent;
  nodes_[fresh].parent = parent;
  if (parent == kNone) {
    root_ = fresh;
  } else {
    std::array<Place, 2>& child = nodes_[parent].child;
    child[child[0] == old ? 0 : 1] = fresh;
  }
}

// ---- building

// By slope; among equal slopes the best one first. A merge sort ends even where rounding errors
// make the comparisons no order.
void LineHull::sort(std::vector<ObjectId>& members) const {
  std::stable_sort(members.begin(), members.end(), [this](ObjectId a, ObjectId b) {
    const Sign sign = order_->slopes(a, b);
    return sign == Sign::kZero ? order_->beats(a, b) : sign == Sign::kPositive;
  });
}

void LineHull::build(std::vector<ObjectId> members) {
  nodes_.clear();
  groups_.clear();
  free_.clear();
  std::fill(leaf_of_.begin(), leaf_of_.end(), kNone);
  root_ = kNone;
  size_ = members.size();
  sort(members);
  std::vector<Place> leaves;
  for (const ObjectId object : members) {
    if (!leaves.empty() && order_->slopes(line(leaves.back()), object) == Sign::kZero) {
      groups_[leaves.back()].push_back(object);
      leaf_of_[object] = leaves.back();
    } else {
      leaves.push_back(new_leaf(object));
    }
  }
  if (!leaves.empty()) root_ = build_tree(leaves);
}

// Requires at least one leaf. Bridges of leaves are kept; all inner nodes are new.
LineHull::Place LineHull::build_tree(std::span<const Place> leaves) {
  if (leaves.size() == 1) {
    nodes_[leaves[0]].parent = kNone;
    return leaves[0];
  }
  const std::size_t half = leaves.size() / 2;
  const Place left = build_tree(leaves.first(half)), right = build_tree(leaves.subspan(half));
  const Place p = new_node();
  nodes_[p].child = {left, right};
  nodes_[p].parent = kNone;
  nodes_[left].parent = nodes_[right].parent = p;
  refresh(p);
  return p;
}

// Computes an inner node from its children.
void LineHull::refresh(Place p) {
  const auto [left, right] = nodes_[p].child;
  nodes_[p].first = nodes_[left].first;
  nodes_[p].leaves = nodes_[left].leaves + nodes_[right].leaves;
  find_bridge(p);
}

// Descends in the left half, u, and in the right one, w, along their bridges (p1, p2) and (q1, q2),
// or points.
//   - If something of w is on or above the line p1 p2, the bridge is at least as steep and begins
//     in the left part of u; if nothing is, and w is a point, it begins in the right part of u. The
//     same, mirrored, for w.
//   - Otherwise the lines p1 p2 and q1 q2 meet; on the side of the gap between u and w where they
//     do not, the bridge cannot lie beyond both.
void LineHull::find_bridge(Place p) {
  auto [u, w] = nodes_[p].child;
  const ObjectId gap = line(nodes_[w].first);
  while (!is_leaf(u) || !is_leaf(w)) {
    const ObjectId p1 = line(nodes_[u].bridge[0]), p2 = line(nodes_[u].bridge[1]);
    const ObjectId q1 = line(nodes_[w].bridge[0]), q2 = line(nodes_[w].bridge[1]);
    if (!is_leaf(u) && (order_->above(p1, p2, q1) || (q1 != q2 && order_->above(p1, p2, q2)))) {
      u = nodes_[u].child[0];
    } else if (!is_leaf(w) &&
               (order_->above(q1, q2, p2) || (p1 != p2 && order_->above(q1, q2, p1)))) {
      w = nodes_[w].child[1];
    } else if (is_leaf(w) || (!is_leaf(u) && order_->meets_before(p1, p2, q1, q2, gap))) {
      u = nodes_[u].child[1];
    } else {
      w = nodes_[w].child[0];
    }
  }
  nodes_[p].bridge = {u, w};
}

// All ancestors of these leaves, children first.
void LineHull::refresh_above(const std::vector<Place>& leaves) {
  std::vector<std::pair<std::size_t, Place>> stale;  // by height above the lowest: depth
  for (const Place leaf : leaves) {
    if (nodes_[leaf].leaves == 0) continue;
    std::size_t depth = 0;
    for (Place p = nodes_[leaf].parent; p != kNone; p = nodes_[p].parent) ++depth;
    for (Place p = nodes_[leaf].parent; p != kNone; p = nodes_[p].parent) {
      stale.emplace_back(depth--, p);
    }
  }
  std::sort(stale.begin(), stale.end(), std::greater<>());
  stale.erase(std::unique(stale.begin(), stale.end()), stale.end());
  for (const auto& [depth, p] : stale) refresh(p);
}

// Rebuilds the highest ancestor of which one half has more than 2/3 of the leaves.
void LineHull::rebalance_above(Place leaf) {
  Place tilted = kNone;
  for (Place p = nodes_[leaf].parent; p != kNone; p = nodes_[p].parent) {
    const auto [left, right] = nodes_[p].child;
    const std::uint32_t larger = std::max(nodes_[left].leaves, nodes_[right].leaves);
    if (3 * std::uint64_t{larger} > 2 * std::uint64_t{nodes_[p].leaves} + 2) tilted = p;
  }
  if (tilted == kNone) return;
  std::vector<Place> leaves, open{tilted}, inner;
  while (!open.empty()) {
    const Place p = open.back();
    open.pop_back();
    if (is_leaf(p)) {
      leaves.push_back(p);
      continue;
    }
    inner.push_back(p);
    open.push_back(nodes_[p].child[1]);
    open.push_back(nodes_[p].child[0]);
  }
  const Place above = nodes_[tilted].parent;
  const std::size_t side = above != kNone && nodes_[above].child[1] == tilted ? 1 : 0;
  for (const Place p : inner) free_node(p);
  const Place fresh = build_tree(leaves);
  nodes_[fresh].parent = above;
  (above == kNone ? root_ : nodes_[above].child[side]) = fresh;
}

// ---- changes

// True if the line that counts has changed.
bool LineHull::place_in_group(Place leaf, ObjectId object) {
  std::vector<ObjectId>& group = groups_[leaf];
  const auto place = std::partition_point(
      group.begin(), group.end(), [&](ObjectId other) { return order_->beats(other, object); });
  const bool best = place == group.begin();
  group.insert(place, object);
  leaf_of_[object] = leaf;
  return best;
}

void LineHull::insert(ObjectId object) {
  ++size_;
  if (root_ == kNone) {
    root_ = new_leaf(object);
    return;
  }
  Place p = root_;
  while (!is_leaf(p)) {
    const Place right = nodes_[p].child[1];
    const Sign sign = order_->slopes(line(nodes_[right].first), object);
    p = sign == Sign::kNegative ? nodes_[p].child[0] : right;
  }
  const Sign sign = order_->slopes(line(p), object);
  if (sign == Sign::kZero) {
    if (place_in_group(p, object)) refresh_above({p});
    return;
  }
  const Place leaf = new_leaf(object);
  const Place parent = new_node();
  put_in_place_of(p, parent);
  nodes_[parent].child[0] = sign == Sign::kPositive ? p : leaf;
  nodes_[parent].child[1] = sign == Sign::kPositive ? leaf : p;
  nodes_[p].parent = nodes_[leaf].parent = parent;
  refresh_above({leaf});
  rebalance_above(leaf);
}

// Removes a line. Returns a leaf whose ancestors must be refreshed; kNone: there are none.
LineHull::Place LineHull::detach(ObjectId object) {
  const Place leaf = leaf_of_[object];
  leaf_of_[object] = kNone;
  --size_;
  std::vector<ObjectId>& group = groups_[leaf];
  const auto place = std::find(group.begin(), group.end(), object);
  const bool best = place == group.begin();
  group.erase(place);
  if (!group.empty()) return best ? leaf : kNone;
  const Place parent = nodes_[leaf].parent;
  free_node(leaf);
  if (parent == kNone) {
    root_ = kNone;
    return kNone;
  }
  const auto [left, right] = nodes_[parent].child;
  const Place sibling = left == leaf ? right : left;
  put_in_place_of(parent, sibling);
  free_node(parent);
  Place first = sibling;
  while (!is_leaf(first)) first = nodes_[first].child[0];
  return first;
}

void LineHull::erase(ObjectId object) {
  const Place leaf = detach(object);
  if (leaf == kNone) return;
  refresh_above({leaf});
  rebalance_above(leaf);
}

// All lines leave before the first comes back: no sign may compare old and new lines.
void LineHull::change(std::span<const ObjectId> objects) {
  std::vector<Place> leaves;
  for (const ObjectId object : objects) {
    const Place leaf = detach(object);
    if (leaf != kNone) leaves.push_back(leaf);
  }
  refresh_above(leaves);
  for (const Place leaf : leaves) {
    if (nodes_[leaf].leaves != 0) rebalance_above(leaf);
  }
  for (const ObjectId object : objects) insert(object);
}

// ---- answers

std::vector<ObjectId> LineHull::members() const {
  std::vector<ObjectId> result;
  for (ObjectId object = 0; object < leaf_of_.size(); ++object) {
    if (leaf_of_[object] != kNone) result.push_back(object);
  }
  return result;
}

// The better of the two ends of a bridge decides which half to search.
ObjectId LineHull::best() const {
  Place p = root_;
  while (!is_leaf(p)) {
    const ObjectId left = line(nodes_[p].bridge[0]), right = line(nodes_[p].bridge[1]);
    p = nodes_[p].child[order_->beats(right, left) ? 1 : 0];
  }
  return line(p);
}

// Among the vertices of ever larger hulls: a bridge that begins here leads to the next one.
ObjectId LineHull::next(ObjectId object) const {
  const Place leaf = leaf_of_[object];
  Place result = kNone;
  for (Place p = leaf; nodes_[p].parent != kNone; p = nodes_[p].parent) {
    const Node& parent = nodes_[nodes_[p].parent];
    if (parent.child[0] == p && parent.bridge[0] == leaf) result = parent.bridge[1];
  }
  return result == kNone ? kNoObject : line(result);
}

std::vector<ObjectId> LineHull::vertices() const {
  std::vector<ObjectId> result;
  if (root_ == kNone) return result;
  // The first vertex: the leftmost leaf of all, which has the smallest slope.
  for (ObjectId v = line(nodes_[root_].first); v != kNoObject; v = next(v)) result.push_back(v);
  return result;
}

std::size_t LineHull::height() const {
  std::size_t height = 0;
  for (Place p = 0; p < nodes_.size(); ++p) {
    if (nodes_[p].leaves != 1) continue;
    std::size_t depth = 0;
    for (Place q = nodes_[p].parent; q != kNone; q = nodes_[q].parent) ++depth;
    height = std::max(height, depth);
  }
  return height;
}

std::string LineHull::complaint() const {
  std::size_t found = 0;
  for (Place p = 0; p < nodes_.size(); ++p) {
    const Node& node = nodes_[p];
    if (node.leaves == 0) continue;
    const std::string where = " at node " + std::to_string(p);
    if (node.parent == kNone && p != root_) return "a second root" + where;
    if (is_leaf(p)) {
      if (groups_[p].empty()) return "an empty leaf" + where;
      for (const ObjectId object : groups_[p]) {
        if (leaf_of_[object] != p) return "a lost object" + where;
      }
      found += groups_[p].size();
      continue;
    }
    const auto [left, right] = node.child;
    if (nodes_[left].parent != p || nodes_[right].parent != p) return "a broken link" + where;
    if (node.leaves != nodes_[left].leaves + nodes_[right].leaves ||
        node.first != nodes_[left].first) {
      return "a stale node" + where;
    }
    for (const std::size_t side : {0u, 1u}) {
      const Place end = node.bridge[side];
      if (nodes_[end].leaves != 1 || !is_leaf(end)) return "a bridge to nowhere" + where;
      Place q = end;
      while (q != root_ && q != node.child[side]) q = nodes_[q].parent;
      if (q != node.child[side]) return "a bridge that ends elsewhere" + where;
    }
  }
  return found == size_ ? "" : "a wrong number of objects";
}

std::size_t LineHull::bytes() const {
  std::size_t total = nodes_.capacity() * sizeof(Node) + groups_.capacity() * sizeof(groups_[0]) +
                      (free_.capacity() + leaf_of_.capacity()) * sizeof(Place);
  for (const auto& group : groups_) total += group.capacity() * sizeof(ObjectId);
  return total;
}

}  // namespace kinex
