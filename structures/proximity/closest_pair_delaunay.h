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
// new flight plan, points that come, go or pass on a line, a degenerate instant) reads all edges,
// O(n), and renews O(log n) certificates for each changed one. Events: README.md.
//
// Ties. Of pairs whose distances are identically equal the lexicographically smallest one.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 9.
#ifndef KINEX_STRUCTURES_PROXIMITY_CLOSEST_PAIR_DELAUNAY_H
#define KINEX_STRUCTURES_PROXIMITY_CLOSEST_PAIR_DELAUNAY_H

#include <span>
#include <string_view>
#include <vector>

#include "structures/parts/attribute_events.h"
#include "structures/parts/changing_extremum.h"
#include "structures/parts/pair_distances.h"
#include "structures/proximity/counted_edges.h"

namespace kinex {

class ClosestPairDelaunay final : public Structure {
  using Pair = PairDistances::Value;  // two ids, ascending
  auto tied() {
    return [this](const Pair& a, const Pair& b) {
      kernel_->report(id_, kTie, {a[0], a[1], b[0], b[1]}, false);
    };
  }

 public:
  // kReplace: another winner of a duel of two edges: the ends of the old one and of the new one.
  // kTie: the same, because the lengths have become identically equal.
  enum Kind : std::uint8_t { kReplace, kTie };

  // `name`: as registered. The triangulation of the edges, of all points that count, outlives this
  // structure and is watched by it.
  ClosestPairDelaunay(Kernel& kernel, StructureId id, std::string_view name, CountedEdges edges);

  std::string_view name() const override { return name_; }
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"replace", "tie"});
  }
  void build(std::span<const ObjectId>) override { begin(); }
  void rebuild() override {
    edges_.rebuild(tied());
    begin();
  }
  void certificate_failed(CertificateId failed) override;
  // Points come and go in the triangulation.
  void insert(ObjectId) override { begin(); }
  void erase(ObjectId) override { begin(); }
  void motions_changed(std::span<const ObjectId> objects) override {
    edges_.motions_changed(objects, tied());
  }
  // The triangulation may have changes that it has not reported yet.
  void instant_settled() override {
    if (kernel_->instant_is_shared(counted_.graph().id())) follow(std::nullopt);
  }
  void instant_over() override { events_.over(closest()); }
  void watched_changed(const Event* event) override { follow(counted_.told(event)); }
  Attribute attribute() const override {
    return {Attribute::Shape::kTuples, {closest().begin(), closest().end()}};
  }
  Attribute told() const override { return events_.told(); }
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override { return edges_.bytes() + events_.bytes() + counted_.bytes(); }

 private:
  std::span<const ObjectId> closest() const;
  void begin();
  void follow(const std::optional<DelaunayEdgeChange>& change);

  Kernel* kernel_;
  StructureId id_;
  std::string_view name_;
  CountedEdges counted_;
  ChangingExtremum<PairDistances> edges_;
  AttributeEvents events_;
};

}  // namespace kinex

#endif
