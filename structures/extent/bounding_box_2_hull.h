// SPDX-License-Identifier: GPL-3.0-or-later
// BoundingBox2Hull: the smallest box with sides along the axes that holds all moving points of the
// plane, by four pointers on their convex hull.
//
// Certificates. It watches a hull (any HullSource). A coordinate along a convex polygon has one
// maximum, so a vertex is extreme if neither neighbour lies farther out: two certificates for each
// side, of degree d for motions of degree d.
//
//        next .---v  max x
//            /    |            claims for the pointer v of the side max x:
//           /     |              next(v) is not to the right of v
//          '.     | previous     previous(v) is not to the right of v
//            '----'
//
// Quality: 8 certificates. A failure moves a pointer to its neighbour and renews 2; a vertex that
// comes or goes renews the certificates that name it. The hull's cost comes on top. External
// events: those of bounding_box.
//
// Ties. Of hull vertices with identically equal coordinates the smallest id is on the side. (A
// point between two of them on a hull edge is no vertex; bounding_box counts it.)
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 6.7.
#ifndef KINEX_STRUCTURES_EXTENT_BOUNDING_BOX_2_HULL_H
#define KINEX_STRUCTURES_EXTENT_BOUNDING_BOX_2_HULL_H

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "core/engine/structure.h"
#include "structures/hull/hull_source.h"
#include "structures/parts/attribute_events.h"
#include "structures/parts/repeat_guard.h"
#include "structures/parts/slots.h"

namespace kinex {

class BoundingBox2Hull final : public Structure {
 public:
  // kReplace: another vertex on a side: the old one, the new one.
  enum Kind : std::uint8_t { kReplace };

  // `hull` outlives this structure and is watched by it.
  BoundingBox2Hull(Kernel& kernel, StructureId id, const HullSource& hull);

  std::string_view name() const override { return "bounding_box_2_hull"; }
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"replace"});
  }
  void build(std::span<const ObjectId>) override { begin(); }
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  // Points come and go in the hull.
  void insert(ObjectId) override { begin(); }
  void erase(ObjectId) override { begin(); }
  void motions_changed(std::span<const ObjectId>) override { repeats_.clear(); }
  void instant_settled() override { look(); }
  void instant_over() override { events_.over(box_); }
  void watched_changed(const Event* event) override;
  // The extreme points: minimum x, maximum x, minimum y, maximum y.
  Attribute attribute() const override { return {Attribute::Shape::kSequence, box_}; }
  Attribute told() const override { return events_.told(); }
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override {
    return sizeof *this + box_.capacity() * sizeof(ObjectId) + events_.bytes();
  }

 private:
  struct Side {
    ObjectId previous = kNoObject, vertex = kNoObject, next = kNoObject;
    std::array<CertificateId, 2> certificates{kNoCertificate, kNoCertificate};
  };
  static constexpr std::size_t kSides = 4;

  // The claim that `b` is not beyond `a` on the side.
  Query claim(std::size_t side, ObjectId a, ObjectId b) const {
    return side % 2 == 0 ? Query(order_[side / 2], {a, b}) : Query(order_[side / 2], {b, a});
  }
  bool beats(std::size_t side, ObjectId b, ObjectId a) const;
  bool fits(const Side& side) const;
  ObjectId climb(std::size_t side) const;
  void look();
  void look(std::size_t side);
  void certify(std::size_t side, std::size_t which, ObjectId neighbour);
  void begin() {
    look();
    events_.begin(box_);
  }

  Kernel* kernel_;
  StructureId id_;
  const HullSource* hull_;
  std::array<PredicateId, 2> order_;
  Slots slots_;
  std::array<Side, kSides> sides_;
  std::vector<ObjectId> box_;  // empty without points
  AttributeEvents events_;
  CertificateId failing_ = kNoCertificate;  // it is renewed in any case
  RepeatGuard repeats_;
};

}  // namespace kinex

#endif
