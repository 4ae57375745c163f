// SPDX-License-Identifier: GPL-3.0-or-later
// PseudoKdTree2: a kinetic kd-tree of moving points in the plane with splits that are only nearly
// medians: subtrees are rebuilt when they are out of balance.
//
// Certificates. None of its own: it reads the sorted lists of both coordinates. A node splits its
// points by the order of one coordinate, x at the root, then y, and so on: those whose labels
// (range_structure.h) are at most `last`, and the others. If the lowest node that holds both points
// of a swap splits along its axis, they change sides there. If not, the tree stays as it is.
//
//   swap in x of b, c       x: a b | c d         x: a c | b d
//                           y: a|b  y: c|d   ->  y: a|c  y: d|b
//
// Parameter "delta", at least 0 and less than 1/2 (rounded down to a multiple of 2^-30). A node of
// s points is rebuilt, with exact medians, when its first side has more than max(1/2, delta s)
// points more or less than s/2. With delta = 0 it is the textbook's kd-tree.
//
// Quality, for n points: depth at most log n / log(1 / (1/2 + delta)) + O(1). A swap that changes
// the tree costs O(depth), and its rebuilding: for delta > 0 amortised O(log^2 n / delta). A query
// looks at O(n^(1/2 + eps(delta)) + k) nodes for k points reported, eps(0) = 0; the hard bound is
// computed from the recurrences of the two kinds of lines. rank_kd_tree_2 needs no rebuilding.
//
// Ties. As in the lists: points with identically equal coordinates are in the order of their ids.
//
// Source: Agarwal, Gao, Guibas, "Kinetic medians and kd-trees" (2002): pseudo kd-trees.
#ifndef KINEX_STRUCTURES_RANGE_PSEUDO_KD_TREE_2_H
#define KINEX_STRUCTURES_RANGE_PSEUDO_KD_TREE_2_H

#include <array>
#include <span>
#include <vector>

#include "structures/range/leaf_tree_2.h"

namespace kinex {

class PseudoKdTree2 final : public LeafTree2 {
 public:
  // The unit of `delta`.
  static constexpr std::uint64_t kUnit = std::uint64_t{1} << 30;

  // `delta`: in units of 1 / kUnit.
  PseudoKdTree2(Kernel& kernel, StructureId id, const SortedList& x, const SortedList& y,
                std::uint64_t delta)
      : LeafTree2(kernel, id, x, y), delta_(delta), above_leaf_(x.objects(), kNone) {}

  std::string_view name() const override { return "pseudo_kd_tree_2"; }
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  std::size_t bytes() const override {
    return LeafTree2::bytes() + nodes_.capacity() * sizeof(Node) +
           (free_.capacity() + above_leaf_.capacity()) * sizeof(Ref);
  }

  // The sum of the sizes of all subtrees rebuilt for balance.
  std::uint64_t points_rebuilt() const { return points_rebuilt_; }

 private:
  struct Node {
    AxisLabels::Label last = 0;  // the largest label of the first side
    int axis = 0;                // of the split
    std::uint32_t size = 0;      // the number of points
    Ref above = kNone;
    std::array<Ref, 2> below{};
  };

  void make_tree() override;
  void put_in(ObjectId object) override;
  void take_out(ObjectId object) override;
  std::uint64_t exchange(int axis, ObjectId before, ObjectId after) override;
  std::uint64_t most_touched() const override;
  Cost search(const LabelBox& box, std::vector<ObjectId>& out, QueryTrace* trace) const override;
  std::uint64_t most_looked_at(std::uint64_t k) const override;
  void check_tree(AuditReport& report) const override;
  std::vector<ObjectId> leaves() const override;
  ObjectId leaf_before(ObjectId leaf) const override;

  Node& node(Ref ref) { return nodes_[ref - kInner]; }
  const Node& node(Ref ref) const { return nodes_[ref - kInner]; }
  Ref& above(Ref ref) { return is_leaf(ref) ? above_leaf_[ref] : node(ref).above; }
  std::uint64_t size(Ref ref) const { return is_leaf(ref) ? 1 : node(ref).size; }
  Ref new_node(const Node& node);
  void replace_below(Ref above, Ref old, Ref fresh);
  Ref subtree(std::span<ObjectId> objects, int axis, Ref above);
  void collect(Ref from, std::vector<ObjectId>& objects) const;
  // Attaches and detaches leaves; sizes are kept, balance is not.
  void hang(ObjectId object);
  Ref unhang(ObjectId object);
  ObjectId beside(ObjectId leaf) const;
  void move_splits(int axis, ObjectId before, ObjectId after, Ref meet);
  void rebuild_subtree(Ref at);
  void balance_above(Ref at);
  std::uint64_t largest_side(std::uint64_t size) const;
  bool is_balanced(const Node& node) const;
  std::uint64_t most_depth() const;

  std::uint64_t delta_;
  Ref root_ = kNone;
  std::vector<Node> nodes_;
  std::vector<Ref> free_;
  std::vector<Ref> above_leaf_;  // per object
  std::uint64_t touched_ = 0;    // nodes, by the present exchange
  std::uint64_t points_rebuilt_ = 0;
};

}  // namespace kinex

#endif
