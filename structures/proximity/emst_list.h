// SPDX-License-Identifier: GPL-3.0-or-later
// EmstList: the Euclidean minimum spanning tree of moving points, by the order of all Delaunay
// edges.
//
// It watches the triangulation (delaunay_2, or delaunay_3 in space), keeps its edges in a list by length, and holds the
// tree that Kruskal's algorithm makes of that order. Two neighbours of the list that change places
// change the tree only if one edge replaces the other in a cycle:
//
//     list   .. e f ..        e in the tree, f not, and e on the tree's path between f's ends:
//            .. f e ..        then f takes the place of e; otherwise the tree stays
//
// Certificates. One per pair of neighbours of the list, "this edge is at most as long as the next",
// degree 2d for motions of degree d.
//
// Edges suffice. No third point is in the closed disc that has a tree edge as diameter: in the
// triangle with such a point the edge would be strictly longest. So a tree edge is in every Delaunay
// triangulation, and a flip neither takes an edge of the tree nor brings one: each of the two
// diagonals of four points on a circle is strictly longest in a triangle.
//
// Quality, for n points: at most 3n - 7 certificates of its own, two an edge, so not local; a
// failure renews 3 in O(log n) and asks a link-cut forest for a path. A flip makes O(log n)
// comparisons. Degenerate instants of the triangulation, insertions and erasures read all edges and
// repeat Kruskal's algorithm along the list, O(n) after the changes of the list. Not efficient:
// most exchanges in the list are of edges far apart, Theta(n^2) for n changes of the tree.
//
// Ties. Of edges whose lengths are identically equal the lexicographically smaller one comes first,
// so the tree is unique. Points that are identically equal are a star around the smallest id.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 7; Rahmati,
// Zarei, "Kinetic Euclidean minimum spanning tree in the plane" (2012): the list and the swaps.
#ifndef KINEX_STRUCTURES_PROXIMITY_EMST_LIST_H
#define KINEX_STRUCTURES_PROXIMITY_EMST_LIST_H

#include <span>
#include <string_view>
#include <vector>

#include "structures/parts/kinetic_list.h"
#include "structures/parts/link_cut_forest.h"
#include "structures/proximity/delaunay_edges.h"
#include "structures/proximity/edge_lengths.h"
#include "structures/proximity/tree_events.h"

namespace kinex {

class EmstList final : public Structure {
 public:
  // kSwap: the tree's edge that is gone, its ends, and the one that came. External.
  // kOrder: two edges have changed places in the list: the one that was in front, the other.
  // kTie: the same, because their lengths have become identically equal.
  enum Kind : std::uint8_t { kSwap, kOrder, kTie };

  // `triangulation` outlives this structure and is watched by it.
  EmstList(Kernel& kernel, StructureId id, const DelaunayGraph& triangulation);

  std::string_view name() const override { return "emst_list"; }
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"swap", "order", "tie"});
  }
  void build(std::span<const ObjectId>) override { begin(); }
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  // Points come and go in the triangulation.
  void insert(ObjectId) override { begin(); }
  void erase(ObjectId) override { begin(); }
  void motions_changed(std::span<const ObjectId> objects) override;
  // The triangulation may have changes that it has not reported yet.
  void instant_settled() override {
    if (kernel_->instant_is_shared(triangulation_.id())) watched_changed(nullptr);
  }
  void instant_over() override { events_.over(); }
  void watched_changed(const Event* event) override;
  Attribute attribute() const override;
  Attribute told() const override { return events_.told(attribute()); }
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override;

 private:
  using Edge = EdgeLengths::Edge;
  using List = KineticList<EdgeLengths>;

  auto tied() {
    return [this](Item before, Item after) {
      const Edge e = list_.claims().edge(before), f = list_.claims().edge(after);
      kernel_->report(id_, kTie, {e[0], e[1], f[0], f[1]}, false);
      exchanged(before, after);
    };
  }
  void begin();
  void exchanged(Item before, Item after);
  void add(const Edge& edge);
  void remove(const Edge& edge);
  void assign();
  void rebuild_list();
  void grow_tree();
  bool in_tree(Item item) const { return item < in_tree_.size() && in_tree_[item]; }
  void put_in(Item item);
  void take_out(Item item);

  Kernel* kernel_;
  StructureId id_;
  DelaunayGraph triangulation_;
  List list_;
  LinkCutForest forest_;
  std::vector<bool> in_tree_;  // by item
  TreeEvents events_;
};

}  // namespace kinex

#endif
