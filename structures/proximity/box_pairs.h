// SPDX-License-Identifier: GPL-3.0-or-later
// BoxPairs: the pairs of moving boxes with sides along the axes that meet, in 1 to 3 axes. In a
// scene of discs: the pairs of their boxes.
//
// Certificates. The order of the ends of all boxes along every axis (box_overlaps.h): 2n - 1 an axis
// for n boxes; degree d for motions and extents of degree d.
//
// Quality: an object is in at most 4 certificates an axis; a failure renews 3. Swaps: at most
// 2 d n(n-1) an axis; external events at most d n(n-1) an axis, n(n-1) in all for linear motions
// and extents, since two boxes then meet in one interval of time.
//
// Ties. Boxes are closed: two that touch identically meet; those that touch at an instant do not
// become a pair by that.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 7.
#ifndef KINEX_STRUCTURES_PROXIMITY_BOX_PAIRS_H
#define KINEX_STRUCTURES_PROXIMITY_BOX_PAIRS_H

#include <span>
#include <string_view>
#include <vector>

#include "core/engine/structure.h"
#include "structures/proximity/box_overlaps.h"
#include "structures/proximity/meeting_events.h"

namespace kinex {

class BoxPairs final : public Structure {
  auto changed() {
    return [this](ObjectId a, ObjectId b, bool meets) { events_.changed(a, b, meets); };
  }
  auto tied() {
    return [this](ObjectId a, ObjectId b) { events_.tied(a, b); };
  }

 public:
  BoxPairs(Kernel& kernel, StructureId id, const Scene& scene)
      : dimension_(scene.dimension),
        discs_(scene.extents == Extents::kRadius),
        overlaps_(kernel, id, scene),
        events_(kernel, id) {}

  std::string_view name() const override { return "box_pairs"; }
  // Those of MeetingEventKind.
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"meet", "part", "swap", "tie"});
  }
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override { build(overlaps_.objects()); }
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override {
    overlaps_.motions_changed(objects, changed(), tied());
  }
  void instant_over() override { events_.over(); }
  Attribute attribute() const override;
  Attribute told() const override { return events_.told(attribute()); }
  void visit_proof(ProofVisitor& visitor) const override { overlaps_.visit_proof(visitor); }
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override { return overlaps_.bytes() + events_.bytes(); }

 private:
  int dimension_;
  bool discs_;
  BoxOverlaps overlaps_;
  MeetingEvents events_;
};

}  // namespace kinex

#endif
