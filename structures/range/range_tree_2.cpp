// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/range/range_tree_2.h"

#include <algorithm>
#include <string>
#include <utility>

namespace kinex {

RangeTree2::RangeTree2(Kernel& kernel, StructureId id, const SortedList& x, const SortedList& y)
    : RangeStructure(kernel, id, x, y) {}

void RangeTree2::make_tree() {
  const unsigned bits = labels(0).bits();
  levels_.clear();
  levels_.resize(bits);
  places_.assign(bits, std::vector<Place>(labels(0).objects(), OrderTree::kNone));
  stored_ = 0;
  const std::vector<ObjectId> by_y = labels(1).in_order();
  for (std::size_t level = 1; level <= bits; ++level) {
    levels_[level - 1].resize(labels(0).size() >> level);
    for (const ObjectId object : by_y) {
      Node& there = node(level, interval(level, object));
      place(level, object) = static_cast<Place>(there.at.size());
      there.at.push_back(object);
    }
    for (Node& there : levels_[level - 1]) {
      std::vector<Place> places(there.at.size());
      for (Place p = 0; p < places.size(); ++p) places[p] = p;
      there.order.build(places);
    }
  }
  stored_ = by_y.size() * bits;
  most_stored_ = std::max(most_stored_, stored_);
}

void RangeTree2::add(std::size_t level, Node& node, ObjectId object) {
  Place before = OrderTree::kNone;
  for (Place p = node.order.root(); p != OrderTree::kNone;) {
    if (label(1, node.at[p]) < label(1, object)) {
      before = p;
      p = node.order.right(p);
    } else {
      p = node.order.left(p);
    }
  }
  Place own;
  if (node.free.empty()) {
    own = static_cast<Place>(node.at.size());
    node.at.push_back(object);
  } else {
    own = node.free.back();
    node.free.pop_back();
    node.at[own] = object;
  }
  node.order.insert_after(before, own);
  place(level, object) = own;
}

void RangeTree2::remove(std::size_t level, Node& node, ObjectId object) {
  const Place own = place(level, object);
  node.order.erase(own);
  node.at[own] = kNoObject;
  node.free.push_back(own);
  place(level, object) = OrderTree::kNone;
}

void RangeTree2::put_in(ObjectId object) {
  for (std::size_t level = 1; level <= levels_.size(); ++level) {
    add(level, node(level, interval(level, object)), object);
  }
  stored_ += levels_.size();
  most_stored_ = std::max(most_stored_, stored_);
}

void RangeTree2::take_out(ObjectId object) {
  for (std::size_t level = 1; level <= levels_.size(); ++level) {
    remove(level, node(level, interval(level, object)), object);
  }
  stored_ -= levels_.size();
}

std::uint64_t RangeTree2::exchange(int axis, ObjectId before, ObjectId after) {
  std::uint64_t touched = 0;
  for (std::size_t level = 1; level <= levels_.size(); ++level) {
    const std::size_t i = interval(level, before), j = interval(level, after);
    Node& first = node(level, i);
    if (axis == 1 && i == j) {
      ++touched;
      std::swap(first.at[place(level, before)], first.at[place(level, after)]);
      std::swap(place(level, before), place(level, after));
    } else if (axis == 0 && i != j) {
      touched += 2;
      Node& second = node(level, j);
      remove(level, first, before);
      remove(level, second, after);
      add(level, first, after);
      add(level, second, before);
    }
  }
  labels_of(axis).exchange(before, after);
  return touched;
}

// The points of the node that the box holds in y.
void RangeTree2::search_node(const Node& node, const LabelBox& box, std::vector<ObjectId>& out,
                             Cost& cost) const {
  ++cost.bounded;
  ++cost.nodes;
  std::vector<Place> open;
  if (!node.order.empty()) open.push_back(node.order.root());
  while (!open.empty()) {
    const Place p = open.back();
    open.pop_back();
    ++cost.nodes;
    const AxisLabels::Label y = label(1, node.at[p]);
    if (box.holds(1, y)) out.push_back(node.at[p]);
    const Place left = node.order.left(p), right = node.order.right(p);
    if (left != OrderTree::kNone && box.low[1] < y) open.push_back(left);
    if (right != OrderTree::kNone && y < box.high[1]) open.push_back(right);
  }
}

std::vector<ObjectId> RangeTree2::objects_of(const Node& node) {
  std::vector<ObjectId> result;
  for (const ObjectId object : node.at) {
    if (object != kNoObject) result.push_back(object);
  }
  return result;
}

// The largest dyadic intervals in the range of x, from both ends inwards.
RangeTree2::Cost RangeTree2::search(const LabelBox& box, std::vector<ObjectId>& out,
                                    QueryTrace* trace) const {
  Cost cost;
  std::size_t first = box.low[0], end = box.high[0] + std::size_t{1};
  const auto look_at = [&](std::size_t level, std::size_t interval) {
    if (level > 0) {
      const Node& there = levels_[level - 1][interval];
      if (trace != nullptr) trace->push_back({NodePlace::kCrossed, objects_of(there)});
      return search_node(there, box, out, cost);
    }
    ++cost.bounded;
    ++cost.nodes;
    const ObjectId object = labels(0).at(static_cast<AxisLabels::Label>(interval));
    if (object == kNoObject) return;
    const bool holds = box.holds(1, label(1, object));
    if (holds) out.push_back(object);
    if (trace == nullptr) return;
    trace->push_back({holds ? NodePlace::kInside : NodePlace::kOutside, {object}});
  };
  for (std::size_t level = 0; first < end; ++level, first /= 2, end /= 2) {
    if (first % 2 == 1) look_at(level, first++);
    if (end % 2 == 1) look_at(level, --end);
  }
  return cost;
}

Attribute RangeTree2::attribute() const {
  Attribute result{Attribute::Shape::kSequence, labels(0).in_order()};
  const std::vector<ObjectId> by_y = labels(1).in_order();
  result.ids.insert(result.ids.end(), by_y.begin(), by_y.end());
  return result;
}

void RangeTree2::swapped(int axis, ObjectId before, ObjectId after) {
  kernel_->report(id_, axis == 0 ? kSwapX : kSwapY, {before, after}, true);
}

void RangeTree2::follow_rebuild() {
  const Attribute before = attribute();
  make_anew();
  kernel_->report_settled(id_, before.ids, attribute().ids);
}

std::vector<BoundCheck> RangeTree2::bounds(const BoundContext& context) const {
  std::vector<BoundCheck> result = RangeStructure::bounds(context);
  if (context.plain()) {
    const std::size_t n = context.objects();
    result.push_back(at_most("range_tree_2.space", "n points on each of the log2 N levels",
                             counted(n * AxisLabels::bits_for(n)), counted(most_stored_)));
  }
  return result;
}

void RangeTree2::check_tree(AuditReport& report) const {
  for (std::size_t level = 1; level <= levels_.size(); ++level) {
    std::vector<std::vector<ObjectId>> expected(levels_[level - 1].size());
    for (const ObjectId object : labels(1).in_order()) {
      expected[interval(level, object)].push_back(object);
    }
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const Node& there = levels_[level - 1][i];
      std::vector<ObjectId> found;
      for (const Place p : there.order.in_order()) {
        found.push_back(there.at[p]);
        report.check(places_[level - 1][there.at[p]] == p,
                     [] { return "a point has lost its place"; });
      }
      report.check(found == expected[i] && there.order.consistent(), [&] {
        return "node " + std::to_string(i) + " of level " + std::to_string(level) +
               " holds other points, or in another order";
      });
    }
  }
}

std::size_t RangeTree2::bytes() const {
  std::size_t sum = RangeStructure::bytes();
  for (const auto& level : levels_) {
    sum += level.capacity() * sizeof(Node);
    for (const Node& node : level) {
      sum += node.order.bytes() + node.at.capacity() * sizeof(ObjectId) +
             node.free.capacity() * sizeof(Place);
    }
  }
  for (const auto& places : places_) sum += places.capacity() * sizeof(Place);
  return sum;
}

}  // namespace kinex
