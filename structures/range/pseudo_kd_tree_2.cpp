// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/range/pseudo_kd_tree_2.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace kinex {

// ---- balance

// The most points on one side of a balanced node of s >= 2.
std::uint64_t PseudoKdTree2::largest_side(std::uint64_t s) const {
  const std::uint64_t excess = std::max<std::uint64_t>(1, 2 * delta_ * s / kUnit);
  return std::min((s + excess) / 2, s - 1);
}

bool PseudoKdTree2::is_balanced(const Node& node) const {
  const std::uint64_t first = size(node.below[0]);
  return std::max(first, node.size - first) <= largest_side(node.size);
}

std::uint64_t PseudoKdTree2::most_depth() const {
  std::uint64_t depth = 0;
  for (std::uint64_t s = labels(0).count(); s > 1; s = largest_side(s)) ++depth;
  return depth;
}

// One walk to the lowest common node, two up, two down and four for balance. For a while a leaf can
// be two levels deeper than in a balanced tree.
std::uint64_t PseudoKdTree2::most_touched() const { return 9 * (most_depth() + 2); }

// A vertical line crosses one side of a node that splits in x, and both of one that splits in y. A
// box has two lines of each kind, and a node that a line crosses has two children. There are no more
// than n nodes of one level, and 2n - 1 of all.
std::uint64_t PseudoKdTree2::most_looked_at(std::uint64_t k) const {
  std::vector<std::uint64_t> sizes;
  const std::uint64_t n = labels(0).count();
  for (std::uint64_t s = n; s > 1; s = largest_side(s)) sizes.push_back(s);
  std::uint64_t crossed = 0;
  for (const int vertical : {0, 1}) {
    std::uint64_t at_level = 1;
    for (std::size_t level = 0; level < sizes.size(); ++level) {
      crossed += 2 * at_level;
      if (static_cast<int>(level % 2) != vertical) at_level = std::min(2 * at_level, n);
    }
    crossed += 2 * at_level;
  }
  return std::min(2 * crossed + 2 * k + 1, 2 * n + 1);
}

// ---- the tree

PseudoKdTree2::Ref PseudoKdTree2::new_node(const Node& node) {
  if (free_.empty()) {
    nodes_.push_back(node);
    return kInner + static_cast<Ref>(nodes_.size() - 1);
  }
  const Ref fresh = free_.back();
  free_.pop_back();
  this->node(fresh) = node;
  return fresh;
}

void PseudoKdTree2::replace_below(Ref above, Ref old, Ref fresh) {
  if (above == kNone) {
    root_ = fresh;
  } else {
    auto& below = node(above).below;
    below[below[0] == old ? 0 : 1] = fresh;
  }
}

// A balanced tree of these objects; `objects` is put in another order.
PseudoKdTree2::Ref PseudoKdTree2::subtree(std::span<ObjectId> objects, int axis, Ref above) {
  if (objects.size() == 1) {
    above_leaf_[objects[0]] = above;
    return objects[0];
  }
  const std::size_t half = (objects.size() + 1) / 2;
  const auto middle = objects.begin() + static_cast<std::ptrdiff_t>(half - 1);
  std::nth_element(objects.begin(), middle, objects.end(), [this, axis](ObjectId a, ObjectId b) {
    return label(axis, a) < label(axis, b);
  });
  const Ref made =
      new_node({label(axis, *middle), axis, static_cast<std::uint32_t>(objects.size()), above, {}});
  const Ref first = subtree(objects.first(half), 1 - axis, made);
  const Ref second = subtree(objects.subspan(half), 1 - axis, made);
  node(made).below = {first, second};
  return made;
}

void PseudoKdTree2::make_tree() {
  root_ = kNone;
  nodes_.clear();
  free_.clear();
  std::fill(above_leaf_.begin(), above_leaf_.end(), kNone);
  std::vector<ObjectId> objects = labels(0).in_order();
  if (!objects.empty()) root_ = subtree(objects, 0, kNone);
}

void PseudoKdTree2::collect(Ref from, std::vector<ObjectId>& objects) const {
  std::vector<Ref> open{from};
  while (!open.empty()) {
    const Ref at = open.back();
    open.pop_back();
    if (is_leaf(at)) {
      objects.push_back(at);
    } else {
      open.push_back(node(at).below[1]);
      open.push_back(node(at).below[0]);
    }
  }
}

