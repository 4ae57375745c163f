// SPDX-License-Identifier: GPL-3.0-or-later
// The pairs of moving discs (in space balls, on a line intervals) that meet, in two ways:
//
//                        disc_pairs_all              disc_pairs_boxes
//   certificates         n(n-1)/2, one a pair        2n - 1 an axis for the ends of the discs'
//                                                    boxes, one a pair of boxes that meet
//   an object in         n - 1                       4 an axis, one for each box that it meets
//   a failure            changes the pair            changes the pair, or the order of two ends
//
// Certificates. +-disc_overlap of a pair, degree 2d for motions and radii of degree d; the ends of
// boxes, degree d (box_overlaps.h). Discs that meet have boxes that meet; the certificate of a pair
// is made when its boxes begin to meet and withdrawn when they part. Discs may meet at the instant
// at which their boxes do.
//
// Quality: external events at most n(n-1) for linear motions and radii, since two discs then meet
// in one interval of time. disc_pairs_all has no failure that changes nothing.
//
// Ties. Discs are closed: two that touch identically meet; those that touch at an instant do not
// become a pair by that.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 7.
#ifndef KINEX_STRUCTURES_PROXIMITY_DISC_PAIRS_H
#define KINEX_STRUCTURES_PROXIMITY_DISC_PAIRS_H

#include <span>
#include <string_view>
#include <vector>

#include "core/engine/structure.h"
#include "structures/parts/member_pairs.h"
#include "structures/proximity/box_overlaps.h"
#include "structures/proximity/disc_claims.h"
#include "structures/proximity/meeting_events.h"

namespace kinex {

// All pairs, each with a certificate of its own.
class DiscPairsAll final : public Structure {
 public:
  DiscPairsAll(Kernel& kernel, StructureId id, const Scene& scene)
      : claims_(kernel, id, scene), events_(kernel, id) {}

  std::string_view name() const override { return "disc_pairs_all"; }
  // Those of MeetingEventKind.
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"meet", "part", "change", "tie"});
  }
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override { build(std::vector<ObjectId>(members_.members())); }
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  void instant_over() override { events_.over(); }
  Attribute attribute() const override {
    return {Attribute::Shape::kTuples, claims_.meeting()};
  }
  Attribute told() const override { return events_.told(attribute()); }
  void visit_proof(ProofVisitor& visitor) const override { claims_.visit_proof(visitor); }
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override {
    return members_.bytes() + claims_.bytes() + events_.bytes();
  }

 private:
  MemberPairs members_;
  DiscClaims claims_;
  MeetingEvents events_;
};

// The pairs whose boxes meet.
class DiscPairsBoxes final : public Structure {
 public:
  DiscPairsBoxes(Kernel& kernel, StructureId id, const Scene& scene)
      : overlaps_(kernel, id, scene), claims_(kernel, id, scene), events_(kernel, id) {}

  std::string_view name() const override { return "disc_pairs_boxes"; }
  // Those of MeetingEventKind.
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"meet", "part", "swap", "tie"});
  }
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override { build(overlaps_.objects()); }
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  void instant_over() override { events_.over(); }
  Attribute attribute() const override {
    return {Attribute::Shape::kTuples, claims_.meeting()};
  }
  Attribute told() const override { return events_.told(attribute()); }
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override {
    return overlaps_.bytes() + claims_.bytes() + events_.bytes();
  }

 private:
  // The boxes of a pair begin or cease to meet.
  auto boxes_changed() {
    return [this](ObjectId a, ObjectId b, bool meet) {
      if (meet ? claims_.add({a, b}) : claims_.remove({a, b})) events_.changed(a, b, meet);
    };
  }
  auto tied() {
    return [this](ObjectId a, ObjectId b) { events_.tied(a, b); };
  }
  void read_boxes();

  BoxOverlaps overlaps_;
  DiscClaims claims_;  // of the pairs of boxes that meet
  MeetingEvents events_;
};

}  // namespace kinex

#endif
