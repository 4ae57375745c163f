// SPDX-License-Identifier: GPL-3.0-or-later
// LeafTree2: what kinetic kd-trees share: their search, and their attribute with its events.
//
// Attribute: the points in the order of the leaves, depth first. Most swaps of the lists leave the
// tree as it is. One external event, "settled", for each instant that changes the order, with the
// whole order before and after: O(n) for its report, in two copies. What changed is found in
// O(depth) for each leaf that the tree has moved.
//
// Search. Of a node it is known beyond which sides of the box it has no points. A node beyond no
// side is inside; its leaves are tested on those axes alone on which they may be outside.
#ifndef KINEX_STRUCTURES_RANGE_LEAF_TREE_2_H
#define KINEX_STRUCTURES_RANGE_LEAF_TREE_2_H

#include <array>
#include <span>
#include <vector>

#include "structures/range/leaf_sequence.h"
#include "structures/range/range_structure.h"

namespace kinex {

class LeafTree2 : public RangeStructure {
 public:
  std::vector<std::string_view> event_kinds() const override { return common_event_kinds({}); }
  void rebuild() override {
    RangeStructure::rebuild();
    begin();
  }
  void instant_over() override;
  Attribute attribute() const override { return {Attribute::Shape::kSequence, leaves()}; }
  Attribute told() const override {
    return {Attribute::Shape::kSequence, is_changing_ ? told_.leaves() : leaves()};
  }
  void check_invariants(AuditReport& report) const override;
  std::size_t bytes() const override { return RangeStructure::bytes() + told_.bytes(); }

 protected:
  LeafTree2(Kernel& kernel, StructureId id, const SortedList& x, const SortedList& y)
      : RangeStructure(kernel, id, x, y), told_(x.objects()) {}

  // A reference to a node of the tree: an object (a leaf), or an inner node.
  using Ref = std::uint32_t;
  static constexpr Ref kNone = 0xffffffffu, kInner = 0x80000000u;
  static bool is_leaf(Ref ref) { return ref < kInner; }

  virtual std::vector<ObjectId> leaves() const = 0;  // depth first. O(n)
  // The leaf in front of this one, depth first; kNoObject: it is the first one. O(depth)
  virtual ObjectId leaf_before(ObjectId leaf) const = 0;
  // The tree is about to change. The leaves that are not named until the instant is over keep their
  // order among themselves.
  void changing(std::span<const ObjectId> leaves);
  void changing_all();
  bool is_changing() const { return is_changing_; }

  // The sides of the box beyond which a node has no points, as bits.
  using Sides = std::uint8_t;
  static constexpr Sides side_bit(std::size_t axis, bool is_high) {
    return static_cast<Sides>(1u << (2 * axis + (is_high ? 1 : 0)));
  }
  static constexpr Sides kAllSides = 15, kOutside = 16;
  struct Part {  // a node
    Ref ref = kNone;
    Sides sides = 0;  // kOutside: it has no points in the box
  };
  // The search of all kd-trees: skips nodes outside the box, reports those inside it. halves(part)
  // are the two nodes below an inner one, with kAllSides if it has all of them itself.
  template <class Halves>
  Cost search_parts(const Part& root, const LabelBox& box, std::vector<ObjectId>& out,
                    QueryTrace* trace, const Halves& halves) const;

 private:
  // A leaf that may be beyond some side.
  bool holds(const LabelBox& box, const Part& leaf) const {
    for (const int axis : {0, 1}) {
      const unsigned both = 3u << (2 * axis);
      if ((leaf.sides & both) != both && !box.holds(axis, label(axis, leaf.ref))) return false;
    }
    return true;
  }
  void swapped(int, ObjectId, ObjectId) override {}
  void follow_rebuild() override {
    changing_all();
    make_anew();
  }
  void begin() override { is_changing_ = is_told_ = false; }

  bool is_changing_ = false;  // at this instant
  bool is_told_ = false;  // told_ is the order that has been reported; always while is_changing_
  LeafSequence told_;
  std::vector<ObjectId> moved_;  // at this instant, the leaves that have been named; a few
  bool all_moved_ = false;       // or all of them
};

template <class Halves>
LeafTree2::Cost LeafTree2::search_parts(const Part& root, const LabelBox& box,
                                        std::vector<ObjectId>& out, QueryTrace* trace,
                                        const Halves& halves) const {
  Cost cost;
  std::vector<Part> open;
  open.reserve(64);
  if (root.ref != kNone) open.push_back(root);
  while (!open.empty()) {
    Part part = open.back();
    open.pop_back();
    ++cost.nodes;
    const bool is_known = part.sides == kAllSides;
    if (!is_known && is_leaf(part.ref)) {
      part.sides = part.sides != kOutside && holds(box, part) ? kAllSides : kOutside;
    }
    if (trace != nullptr && !is_known) {
      const NodePlace place = part.sides == kOutside    ? NodePlace::kOutside
                              : part.sides == kAllSides ? NodePlace::kInside
                                                        : NodePlace::kCrossed;
      trace->push_back({place, {}});
      search_parts({part.ref, kAllSides}, box, trace->back().objects, nullptr, halves);
    }
    if (part.sides == kOutside) continue;
    if (is_leaf(part.ref)) {
      out.push_back(part.ref);
      continue;
    }
    const std::array<Part, 2> below = halves(part);
    for (const std::size_t half : {1, 0}) {
      // A node outside the box is not searched.
      if (below[half].sides == kOutside && trace == nullptr) {
        ++cost.nodes;
      } else {
        open.push_back(below[half]);
      }
    }
  }
  cost.bounded = cost.nodes;
  return cost;
}

}  // namespace kinex

#endif
