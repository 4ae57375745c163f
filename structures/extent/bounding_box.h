// SPDX-License-Identifier: GPL-3.0-or-later
// BoundingBox: the smallest box with sides along the axes that holds all moving points.
//
// Certificates. A KineticTournament for each of the 2 dim sides, by the coordinate of its axis;
// degree d in t for motions of degree d. Each is a part of the structure (Kernel::add_part), and
// part k is side k.
//
//      +-----------d----+  max y      sides 0 .. 3: min x, max x, min y, max y
//      |   b            |
//      a         e      c             attribute: a, c, f, d
//      |                |
//      +-------f--------+  min y
//
// A failure renews O(log n) certificates, an insertion or erasure O(dim log n). The counts of events
// and their proofs are in README.md.
//
// Ties. Of points with identically equal coordinates the smallest id is on the side.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), sections 5 and 6.7.
#ifndef KINEX_STRUCTURES_EXTENT_BOUNDING_BOX_H
#define KINEX_STRUCTURES_EXTENT_BOUNDING_BOX_H

#include <span>
#include <string_view>
#include <vector>

#include "core/engine/structure.h"
#include "structures/parts/attribute_events.h"
#include "structures/parts/key_order.h"
#include "structures/parts/kinetic_tournament.h"

namespace kinex {

class BoundingBox final : public Structure {
  auto tied() {
    return [this](ObjectId a, ObjectId b) { kernel_->report(id_, kTie, {a, b}, false); };
  }

 public:
  // kReplace: another winner at a node of a side's tournament: the old one, the new one. kTie: the
  // same, because the two coordinates have become identically equal.
  enum Kind : std::uint8_t { kReplace, kTie };

  BoundingBox(Kernel& kernel, StructureId id, const Scene& scene);

  std::string_view name() const override { return "bounding_box"; }
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"replace", "tie"});
  }
  void build(std::span<const ObjectId> objects) override {
    for (auto& side : sides_) side.build({objects.begin(), objects.end()}, tied());
    begin();
  }
  void rebuild() override { build(sides_[0].items()); }
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override {
    for (auto& side : sides_) side.insert(object, tied());
    begin();
  }
  void erase(ObjectId object) override {
    for (auto& side : sides_) side.erase(object, tied());
    begin();
  }
  void motions_changed(std::span<const ObjectId> objects) override {
    for (auto& side : sides_) side.motions_changed(objects, tied());
    read();
  }
  void instant_over() override { events_.over(box_); }
  // The extreme points: the first axis' minimum and maximum, those of the next axis, and so on.
  Attribute attribute() const override { return {Attribute::Shape::kSequence, box_}; }
  Attribute told() const override { return events_.told(); }
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override {
    return sides_.size() * (sizeof sides_[0] + sides_[0].bytes()) + events_.bytes();
  }

 private:
  void read();
  void begin() {
    read();
    events_.begin(box_);
  }

  Kernel* kernel_;
  StructureId id_;
  std::vector<KineticTournament<Contest>> sides_;
  std::vector<ObjectId> box_;  // the winners; empty without points
  AttributeEvents events_;
};

}  // namespace kinex

#endif
