// SPDX-License-Identifier: GPL-3.0-or-later
// CollisionPairs: the common base class of all structures for collisions of convex polygons.
//
// Every pair that is not in contact has a proof of disjointness, maintained by a derived class: up
// to eight certificates on the pair's pose, one body as seen from the other
// (predicates/bodies/pose_2.h). A pair in contact has an overlap proof, the same in all structures
// (overlap_proof.h). The attribute is the set of pairs in contact, that is, of the pairs that
// overlap right after now.
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
// within the bodies overlap (body_volumes.h). In a scene without an end all pairs are followed.
// With two bodies there is neither a grid nor a volume.
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

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/arithmetic/touch.h"
#include "core/engine/kernel.h"
#include "core/engine/structure.h"
#include "core/motion/scene.h"
#include "structures/collision/body_frames.h"
#include "structures/collision/body_grid.h"
#include "structures/collision/body_volumes.h"
#include "structures/collision/overlap_proof.h"
#include "structures/collision/sum_boundary.h"

namespace kinex {

using PairId = std::uint32_t;  // the index of a pair of bodies

class CollisionPairs : public Structure {
 public:
  // The ranks of "contact", "graze", "separation", "inside", "volume", "grid" and "overlap"; the
  // kinds of derived classes follow them.
  //   contact, graze, separation  the two bodies and the features that meet, as derived objects:
  //                    "a.v3" is vertex 3 of body a, "a.e3" the edge from it to the next (counted
  //                    from 0 in the scene's order). In an exact arithmetic they depend on the
  //                    motion alone: two vertices if these meet, else a vertex and an edge
  //   inside           the pair gets another overlap proof, with another edge ahead
  //   volume           the pair gets another one-certificate proof by volumes, or loses it
  //   grid             a body enters another cell
  //   overlap          two bodies overlap without having come into contact: one of them is new (or
  //                    an inexact arithmetic has missed the contact)
  static constexpr std::uint8_t kContact = 0, kGraze = 1, kSeparation = 2, kInside = 3, kVolume = 4,
                                kGrid = 5, kOverlap = 6, kFirstOwn = 7;
  // The largest number of certificates of a proof.
  static constexpr std::uint32_t kMostCertificates = 8;

  CollisionPairs(Kernel& kernel, StructureId id, const Scene& scene, CutPolicy policy);

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

 protected:
  struct Pair {  // two bodies that are followed
    ObjectId a = kNoObject, b = kNoObject;  // a < b; kNoObject: not in use
    ObjectId pose = kNoObject;
    bool touching = false;     // in contact
    bool apart = false;        // the proof is one certificate on volumes
    bool resting = false;      // not in contact, but they touch over a time interval
    std::uint8_t repairs = 0;  // repairs of the proof at instant number `instant`
    std::uint64_t instant = 0;  // Kernel::instant_number of the last repair
    std::uint8_t certificates = 0;
    SumBoundary::Edge ahead{};  // the edge ahead (overlap_proof.h), while they are in contact
    std::array<CertificateId, kMostCertificates> certificate{};
  };

  // Makes a proof of disjointness right after now; false if the bodies are not disjoint there.
  virtual bool start(PairId pair) = 0;
  // As start(), where the bodies have just separated at this edge of M, the Minkowski sum.
  virtual bool leave(PairId pair, const SumBoundary::Edge& edge) {
    static_cast<void>(edge);
    return start(pair);
  }
  // The certificate of this slot is negative right after now: repairs the proof and reports one
  // event, or calls contact().
  virtual void fail(PairId pair, std::uint32_t slot) = 0;
  // The motion of one of the two bodies has changed.
  virtual void moved(PairId pair) { static_cast<void>(pair); }
  // The pair is no longer followed; its certificates are retracted afterwards.
  virtual void stop(PairId pair) { static_cast<void>(pair); }
  // The largest number of certificates that a proof has between events.
  virtual std::uint32_t most_certificates() const = 0;

  // The kinds of events: those above, the derived class's own, the common ones.
  static std::vector<std::string_view> collision_kinds(std::vector<std::string_view> own);

