// SPDX-License-Identifier: GPL-3.0-or-later
// MinCircle2BruteForce: the smallest circle that encloses all moving points of the plane, by
// comparing every point with it: the baseline.
//
// Certificates, for motions of degree d. The circle has a basis of two or three points.
//   two     each other point sees them under an angle that is not acute  obtuse_angle_2, degree 2d
//   three   their triangle is upright                                    orientation_2,  degree 2d
//           it has no obtuse angle (three certificates)                  acute_angle_2,  degree 2d
//           each other point is in their circle                          in_circle_2,    degree 4d
//
// Quality, for n points: n - 2 or n + 1 certificates, all but O(1) of them at each point of the
// basis. After a failure the static algorithm finds the circle, in O(n^3) signs at worst, and the
// certificates are made anew. Outside degenerate instants every failure changes the circle (but
// for an upright triangle that turns over where two of its points meet).
//
// Ties: as min_circle_2. Of points that are identically equal only the smallest id is on the
// circle.
//
// Source: Welzl, "Smallest enclosing disks (balls and ellipsoids)" (1991), for the static
// algorithm, in the order of the ids.
#ifndef KINEX_STRUCTURES_EXTENT_MIN_CIRCLE_2_BRUTE_FORCE_H
#define KINEX_STRUCTURES_EXTENT_MIN_CIRCLE_2_BRUTE_FORCE_H

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "core/engine/structure.h"
#include "core/motion/scene.h"
#include "structures/parts/attribute_events.h"
#include "structures/parts/repeat_guard.h"
#include "structures/parts/slots.h"

namespace kinex {

class MinCircle2BruteForce final : public Structure {
 public:
  // kToTwo, kToThree: a certificate failed, and now two or three points determine the circle: they,
  // ascending.
  enum Kind : std::uint8_t { kToTwo, kToThree };

  MinCircle2BruteForce(Kernel& kernel, StructureId id, const Scene& scene);

  std::string_view name() const override { return "min_circle_2_brute_force"; }
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"to_two", "to_three"});
  }
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override { begin(); }
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId>) override { repeats_.clear(); }
  void instant_settled() override { find(); }
  void instant_over() override { events_.over(circle_); }
  Attribute attribute() const override { return {Attribute::Shape::kSequence, circle_}; }
  Attribute told() const override { return events_.told(); }
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  std::uint64_t most_repairs(std::uint64_t) const override { return 0; }
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override;

 private:
  Sign angle(ObjectId a, ObjectId at, ObjectId b) const {
    return kernel_->sign_after(acute_, {a, at, b});
  }
  Sign side(ObjectId p) const;
  void set_basis(std::vector<ObjectId> basis);
  void find_basis();
  void add(std::size_t before, std::vector<ObjectId> fixed);
  bool identical(ObjectId a, ObjectId b) const;
  void collect();
  void find();
  std::vector<Query> claims() const;
  void begin();

  Kernel* kernel_;
  StructureId id_;
  PredicateId acute_, obtuse_, orientation_, in_circle_;
  std::array<PredicateId, 2> order_;
  Slots slots_;
  std::vector<bool> alive_;
  std::vector<ObjectId> members_;  // ascending
  std::vector<ObjectId> basis_;    // three: counter-clockwise, from the smallest id
  std::vector<ObjectId> circle_;   // the attribute
  std::vector<CertificateId> certificates_;
  CertificateId failing_ = kNoCertificate;  // it is renewed in any case
  AttributeEvents events_;
  RepeatGuard repeats_;
};

}  // namespace kinex

#endif
