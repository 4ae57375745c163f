// SPDX-License-Identifier: GPL-3.0-or-later
// ClosestPairDelaunay: the closest pair of moving points: the shortest edge of their Delaunay
// triangulation, or the shortest between two classes of points (CountedEdges).
//
// Certificates. It watches the triangulation (delaunay_2, or delaunay_3 in space) and keeps the
// shortest of its edges by a ChangingExtremum: "this edge is at most as long as that one", degree 2d
// for motions of degree d. A flip ab -> cd gives the leaf of ab to cd.
//
// Quality, for n points in the plane: at most 3n - 7 certificates of its own (in space one fewer
// than pairs), not local; a flip or a failure renews O(log n). What changes more than one edge (a
// new flight plan, points that come or go, a degenerate instant) renews O(log n) certificates for each
// changed one, and looks at no others than those that the triangulation has touched (seen_edges.h). All
// edges are read, O(n log n), where points are on a line or, in space, in a plane (but for single flips
// there), meet identically, where the triangulation is rebuilt, and where thousands were touched. Events:
// README.md.
//
// Ties. Of pairs whose distances are identically equal the lexicographically smallest one.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 9.
#ifndef KINEX_STRUCTURES_PROXIMITY_CLOSEST_PAIR_DELAUNAY_H
#define KINEX_STRUCTURES_PROXIMITY_CLOSEST_PAIR_DELAUNAY_H

#include <span>
#include <string_view>
#include <vector>

#include "structures/parts/front_pair.h"
#include "structures/parts/pair_distances.h"
#include "structures/proximity/counted_edges.h"
#include "structures/proximity/seen_edges.h"

namespace kinex {

class ClosestPairDelaunay final : public FrontPair<PairDistances> {
 public:
  // `name`: as registered. The triangulation of the edges, of all points that count, outlives this
  // structure and is watched by it.
  ClosestPairDelaunay(Kernel& kernel, StructureId id, std::string_view name, CountedEdges edges);

  std::string_view name() const override { return name_; }
  void build(std::span<const ObjectId>) override { read_all(); }
  void rebuild() override {
    FrontPair::rebuild();
    read_all();
  }
  // Points come and go in the triangulation.
  void insert(ObjectId) override { read_touched(); }
  void erase(ObjectId) override { read_touched(); }
  // The triangulation may have changes that it has not reported yet.
  void instant_settled() override {
    if (kernel_->instant_is_shared(counted_.graph().id())) follow(std::nullopt);
  }
  void watched_changed(const Event* event) override { follow(counted_.graph().told(event)); }
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override { return FrontPair::bytes() + counted_.bytes(); }

 private:
  void read_all();
  void read_touched();
  void catch_up();
  bool put(const DelaunayEdge& edge, bool is_there);
  void follow(const std::optional<DelaunayEdgeChange>& change);

  std::string_view name_;
  CountedEdges counted_;
  SeenEdges<DelaunayGraph> seen_;
};

}  // namespace kinex

#endif
