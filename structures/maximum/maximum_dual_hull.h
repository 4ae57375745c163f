// SPDX-License-Identifier: GPL-3.0-or-later
// MaximumDualHull: the object with the largest (or smallest) of linear keys, by the convex hull of
// their dual points. Linear motions, and keys that are linear in them, only.
//
// key_i(t) = slope_i t + height_i is largest for the point (slope_i, height_i) that is extreme in
// direction (t, 1). As t grows that direction turns to the right, and its tangent rolls over the
// upper hull from vertex to vertex (LineHull):
//
//               w----n           w: the winner; its tangent is perpendicular to (t, 1)
//             /        .         n: the next vertex, which overtakes it
//           .            .
//
// Certificates. One: the winner is at least as good as the next vertex of the hull; degree 1 in t.
// That no other vertex can win before is a fact about the hull, which only flight plans change.
// None at the last vertex.
//
// Quality, for n objects:
//   compactness     1 certificate
//   locality        1 certificate an object
//   responsiveness  1 certificate, no sign; an insertion, erasure or flight-plan change O(log^2 n)
//                   signs, amortised
//   efficiency      strongly efficient: every event is external, at most n - 1 without flight-plan
//                   changes
// Space O(n).
//
// Ties. Of identically equal keys the smallest id wins. Where several objects overtake the winner
// at one instant, their points lie on one edge of the hull, and only its end becomes the winner.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 5.
#ifndef KINEX_STRUCTURES_MAXIMUM_MAXIMUM_DUAL_HULL_H
#define KINEX_STRUCTURES_MAXIMUM_MAXIMUM_DUAL_HULL_H

#include <span>
#include <string_view>

#include "core/engine/kernel.h"
#include "core/engine/structure.h"
#include "core/motion/scene.h"
#include "structures/maximum/line_hull.h"
#include "structures/parts/key_order.h"
#include "structures/parts/slots.h"

namespace kinex {

class MaximumDualHull final : public Structure {
 public:
  enum Kind : std::uint8_t {
    kReplace,  // another winner: the old one, the new one
    kTie,      // the same, because their keys have become identically equal
  };

  // Throws std::invalid_argument for motions or keys that are not linear.
  MaximumDualHull(Kernel& kernel, StructureId id, const Key& key, const Scene& scene,
                  Extremum extremum);

  std::string_view name() const override;
  std::vector<std::string_view> event_kinds() const override;
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  int largest_motion_degree() const override { return 1; }
  Attribute attribute() const override;
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override { return hull_.bytes(); }

  // kNoObject if there is none.
  ObjectId winner() const { return winner_; }
  const LineHull& hull() const { return hull_; }

 private:
  void look();
  void expect(ObjectId next);

  Kernel* kernel_;
  StructureId id_;
  Contest contest_;
  LineOrder order_;
  LineHull hull_;
  Slots slots_;
  std::size_t objects_;  // in the scene
  ObjectId winner_ = kNoObject;
  ObjectId next_ = kNoObject;  // the next vertex, which will overtake it
  CertificateId certificate_ = kNoCertificate;
};

}  // namespace kinex

#endif
