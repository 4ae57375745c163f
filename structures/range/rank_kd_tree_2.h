// SPDX-License-Identifier: GPL-3.0-or-later
// RankKdTree2: a kinetic kd-tree of moving points in the plane that needs no rebalancing: it is a
// function of the two orders alone.
//
// Certificates. None of its own: it reads the sorted lists of both coordinates. In the plane of the
// labels (range_structure.h), a square of side N, cells are halved in x, then in y, and so on. A
// node is the smallest cell with the two or more points that it holds, and is stored with it.
//
//   +---------+---------+      root: all       the halves of a cell are those of its sides;
//   |      d  |         |       /     \        empty halves are skipped
//   |---------|         |     [ac|d]   b
//   | a    c  |      b  |      /   \           leaves, depth first: a c d b
//   +---------+---------+    [ac]   d
//
// Quality, for n points and N labels (N < 2n unless points came or went): depth at most 2 log2 N.
// A swap walks down twice, at most 2 (2 log2 N + 1) nodes, and often changes nothing. A query for a
// box with k points looks at no more than 50 sqrt(N) + 2k + 1 nodes: a column of w labels holds at
// most w points, so at most min(2^i, N / 2^i) cells of level 2i meet a vertical line; at most 5
// sqrt(N) cells of all levels do, and 7.1 sqrt(N) meet a horizontal line; a box has two sides of
// each kind, and a node has two children.
//
// Ties. As in the lists: points with identically equal coordinates are in the order of their ids.
//
// Source: after Abam, de Berg, Speckmann, "Kinetic kd-trees and longest-side kd-trees" (2009),
// section 2: a kd-tree on the ranks. The dyadic cells and the constants are ours.
#ifndef KINEX_STRUCTURES_RANGE_RANK_KD_TREE_2_H
#define KINEX_STRUCTURES_RANGE_RANK_KD_TREE_2_H

#include <array>
#include <vector>

#include "structures/range/leaf_tree_2.h"

namespace kinex {

class RankKdTree2 final : public LeafTree2 {
 public:
  RankKdTree2(Kernel& kernel, StructureId id, const SortedList& x, const SortedList& y)
      : LeafTree2(kernel, id, x, y), above_leaf_(x.objects(), kNone) {}

  std::string_view name() const override { return "rank_kd_tree_2"; }
  std::size_t bytes() const override {
    return LeafTree2::bytes() + nodes_.capacity() * sizeof(Node) +
           (free_.capacity() + above_leaf_.capacity()) * sizeof(Ref);
  }

 private:
  // The bits of both labels by turns, x first, from the highest one: cells are prefixes.
  using Code = std::uint64_t;
  struct Node {
    Code code = 0;       // of a point in the cell
    unsigned depth = 0;  // the number of leading bits that all points of the cell have in common
    Ref above = kNone;
    std::array<Ref, 2> below{};
  };

  // A box in codes, each axis with its bits only.
  struct CodeBox {
    std::array<Code, 2> low, high;
  };

  void make_tree() override;
  void put_in(ObjectId object) override;
  void take_out(ObjectId object) override;
  std::uint64_t exchange(int axis, ObjectId before, ObjectId after) override;
  std::uint64_t most_touched() const override { return 2 * (2 * labels(0).bits() + 1); }
  Cost search(const LabelBox& box, std::vector<ObjectId>& out, QueryTrace* trace) const override;
  std::uint64_t most_looked_at(std::uint64_t k) const override;
  void check_tree(AuditReport& report) const override;
  std::vector<ObjectId> leaves() const override;
  ObjectId leaf_before(ObjectId leaf) const override;

  unsigned code_bits() const { return 2 * labels(0).bits(); }
  Code code(ObjectId object) const;
  unsigned common_bits(Code a, Code b) const;
  std::size_t side(Code code, unsigned depth) const {
    return (code >> (code_bits() - 1 - depth)) & 1;
  }
  Node& node(Ref ref) { return nodes_[ref - kInner]; }
  const Node& node(Ref ref) const { return nodes_[ref - kInner]; }
  Ref& above(Ref ref) { return is_leaf(ref) ? above_leaf_[ref] : node(ref).above; }
  void arrange();
  void replace_below(Ref above, Ref old, Ref fresh);
  bool stays(ObjectId object, Code fresh) const;
  Sides sides_of(const Node& node, const CodeBox& box) const;

  Ref root_ = kNone;
  std::vector<Node> nodes_;
  std::vector<Ref> free_;
  std::vector<Ref> above_leaf_;  // per object
  std::uint64_t walked_ = 0;     // nodes that insertions have passed
};

}  // namespace kinex

#endif
