// SPDX-License-Identifier: GPL-3.0-or-later
// MinCircle2: the smallest circle that encloses all moving points of the plane.
//
// Certificates. It watches the farthest-point Delaunay triangulation (farthest_delaunay_2), whose
// circles contain all points. Direct every triangle that has an angle of more than 90 degrees
// across the side opposite to it: there the distance to the farthest point decreases. The dual of
// the triangulation is a tree, and this function is convex, so all directions lead to one sink:
//
//   a triangle without obtuse angle   the circle is its circumcircle;         3 angles not obtuse
//   a side ab that the vertex of      the circle has the diameter ab;         1 or 2 angles not
//   each triangle at it sees under                                            acute
//   more than 90 degrees
//
//          c                     c          Left: no angle of abc is obtuse, so the circle is its
//         / \                 .-' '-.       circumcircle: 3 certificates, one for each angle. Right:
//        /   \               a-------b      the angles at c and d are obtuse, so the circle has the
//       a-----b               '-. .-'       diameter ab: 2 certificates; 1 if ab is on the hull.
//                                d
//
// The triangulation proves that the circle contains all points, the angles that none is smaller.
// Each angle is one acute_angle_2 or obtuse_angle_2, degree 2d for motions of degree d.
//
//      failure of an angle of the sink      the circle passes from a triangle to one of its sides,
//                                           or from a side to a triangle at it
//      flip of a side of the sink           the sink is one of the new triangles, or beside it
//
// Quality, for h hull vertices: 3 certificates at most, all local; a failure, or a change of the
// triangulation at the sink, is O(1) steps outside degenerate instants, at most h. The
// triangulation's cost comes on top. Every failure outside degenerate instants is external.
// External events: one for each instant that changes the circle, at most 4d C(n,4) + 6d C(n,3).
//
// Ties. The attribute is all hull vertices on the circle right after now, two or three, and more
// if they are identically on it: it does not depend on which of several triangles is the sink.
//
// The report takes the circle for the largest circumcircle of the triangulation, and concludes that
// it changes with the triangulation only. Both are wrong where two points determine it:
// structures/extent/README.md.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 6.9.
#ifndef KINEX_STRUCTURES_EXTENT_MIN_CIRCLE_2_H
#define KINEX_STRUCTURES_EXTENT_MIN_CIRCLE_2_H

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "core/engine/structure.h"
#include "structures/extent/farthest_delaunay_2.h"
#include "structures/parts/attribute_events.h"
#include "structures/parts/repeat_guard.h"
#include "structures/parts/slots.h"

namespace kinex {

class MinCircle2 final : public Structure {
 public:
  // kToTwo: an angle has become right, and two points determine the circle: they. kToThree: three
  // do, they. Changes with the triangulation are reported as "settled".
  enum Kind : std::uint8_t { kToTwo, kToThree };

  // `triangulation` outlives this structure and is watched by it.
  MinCircle2(Kernel& kernel, StructureId id, const FarthestDelaunay2& triangulation);

  std::string_view name() const override { return "min_circle_2"; }
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"to_two", "to_three"});
  }
  void build(std::span<const ObjectId>) override { begin(); }
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  // Points come and go in the triangulation.
  void insert(ObjectId) override { begin(); }
  void erase(ObjectId) override { begin(); }
  void motions_changed(std::span<const ObjectId>) override { repeats_.clear(); }
  void instant_settled() override { search(); }
  void instant_over() override;
  void watched_changed(const Event* event) override;
  // The hull vertices on the circle, ascending. One if all points are equal.
  Attribute attribute() const override { return {Attribute::Shape::kSequence, circle_}; }
  Attribute told() const override { return events_.told(); }
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override;

 private:
  using HalfEdge = Triangulation2::HalfEdge;
  using Triangle = Triangulation2::Triangle;

  Query acute(HalfEdge h) const;
  Query obtuse(HalfEdge h) const;
  HalfEdge start() const;
  void search();
  void collect();
  void certify(const std::vector<Query>& claims);
  bool concerns_sink(const Event& event) const;
  std::vector<Query> claims_of_sink(AuditReport& report) const;
  void begin() {
    repeats_.clear();
    search();
    events_.begin(circle_);
  }

  Kernel* kernel_;
  StructureId id_;
  const FarthestDelaunay2* triangulation_;
  PredicateId acute_, obtuse_;
  Slots slots_;
  std::array<CertificateId, 3> certificates_{kNoCertificate, kNoCertificate, kNoCertificate};
  CertificateId failing_ = kNoCertificate;  // it is renewed in any case
  HalfEdge at_ = Triangulation2::kNone;     // a side of the sink, or the sink
  bool two_ = true;                         // the sink is that side, and not its triangle
  std::vector<ObjectId> circle_;            // the attribute
  std::vector<ObjectId> around_;            // the points of the sink and of its certificates
  AttributeEvents events_;
  RepeatGuard repeats_;
  std::vector<HalfEdge> stack_;  // scratch
};

}  // namespace kinex

#endif
