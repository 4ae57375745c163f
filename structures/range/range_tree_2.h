// SPDX-License-Identifier: GPL-3.0-or-later
// RangeTree2: a kinetic range tree of moving points in the plane: orthogonal range search in
// polylogarithmic time.
//
// Certificates. None of its own: it reads the sorted lists of both coordinates (2 (n - 1)
// certificates, at most 4 a point, of the degree of the motions). The primary tree is that of the
// dyadic intervals of x labels (range_structure.h). Each interval that is longer than one label
// keeps its points in the order of y, in an OrderTree.
//
//   [0..7]  c a d b        all points, by y
//   [0..3]  c b   [4..7]  a d
//   [0..1]  b     [2..3]  c   ..
//
//   swap in y: the two are neighbours in every node that holds both, and change places there
//   swap in x: in every node that holds one of the two, the other takes its place
//
// Quality, for n points and N labels (N a power of two, N < 2n unless points came or went): space n
// log2 N. A swap touches at most 2 log2 N nodes: O(log n) for y, expected O(log^2 n) for x. A query
// reads at most 2 log2 N nodes; it takes O(log n) signs and expected O(log^2 n + k) steps for k
// points reported. An insertion: amortised O(log^4 n) steps.
//
// Attribute: the points by x, then the points by y. Every swap of the lists is external, with the
// ids of the two: d n(n-1)/2 an axis for motions of degree d.
//
// Ties. As in the lists: points with identically equal coordinates are in the order of their ids.
//
// Source: Basch, Guibas, Zhang, "Proximity problems on moving points" (1997), section 3.
#ifndef KINEX_STRUCTURES_RANGE_RANGE_TREE_2_H
#define KINEX_STRUCTURES_RANGE_RANGE_TREE_2_H

#include <vector>

#include "structures/parts/order_tree.h"
#include "structures/range/range_structure.h"

namespace kinex {

class RangeTree2 final : public RangeStructure {
 public:
  // Two neighbours in the order of x, or of y, change places: the one that came first, the other.
  enum Kind : std::uint8_t { kSwapX, kSwapY };

  RangeTree2(Kernel& kernel, StructureId id, const SortedList& x, const SortedList& y);

  std::string_view name() const override { return "range_tree_2"; }
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"swap_x", "swap_y"});
  }
  Attribute attribute() const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  std::size_t bytes() const override;

 private:
  using Place = OrderTree::Place;
  // The points with labels of one dyadic interval, by y.
  struct Node {
    OrderTree order;
    std::vector<ObjectId> at;  // per place
    std::vector<Place> free;
  };

  void make_tree() override;
  void put_in(ObjectId object) override;
  void take_out(ObjectId object) override;
  std::uint64_t exchange(int axis, ObjectId before, ObjectId after) override;
  std::uint64_t most_touched() const override { return 2 * levels_.size(); }
  Cost search(const LabelBox& box, std::vector<ObjectId>& out, QueryTrace* trace) const override;
  std::uint64_t most_looked_at(std::uint64_t) const override {
    return levels_.empty() ? 1 : 2 * levels_.size();
  }
  void check_tree(AuditReport& report) const override;
  void swapped(int axis, ObjectId before, ObjectId after) override;
  void follow_rebuild() override;

  // The node of 2^level labels with the x label of the object.
  std::size_t interval(std::size_t level, ObjectId object) const {
    return label(0, object) >> level;
  }
  Place& place(std::size_t level, ObjectId object) { return places_[level - 1][object]; }
  Node& node(std::size_t level, std::size_t interval) { return levels_[level - 1][interval]; }
  void add(std::size_t level, Node& node, ObjectId object);
  void remove(std::size_t level, Node& node, ObjectId object);
  void search_node(const Node& node, const LabelBox& box, std::vector<ObjectId>& out,
                   Cost& cost) const;
  static std::vector<ObjectId> objects_of(const Node& node);

  // levels_[k - 1]: the nodes of 2^k labels; places_[k - 1]: per object, its place in its node.
  std::vector<std::vector<Node>> levels_;
  std::vector<std::vector<Place>> places_;
  std::uint64_t stored_ = 0, most_stored_ = 0;  // places in all nodes
};

}  // namespace kinex

#endif
