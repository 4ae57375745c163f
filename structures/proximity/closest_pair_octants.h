// SPDX-License-Identifier: GPL-3.0-or-later
// ClosestPairOctants: the closest pair of moving points in the plane, among the pairs of a point and
// the next one in an octant around it: closest_pair_cones, which reads octants_listed, and
// closest_pair_local, which reads octants_local.
//
// Certificates. It watches the octants and keeps the shortest of their pairs by a ChangingExtremum:
// "this pair is at most as far apart as that one", at most 4n - 1, of degree 2d for motions of
// degree d. Each closest pair, if there are several, is among these pairs (cone_pairs.h).
//
// Quality, for n points: a failure renews O(log n) certificates, and so does every pair that comes
// or goes. A point may be next for many others. External events: one for each instant that changes
// the closest pair, at most lambda_2d(n(n-1)/2) - 1 without flight-plan changes.
//
// Ties. Of pairs whose distances are identically equal the lexicographically smallest one.
//
// Source: after Basch, Guibas, Hershberger, "Data structures for mobile data" (1997), who keep, for
// every point and cone, the one pair with the last of those that choose the point: as many
// candidates, of which fewer change at a failure.
#ifndef KINEX_STRUCTURES_PROXIMITY_CLOSEST_PAIR_OCTANTS_H
#define KINEX_STRUCTURES_PROXIMITY_CLOSEST_PAIR_OCTANTS_H

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "structures/parts/attribute_events.h"
#include "structures/parts/changing_extremum.h"
#include "structures/parts/pair_distances.h"
#include "structures/proximity/cone_neighbours.h"

namespace kinex {

class ClosestPairOctants final : public Structure {
  using Pair = PairDistances::Value;
  auto tied() {
    return [this](const Pair& a, const Pair& b) {
      kernel_->report(id_, kTie, {a[0], a[1], b[0], b[1]}, false);
    };
  }

 public:
  // kReplace: another winner of a duel of two pairs: the old one and the new one. kTie: the same,
  // because the distances have become identically equal.
  enum Kind : std::uint8_t { kReplace, kTie };

  // `octants` outlives this structure and is watched by it. `name`: as registered.
  ClosestPairOctants(Kernel& kernel, StructureId id, const ConeNeighbours& octants,
                     std::string_view name);

  std::string_view name() const override { return name_; }
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"replace", "tie"});
  }
  void build(std::span<const ObjectId>) override { begin(); }
  void rebuild() override {
    pairs_.rebuild(tied());
    begin();
  }
  void certificate_failed(CertificateId failed) override;
  // Points come and go in the octants.
  void insert(ObjectId) override { begin(); }
  void erase(ObjectId) override { begin(); }
  void motions_changed(std::span<const ObjectId> objects) override {
    pairs_.motions_changed(objects, tied());
  }
  // A failure of the octants brings several events: their pairs come and go together.
  void instant_settled() override { pairs_.apply(tied()); }
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
  std::size_t bytes() const override { return pairs_.bytes() + events_.bytes(); }

 private:
  // The two ids, ascending; empty if there are fewer than two points.
  std::span<const ObjectId> closest() const;
  void follow(ObjectId a, ObjectId b);
  void begin();

  Kernel* kernel_;
  StructureId id_;
  const ConeNeighbours* octants_;
  std::string_view name_;
  ChangingExtremum<PairDistances> pairs_;
  AttributeEvents events_;
};

}  // namespace kinex

#endif