void PseudoKdTree2::rebuild_subtree(Ref at) {
  std::vector<Ref> open{at};
  std::vector<ObjectId> objects;
  collect(at, objects);
  if (is_changing()) changing(objects);
  const int axis = node(at).axis;
  const Ref parent = node(at).above;
  while (!open.empty()) {
    const Ref old = open.back();
    open.pop_back();
    free_.push_back(old);
    for (const Ref below : node(old).below) {
      if (!is_leaf(below)) open.push_back(below);
    }
  }
  replace_below(parent, at, kInner - 1);
  const Ref fresh = subtree(objects, axis, parent);
  replace_below(parent, kInner - 1, fresh);
}

// Rebuilds the highest node from here up that is out of balance.
void PseudoKdTree2::balance_above(Ref at) {
  Ref worst = kNone;
  for (; at != kNone; at = node(at).above) {
    if (!is_balanced(node(at))) worst = at;
    ++touched_;
  }
  if (worst == kNone) return;
  points_rebuilt_ += node(worst).size;
  rebuild_subtree(worst);
}

void PseudoKdTree2::hang(ObjectId object) {
  above_leaf_[object] = kNone;
  if (root_ == kNone) {
    root_ = object;
    return;
  }
  Ref at = root_;
  int axis = 0;
  for (; !is_leaf(at); axis = 1 - axis) {
    Node& there = node(at);
    ++there.size;
    ++touched_;
    at = there.below[label(there.axis, object) <= there.last ? 0 : 1];
  }
  const AxisLabels::Label own = label(axis, object), other = label(axis, at);
  const Ref parent = above_leaf_[at];
  const Ref made = new_node({std::min(own, other), axis, 2, parent, {}});
  node(made).below = own < other ? std::array<Ref, 2>{object, at} : std::array<Ref, 2>{at, object};
  replace_below(parent, at, made);
  above_leaf_[at] = above_leaf_[object] = made;
}

// The node above the one that has been removed with the leaf. Its subtree of two points and more
// that moves up by a level is rebuilt, to split along the right axes.
PseudoKdTree2::Ref PseudoKdTree2::unhang(ObjectId object) {
  const Ref parent = above_leaf_[object];
  above_leaf_[object] = kNone;
  if (parent == kNone) {
    root_ = kNone;
    return kNone;
  }
  const Ref sibling = node(parent).below[node(parent).below[0] == object ? 1 : 0];
  const Ref grandparent = node(parent).above;
  const int axis = node(parent).axis;
  replace_below(grandparent, parent, sibling);
  above(sibling) = grandparent;
  free_.push_back(parent);
  for (Ref at = grandparent; at != kNone; at = node(at).above) {
    --node(at).size;
    ++touched_;
  }
  if (!is_leaf(sibling)) {
    node(sibling).axis = axis;
    rebuild_subtree(sibling);
  }
  return grandparent;
}

void PseudoKdTree2::put_in(ObjectId object) {
  hang(object);
  balance_above(above_leaf_[object]);
}

void PseudoKdTree2::take_out(ObjectId object) { balance_above(unhang(object)); }

// A leaf below the node that goes with this leaf.
ObjectId PseudoKdTree2::beside(ObjectId leaf) const {
  const Node& parent = node(above_leaf_[leaf]);
  Ref at = parent.below[parent.below[0] == leaf ? 1 : 0];
  while (!is_leaf(at)) at = node(at).below[0];
  return at;
}

// Two points exchange labels, and no node below `meet` holds both: the splits next to their labels
// move with them.
void PseudoKdTree2::move_splits(int axis, ObjectId before, ObjectId after, Ref meet) {
  const AxisLabels::Label smaller = label(axis, before), larger = label(axis, after);
  for (Ref at = above_leaf_[before]; at != meet; at = node(at).above) {
    Node& there = node(at);
    ++touched_;
    if (there.axis == axis && smaller <= there.last && there.last < larger) there.last = larger;
  }
  // Another point is on the first side, with a label below `smaller`.
  for (Ref at = above_leaf_[after]; at != meet; at = node(at).above) {
    Node& there = node(at);
    ++touched_;
    if (there.axis == axis && smaller <= there.last && there.last < larger) {
      there.last = smaller - 1;
    }
  }
}

std::uint64_t PseudoKdTree2::exchange(int axis, ObjectId before, ObjectId after) {
  touched_ = 0;
  // The lowest node that holds both: from the leaf of one upwards, by the sides of the other.
  std::vector<Ref> path;
  for (Ref at = above_leaf_[before]; at != kNone; at = node(at).above) path.push_back(at);
  Ref meet = root_;
  for (; !path.empty(); path.pop_back()) {
    const Node& there = node(path.back());
    ++touched_;
    meet = path.back();
    const bool first = label(there.axis, before) <= there.last;
    if (first != (label(there.axis, after) <= there.last)) break;
  }
  if (node(meet).axis != axis) {
    move_splits(axis, before, after, meet);
    labels_of(axis).exchange(before, after);
    return touched_;
  }
  changing(std::array{before, after});
  const ObjectId beside_before = beside(before), beside_after = beside(after);
  unhang(before);
  unhang(after);
  labels_of(axis).exchange(before, after);
  hang(before);
  hang(after);
  for (const ObjectId leaf : {before, after, beside_before, beside_after}) {
    balance_above(above_leaf_[leaf]);
  }
  return touched_;
}

