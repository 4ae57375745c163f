// SPDX-License-Identifier: GPL-3.0-or-later
// DelaunayTree: the Euclidean minimum spanning tree of moving points, among the edges of their
// Delaunay triangulation (delaunay_2, or delaunay_3 in space), which it watches: emst_list,
// emst_cycles and emst_clusters.
//
// The engine proves the tree: by the order of all Delaunay edges (tree_by_list.h), by a cycle of
// which an edge is the longest, for every edge outside it (tree_by_short_cycles.h), or by the longest
// edges of paths in and between clusters of the points (tree_by_clusters.h). Certificates compare two
// lengths, degree 2d for motions of degree d.
//
// Edges suffice. No third point is in the closed disc that has a tree edge as diameter: in the
// triangle with such a point the edge would be strictly longest. So a tree edge is in every Delaunay
// triangulation. A flip neither removes an edge of the tree nor adds one: each of the two diagonals
// of four points on a circle is strictly longest in a triangle.
//
//         .  - c -  .       c is in the closed disc of diameter ab: the angle at c is at least 90
//       .  '     '    .     degrees, so ab is strictly the longest edge of the triangle a, b, c
//      a-------------b
//       .           .       p, q, r, s in this order on a circle: the angles at q and s add up to
//         .       .         180 degrees, so one of them is at least 90 and pr is strictly longest
//           ' - '           in its triangle; likewise qs
//
// Quality, for n points, of the engine beside delaunay_2 (of clusters: tree_by_clusters.h):
//
//                          emst_list                        emst_cycles
//   certificates           at most 3n - 7                   at most (2n - 5)(n - 1); 7n or 8n on
//                                                           1000 or 4000 random points
//   a failure renews       3, mostly internal               1 that changes the tree; else 1, or a
//                                                           cycle; on random points one in four
//                                                           or five changes the tree
//   a flip                 O(log n) comparisons             one triangle dropped, another proved
//   a degenerate instant,  looks at the edges that were     looks at the edges that were touched;
//   a point more or less   touched; Kruskal, O(n)           what has changed
//
// Ties. Of edges whose lengths are identically equal the lexicographically smaller one counts as
// the shorter, so the tree is unique. Points that are identically equal are a star around the
// smallest id.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 7: the tree
// and its changes.
#ifndef KINEX_STRUCTURES_PROXIMITY_DELAUNAY_TREE_H
#define KINEX_STRUCTURES_PROXIMITY_DELAUNAY_TREE_H

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/engine/structure.h"
#include "structures/proximity/delaunay_edges.h"
#include "structures/proximity/edge_lengths.h"
#include "structures/proximity/seen_edges.h"
#include "structures/proximity/spanning_tree.h"
#include "structures/proximity/tree_engine.h"
#include "structures/proximity/tree_events.h"

namespace kinex {

class DelaunayTree final : public Structure {
 public:
  // `triangulation` outlives this structure and is watched by it.
  // `name`: as registered.
  DelaunayTree(Kernel& kernel, StructureId id, const DelaunayGraph& triangulation, const TreeMethod& method,
               std::string_view name);

  std::string_view name() const override { return name_; }
  // Those of TreeEventKind.
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"swap", engine_->inside_kind(), "tie"});
  }
  void build(std::span<const ObjectId>) override { begin(); }
  void rebuild() override;
  void certificate_failed(CertificateId failed) override { engine_->certificate_failed(failed); }
  // Points come and go in the triangulation.
  void insert(ObjectId) override { begin(); }
  void erase(ObjectId) override { begin(); }
  void motions_changed(std::span<const ObjectId> objects) override {
    engine_->motions_changed(objects);
  }
  // The triangulation may have changes that it has not reported yet.
  void instant_settled() override {
    if (kernel_->instant_is_shared(triangulation_.id())) follow(std::nullopt);
  }
  void instant_over() override { events_.over(); }
  void watched_changed(const Event* event) override { follow(triangulation_.told(event)); }
  Attribute attribute() const override;
  Attribute told() const override { return events_.told(attribute()); }
  void visit_proof(ProofVisitor& visitor) const override { engine_->visit_proof(visitor); }
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override {
    return lengths_.bytes() + events_.bytes() + engine_->bytes();
  }

 private:
  using Edge = EdgeLengths::Edge;

  void add(const Edge& edge);
  void remove(const Edge& edge);
  void forget(Item item);
  void assign();
  void catch_up();
  void follow(const std::optional<DelaunayEdgeChange>& change);
  void begin();

  Kernel* kernel_;
  std::string_view name_;
  DelaunayGraph triangulation_;
  SeenEdges<DelaunayGraph> seen_;
  EdgeLengths lengths_;
  TreeEvents events_;
  std::unique_ptr<TreeEngine> engine_;
};

}  // namespace kinex

#endif
