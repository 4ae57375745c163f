// SPDX-License-Identifier: GPL-3.0-or-later
// LeafTree2: what kinetic kd-trees share: their attribute and its events.
//
// Attribute: the points in the order of the leaves, depth first. Most swaps of the lists leave the
// tree as it is. One external event, "settled", for each instant that changes the order, with the
// whole order before and after: O(n) for its report.
#ifndef KINEX_STRUCTURES_RANGE_LEAF_TREE_2_H
#define KINEX_STRUCTURES_RANGE_LEAF_TREE_2_H

#include <array>
#include <utility>
#include <vector>

#include "structures/range/range_structure.h"

namespace kinex {

class LeafTree2 : public RangeStructure {
 public:
  std::vector<std::string_view> event_kinds() const override { return common_event_kinds({}); }
  void rebuild() override {
    RangeStructure::rebuild();
    is_changing_ = false;
  }
  void instant_over() override;
  Attribute attribute() const override { return {Attribute::Shape::kSequence, leaves()}; }
  Attribute told() const override {
    return {Attribute::Shape::kSequence, is_changing_ ? before_ : leaves()};
  }
  std::size_t bytes() const override {
    return RangeStructure::bytes() + before_.capacity() * sizeof(ObjectId);
  }

 protected:
  using RangeStructure::RangeStructure;

  // A reference to a node of the tree: an object (a leaf), or an inner node.
  using Ref = std::uint32_t;
  static constexpr Ref kNone = 0xffffffffu, kInner = 0x80000000u;
  static bool is_leaf(Ref ref) { return ref < kInner; }

  virtual std::vector<ObjectId> leaves() const = 0;  // depth first. O(n)
  // The tree is about to change.
  void changing();

  // A node and its cell; the cell of a leaf is not used.
  struct Part {
    Ref ref = kNone;
    LabelBox cell{};
  };
  // The search of all kd-trees: skips cells outside the box, reports those inside it. halves(part,
  // needs_cells) are the two parts of an inner node.
  template <class Halves>
  Cost search_cells(const Part& root, const LabelBox& box, std::vector<ObjectId>& out,
                    QueryTrace* trace, const Halves& halves) const;

 private:
  void swapped(int, ObjectId, ObjectId) override {}
  void follow_rebuild() override {
    changing();
    make_anew();
  }
  void begin() override { is_changing_ = false; }

  bool is_changing_ = false;      // at this instant
  std::vector<ObjectId> before_;  // if so, the leaves before it
};

template <class Halves>
LeafTree2::Cost LeafTree2::search_cells(const Part& root, const LabelBox& box,
                                        std::vector<ObjectId>& out, QueryTrace* trace,
                                        const Halves& halves) const {
  Cost cost;
  std::vector<std::pair<Part, bool>> open;  // and whether it is known to be inside
  if (root.ref != kNone) open.emplace_back(root, false);
  while (!open.empty()) {
    const auto [part, is_known] = open.back();
    open.pop_back();
    ++cost.nodes;
    NodePlace place = NodePlace::kInside;
    if (!is_known && is_leaf(part.ref)) {
      const bool holds = box.holds(0, label(0, part.ref)) && box.holds(1, label(1, part.ref));
      if (!holds) place = NodePlace::kOutside;
    } else if (!is_known) {
      place = box.place_of(part.cell);
    }
    if (trace != nullptr && !is_known) {
      trace->push_back({place, {}});
      // With a box that holds everything all leaves below are inside.
      const auto most = static_cast<AxisLabels::Label>(labels(0).size() - 1);
      search_cells(part, {{0, 0}, {most, most}}, trace->back().objects, nullptr, halves);
    }
    if (place == NodePlace::kOutside) continue;
    if (is_leaf(part.ref)) {
      out.push_back(part.ref);
      continue;
    }
    const bool is_inside = place == NodePlace::kInside;
    const std::array<Part, 2> below = halves(part, !is_inside);
    open.emplace_back(below[1], is_inside);
    open.emplace_back(below[0], is_inside);
  }
  cost.bounded = cost.nodes;
  return cost;
}

}  // namespace kinex

#endif