  const Pair& pair(PairId p) const { return pairs_[p]; }
  std::size_t pairs() const { return pairs_.size(); }
  // Replaces the certificates of the pair: slot i gets queries[i]. A query that equals an old one
  // takes over its certificate.
  void set_certificates(PairId p, std::span<const Query> queries);
  // A feature of a body: vertex or edge `i` of the polygon of its frame.
  struct Feature {
    bool edge = false;
    std::uint32_t i = 0;
  };
  struct Features {  // a feature of each body
    Feature of_a, of_b;
  };
  // The state of a proof of disjointness, for visit_proof: fills in kind, text and marks of the
  // group, and returns the role of each certificate, by slot.
  using Roles = std::array<std::string_view, kMostCertificates>;
  virtual Roles describe(PairId p, ProofGroup& group) const = 0;
  // A proof of one certificate on volumes.
  Roles describe_volumes(PairId p, ProofGroup& group) const;
  PolygonFeature polygon_feature(PairId p, std::uint8_t z, const Feature& feature) const;
  // "a.v3", "a.e3".
  std::string feature_name(const PolygonFeature& feature) const;
  const std::string& body_name(PairId p, std::uint8_t z) const {
    return scene_.objects[z == 0 ? pairs_[p].a : pairs_[p].b].id;
  }
  // The features by which the bodies touch right after now, or at now; nullopt: they do not
  // touch. Requires that the proof holds right after now.
  virtual std::optional<Features> touch(PairId pair, When when) = 0;
  Sign sign(const Query& query, When when) {
    return kernel_.sign(query, when);
  }
  // Reports the contact: the proof of disjointness ends, the overlap proof begins. `near`: features
  // near those that meet, those of the second body in its negated frame. If the bodies do not
  // overlap after all (certificates can mislead at an instant at which edges become parallel), the
  // proof is started anew and an event of the derived class's first kind is reported.
  void contact(PairId p, const Features& near);
  // The boundary of the sum of the two bodies.
  SumBoundary boundary(PairId p);
  // Failures that were handled while the two bodies overlapped.
  std::uint64_t failures_in_contact() const { return failures_in_contact_; }
  void report(PairId p, std::uint8_t kind) {
    kernel_.report(id_, kind, {pairs_[p].a, pairs_[p].b}, false);
  }
  void report_rebuild(const std::string& reason) { kernel_.count_rebuild(id_, reason); }

  Kernel& kernel_;
  const StructureId id_;
  const Scene& scene_;
  BodyFrames frames_;
  BodyVolumes volumes_;
  PosePredicates predicates_;

 private:
  static constexpr PairId kNoPair = 0xffffffffu;
  void add_body(ObjectId object);
  PairId find_pair(ObjectId a, ObjectId b) const;
  // Adds the new pairs of this body that are near; removes those that are no longer near.
  void update_pairs(ObjectId body);
  void follow_near(PairId p);
  PairId add_pair(ObjectId a, ObjectId b);
  void remove_pair(PairId p);
  void follow(PairId p);  // by the derived class's proof
  void add_pose(PairId p);
  // The pair's certificate touches zero without failing: it is made anew.
  bool only_touches(CertificateId failed);
  bool holds(PairId p) const;
  void look_for_touch(PairId p);
  void report_meeting(PairId p, std::uint8_t kind, const Features& features);
  void report_overlap(PairId p);
  void report_overlaps(ObjectId object);
  void drop_certificates(PairId p);
  // While the bodies overlap:
  OverlapProof overlap_proof(const SumBoundary& sum, PairId p);
  std::optional<SumBoundary::Edge> edge_ahead(PairId p, const Features& near);
  Features features_at(PairId p, const SumBoundary::Edge& edge);
  void follow_overlap(PairId p, const std::optional<SumBoundary::Edge>& ahead);
  bool follow_discs_within(PairId p);
  Roles describe_overlap(PairId p, ProofGroup& group) const;
  void fail_in_contact(PairId p, std::uint32_t slot);
  bool is_stuck(PairId p);
  void start_anew(PairId p);
  void move_in_contact(PairId p);
  void part(PairId p, const SumBoundary::Edge& edge);
  ObjectId feature_object(ObjectId body, bool negated, Feature feature);

  std::shared_ptr<const Construction> pose_;
  std::vector<Pair> pairs_;
  std::vector<PairId> free_;
  std::vector<ObjectId> free_poses_;
  // The features named by events: per body, 4 for each place in its frame (kNoObject: not made
  // yet).
  std::vector<std::vector<ObjectId>> features_;
  std::optional<RayPredicates> rays_;  // from the first contact on
  std::optional<BodyGrid> grid_;
  std::vector<std::vector<PairId>> pairs_of_;  // per body
  std::vector<PairId> had_;                    // in contact before the last update_pairs
  std::vector<std::uint8_t> alive_;
  CertificateId failed_ = kNoCertificate;  // while it is handled
  std::uint64_t failures_in_contact_ = 0;
  std::uint32_t most_of_pair_ = 0;  // certificates
  std::size_t live_pairs_ = 0, most_pairs_ = 0, most_bodies_ = 0, bodies_ = 0;
};

}  // namespace kinex

#endif
