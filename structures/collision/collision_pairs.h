// SPDX-License-Identifier: GPL-3.0-or-later
// CollisionPairs: collisions of convex polygons, by any proof that two of them are apart.
//
// Every pair that is not in contact has a proof of disjointness: up to eight certificates on the
// pair's pose, one body as seen from the other (predicates/bodies/pose_2.h). The structures differ
// in this proof alone (separation_proof.h). A pair in contact has an overlap proof, the same in all
// of them (overlap_proof.h). The attribute is the set of pairs in contact, that is, of the pairs
// that overlap right after now.
//
//     certificate of    part          state of the pair   when it fails
//     a cell            cells         any                 the body moves on: pairs come and go
//     volumes           volumes       far                 the proof of the structure begins
//     the structure     its own       apart, resting      repaired, or a contact
//     the overlap       overlap       overlap, inner      another edge ahead, or a separation
//
// States of a pair and the events between them:
//
//                         .-------------- contact --------------.
//                         |                                     v
//     far -- volume --> apart <-- touch --> resting -- contact --> overlap <---> inner
//                         ^                    ^                   |
//                         '--------------------'--- separation ----'
//
//     resting: apart, but touching over a time interval   inner: discs within the bodies overlap
//
// A pair begins far, apart, resting or overlapping; a volume can also fail at a contact. A pair that
// is not in contact is dropped when a body moves to a cell that does not touch the other's. In an
// inexact arithmetic a pair in contact may also be without a proof.
//
// External events: "contact", "graze", "separation" and "overlap". An "overlap" reports a pair that
// overlaps right after one of its bodies is first seen: at the start, or when the body appears or
// jumps. It is reported even if the two only touch at that instant. The pair begins with the
// overlap proof and continues as after a contact. The start and the common event "insert" change
// the attribute only through these "overlap" events, one for each pair. Unless the scene allows
// overlapping starts, a body that appears or jumps after the start must be apart from all others;
// otherwise std::invalid_argument names both bodies and the time.
//
// Broad phase. With more than two bodies, in a scene that has an end, it is a uniform grid
// (body_grid.h). Pairs in cells that do not touch have no proof of their own. Pairs in neighbouring
// cells have one certificate as long as squares or discs around the bodies are apart, or discs
// within the bodies overlap (predicates/bodies/body_volumes.h). In a scene without an end all pairs
// are followed. With two bodies there is neither a grid nor a volume.
//
// Ties. A pair that touches without penetrating (the distance is zero at one instant, or for a
// while along an edge, and never negative) has no contact, since no certificate becomes negative.
// It has one graze, at the instant at which the touch begins, however long the touch lasts and over
// however many features.
//   - A touch that turns into penetration ends with a contact.
//   - Bodies that touch when they appear do not graze. Nor do bodies that come out of a contact:
//     they separate when they cease to overlap.
//   - Bodies that overlap right before and right after an instant have no event at it.
// A proof detects a touch by those of its certificates that are zero when the bodies touch: these
// fail at a touch too (core/arithmetic/touch.h). Only exact arithmetics detect touches: doubles
// cannot tell one from a near miss.
#ifndef KINEX_STRUCTURES_COLLISION_COLLISION_PAIRS_H
#define KINEX_STRUCTURES_COLLISION_COLLISION_PAIRS_H

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/engine/kernel.h"
#include "core/engine/structure.h"
#include "core/motion/scene.h"
#include "structures/collision/body_grid.h"
#include "structures/collision/overlap_proof.h"
#include "structures/collision/pair_table.h"
#include "structures/collision/separation_proof.h"

namespace kinex {

// What distinguishes a structure for collisions.
struct CollisionMethod {
  std::string_view name;
  std::span<const std::string_view> kinds;  // of the events of its proof; static
  CutPolicy policy;                         // of the hierarchies of polygons
  std::unique_ptr<SeparationProof> (*make)(PairTable& pairs);
  bool counts_signs = false;  // SeparationProof::handled
};

class CollisionPairs final : public Structure {
 public:
  CollisionPairs(Kernel& kernel, StructureId id, const Scene& scene, const CollisionMethod& method);

  std::string_view name() const override { return method_.name; }
  std::vector<std::string_view> event_kinds() const override;
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  Attribute attribute() const override;
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  // False where a body's rotor vanishes: beyond the end of its flight plan.
  bool holds_at(const Snapshot& snapshot) const override;
  std::size_t bytes() const override;

  // The two bodies overlap right after now. O(pairs of a).
  bool in_contact(ObjectId a, ObjectId b) const;
  const SeparationProof& proof() const { return *proof_; }

 private:
  using State = BodyPair::State;
  void report(PairId p, std::uint8_t kind, bool external = false) {
    kernel_.report(id_, kind, {pairs_[p].a, pairs_[p].b}, external);
  }
  void report_meeting(PairId p, std::uint8_t kind, const Features& features);
  void report_overlaps(ObjectId object);
  // ---- the broad phase
  void add_body(ObjectId object);
  // Adds the new pairs of this body that are near; removes those that are no longer near.
  void update_pairs(ObjectId body);
  void cell_left(CertificateId failed);
  void follow_near(PairId p);
  void follow(PairId p);  // by the proof of the structure
  void volume_failed(PairId p);
  // ---- two bodies that are apart
  // The certificate touches zero without failing: it is made anew.
  bool only_touches(PairId p, std::uint32_t slot);
  void proof_failed(PairId p, std::uint32_t slot);
  bool is_stuck(PairId p);
  void look_for_touch(PairId p);
  // Reports the contact: the proof of disjointness ends, the overlap proof begins. `near`: features
  // near those that meet. If the bodies do not overlap after all (certificates can mislead at an
  // instant at which edges become parallel), the proof is started anew and an event of its first
  // kind is reported.
  void contact(PairId p, const Features& near);
  // ---- collision_pairs_overlap.cpp: two bodies that overlap
  OverlapProof overlap_proof(const SumBoundary& sum, PairId p);
  std::optional<SumBoundary::Edge> edge_ahead(PairId p, const Features& near);
  Features features_at(PairId p, const SumBoundary::Edge& edge);
  void follow_overlap(PairId p, const std::optional<SumBoundary::Edge>& ahead);
  bool follow_discs_within(PairId p);
  PairTable::Roles describe_overlap(PairId p, ProofGroup& group) const;
  void overlap_failed(PairId p, std::uint32_t slot);
  void overlap_moved(PairId p);
  void part(PairId p, const SumBoundary::Edge& edge);

  Kernel& kernel_;
  const StructureId id_;
  const Scene& scene_;
  const CollisionMethod method_;
  PairTable pairs_;
  std::optional<BodyGrid> grid_;
  Slots overlap_;
  std::unique_ptr<SeparationProof> proof_;
  std::optional<RayPredicates> rays_;  // from the first contact on
  std::vector<PairId> had_;            // in contact before the last update_pairs
  std::vector<std::uint8_t> alive_;
  std::size_t bodies_ = 0, most_bodies_ = 0;
};

// The proof of a structure for collisions by pairs; throws std::bad_cast if it is another one.
template <class Proof>
const Proof& proof_of(const Structure& structure) {
  return dynamic_cast<const Proof&>(dynamic_cast<const CollisionPairs&>(structure).proof());
}

}  // namespace kinex

#endif