// ---- search

// A split cuts off one side of each half; the other three are those of the node.
PseudoKdTree2::Cost PseudoKdTree2::search(const LabelBox& box, std::vector<ObjectId>& out,
                                          QueryTrace* trace) const {
  const auto halves = [this, &box](const Part& above) -> std::array<Part, 2> {
    const Node& there = node(above.ref);
    if (above.sides == kAllSides) {
      return {Part{there.below[0], kAllSides}, Part{there.below[1], kAllSides}};
    }
    const auto a = static_cast<std::size_t>(there.axis);
    Sides first = above.sides, second = above.sides;
    if (there.last <= box.high[a]) first |= side_bit(a, true);
    if (there.last < box.low[a]) first = kOutside;
    if (box.low[a] <= there.last + 1) second |= side_bit(a, false);
    if (box.high[a] <= there.last) second = kOutside;
    return {Part{there.below[0], first}, Part{there.below[1], second}};
  };
  const auto most = static_cast<AxisLabels::Label>(labels(0).size() - 1);
  Sides sides = 0;
  for (const std::size_t a : {0, 1}) {
    if (box.low[a] == 0) sides |= side_bit(a, false);
    if (most <= box.high[a]) sides |= side_bit(a, true);
  }
  return search_parts({root_, sides}, box, out, trace, halves);
}

ObjectId PseudoKdTree2::leaf_before(ObjectId leaf) const {
  Ref from = leaf, at = above_leaf_[leaf];
  for (; at != kNone && node(at).below[0] == from; at = node(at).above) from = at;
  if (at == kNone) return kNoObject;
  for (at = node(at).below[0]; !is_leaf(at);) at = node(at).below[1];
  return at;
}

std::vector<ObjectId> PseudoKdTree2::leaves() const {
  std::vector<ObjectId> result;
  if (root_ != kNone) collect(root_, result);
  return result;
}

// ---- checks

std::vector<BoundCheck> PseudoKdTree2::bounds(const BoundContext& context) const {
  std::vector<BoundCheck> result = LeafTree2::bounds(context);
  std::uint64_t depth = 0;
  for (const ObjectId leaf : leaves()) {
    std::uint64_t above = 0;
    for (Ref at = above_leaf_[leaf]; at != kNone; at = node(at).above) ++above;
    depth = std::max(depth, above);
  }
  result.push_back(at_most("pseudo_kd_tree_2.depth", "no side has more than 1/2 + delta of a node",
                           counted(most_depth()), counted(depth)));
  return result;
}

void PseudoKdTree2::check_tree(AuditReport& report) const {
  std::vector<ObjectId> found = leaves(), expected = labels(0).in_order();
  std::sort(found.begin(), found.end());
  std::sort(expected.begin(), expected.end());
  report.check(found == expected, [] { return "the leaves are other points"; });
  std::vector<std::pair<Ref, int>> open;
  if (root_ != kNone) open.emplace_back(root_, 0);
  std::size_t inner = 0;
  while (!open.empty()) {
    const auto [at, axis] = open.back();
    open.pop_back();
    if (is_leaf(at)) continue;
    ++inner;
    const Node& there = node(at);
    report.check(there.axis == axis, [] { return "a node splits along the wrong axis"; });
    report.check(there.size == size(there.below[0]) + size(there.below[1]),
                 [] { return "a node has another size"; });
    report.check(is_balanced(there), [] { return "a node is out of balance"; });
    for (const std::size_t place : {0, 1}) {
      const Ref below = there.below[place];
      report.check((is_leaf(below) ? above_leaf_[below] : node(below).above) == at,
                   [] { return "a node has another one above"; });
      std::vector<ObjectId> side;
      collect(below, side);
      for (const ObjectId object : side) {
        report.check((label(axis, object) <= there.last) == (place == 0),
                     [&] { return "object " + std::to_string(object) + " is on the wrong side"; });
      }
      open.emplace_back(below, 1 - axis);
    }
  }
  report.check(inner + free_.size() == nodes_.size(), [] { return "a node is lost"; });
}

}  // namespace kinex
