// SPDX-License-Identifier: GPL-3.0-or-later
// ClosestPairDelaunay: the closest pair of moving points: the shortest edge of their Delaunay
// triangulation; or the closest pair of two points of different classes: the shortest edge between
// the classes. These are closest_pair_delaunay and bichromatic_pair_delaunay.
//
// Certificates. It watches the triangulation (delaunay_2, or delaunay_3 in space) and keeps the
// shortest of its edges by a ChangingExtremum: "this edge is at most as long as that one", degree 2d
// for motions of degree d.
// The disc that has a closest pair as diameter holds no third point, not even on its boundary. So
// every closest pair is an edge of every Delaunay triangulation. Points hidden behind an
// identically equal vertex add the pairs (vertex, hidden point), of length zero. A flip ab -> cd
// gives the leaf of ab to cd.
//
// Two classes. The disc on the closest pair of different classes is empty, too: a third point in
// it, of either class, would be closer to the end of the other class. At a distance above zero no
// two identically equal points differ in class, and the vertices stand for those hidden behind
// them; at distance zero the smallest pair of a group of equal points contains its vertex. So the
// edges between the classes suffice. In the plane they are those of a bipartite planar graph: at
// most 2n - 4.
//
// Quality, for n points in the plane: at most 3n - 7 certificates of its own (2n - 5 for two
// classes; in space one fewer than pairs that count), not local; a flip or a failure
// renews O(log n). A new flight plan, an insertion, an erasure, two points that pass on a line, or
// a degenerate instant reads all edges, O(n), and renews O(log n) certificates for each changed
// edge. External events: one for each instant that changes the pair, at most lambda_2d(n(n-1)/2) -
// 1 without flight-plan changes: n(n-1) - 2 for linear motion; of two classes of m and n points at
// most lambda_2d(mn) - 1.
//
// Ties. Of pairs whose distances are identically equal the lexicographically smallest one.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 9.
#ifndef KINEX_STRUCTURES_PROXIMITY_CLOSEST_PAIR_DELAUNAY_H
#define KINEX_STRUCTURES_PROXIMITY_CLOSEST_PAIR_DELAUNAY_H

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "structures/parts/attribute_events.h"
#include "structures/parts/changing_extremum.h"
#include "structures/parts/object_sets.h"
#include "structures/proximity/delaunay_edges.h"
#include "structures/proximity/pair_distances.h"

namespace kinex {

class ClosestPairDelaunay final : public Structure {
  using Pair = PairDistances::Value;
  auto tied() {
    return [this](const Pair& a, const Pair& b) {
      kernel_->report(id_, kTie, {a[0], a[1], b[0], b[1]}, false);
    };
  }

 public:
  // kReplace: another winner of a duel of two edges: the ends of the old one and of the new one.
  // kTie: the same, because the lengths have become identically equal.
  enum Kind : std::uint8_t { kReplace, kTie };

  // `triangulation`, of all points that count, outlives this structure and is watched by it.
  // `classes`: pairs of two points of different classes alone; nullopt: all pairs.
  ClosestPairDelaunay(Kernel& kernel, StructureId id, const DelaunayGraph& triangulation,
                      std::optional<TwoClasses> classes);

  std::string_view name() const override {
    return classes_ ? "bichromatic_pair_delaunay" : "closest_pair_delaunay";
  }
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
    if (kernel_->instant_is_shared(triangulation_.id())) watched_changed(nullptr);
  }
  void instant_over() override { events_.over(closest()); }
  void watched_changed(const Event* event) override;
  Attribute attribute() const override {
    return {Attribute::Shape::kTuples, {closest().begin(), closest().end()}};
  }
  Attribute told() const override { return events_.told(); }
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override {
    return edges_.bytes() + events_.bytes() + (classes_ ? classes_->bytes() : 0);
  }

 private:
  // The two ids, ascending; empty if there are fewer than two points.
  std::span<const ObjectId> closest() const;
  bool counts(const Pair& pair) const { return !classes_ || classes_->differ(pair[0], pair[1]); }
  std::vector<Pair> candidates() const;
  std::size_t most_edges(std::size_t n) const;
  bool follow(const Event& event);
  void begin();

  Kernel* kernel_;
  StructureId id_;
  DelaunayGraph triangulation_;
  std::optional<TwoClasses> classes_;
  ChangingExtremum<PairDistances> edges_;
  AttributeEvents events_;
};

}  // namespace kinex

#endif
