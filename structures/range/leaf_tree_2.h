// SPDX-License-Identifier: GPL-3.0-or-later
// LeafTree2: what kinetic kd-trees share: their attribute and its events.
//
// Attribute: the points in the order of the leaves, depth first. Most swaps of the lists leave the
// tree as it is. One external event, "settled", for each instant that changes the order, with the
// whole order before and after: O(n) for its report.
#ifndef KINEX_STRUCTURES_RANGE_LEAF_TREE_2_H
#define KINEX_STRUCTURES_RANGE_LEAF_TREE_2_H

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

}  // namespace kinex

#endif
