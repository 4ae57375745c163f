// SPDX-License-Identifier: GPL-3.0-or-later
// CollisionPairs: what all structures for collisions of convex polygons have in common.
//
// Every pair of bodies that are not in contact has a proof that they are disjoint, which a derived
// class keeps: a handful of certificates in the pair's pose (predicates/pose_2.h). The attribute is
// the set of pairs that have come into contact; an external event is a contact. A pair in contact
// has no certificates; when the motion of one of its bodies changes and they are disjoint right
// after it, it is followed again.
//
// Ties. A pair that touches without penetrating (the distance is zero at one instant, or for a
// while along an edge, and never negative) has no contact: its certificates never become negative.
#ifndef KINEX_STRUCTURES_COLLISION_PAIRS_H
#define KINEX_STRUCTURES_COLLISION_PAIRS_H

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/kernel.h"
#include "core/scene.h"
#include "core/structure.h"
#include "structures/body_frames.h"

namespace kinex {

using PairId = std::uint32_t;

class CollisionPairs : public Structure {
 public:
  // The rank of "contact"; the kinds of derived classes follow it. A contact names the two bodies
  // and the features that meet, as derived objects: "a.v3" is vertex 3 of body a, "a.e3" the edge
  // from it to the next (counted from 0 in the scene's order).
  static constexpr std::uint8_t kContact = 0;
  // A proof has at most so many certificates.
  static constexpr std::uint32_t kMostCertificates = 8;

  CollisionPairs(Kernel& kernel, StructureId id, const Scene& scene, CutPolicy policy);

  void build(std::span<const ObjectId> objects) override;
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  Attribute attribute() const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  // False where a body's rotor vanishes: beyond the end of its flight plan.
  bool holds_at(const Snapshot& snapshot) const override;
  std::size_t bytes() const override;

 protected:
  struct Pair {
    ObjectId a = kNoObject, b = kNoObject;  // a < b; kNoObject: not in use
    ObjectId pose = kNoObject;
    bool touching = false;
    std::uint8_t certificates = 0;
    std::array<CertificateId, kMostCertificates> certificate{};
  };

  // Makes a proof for the pair right after now; false if the bodies are not disjoint there.
  virtual bool start(PairId pair) = 0;
  // The certificate of this slot is negative right after now: repairs the proof and reports one
  // event, or calls contact().
  virtual void fail(PairId pair, std::uint32_t slot) = 0;
  // The pair is followed no more; its certificates are retracted afterwards.
  virtual void stop(PairId pair) { static_cast<void>(pair); }
  // The largest number of certificates that a proof has between events.
  virtual std::uint32_t most_certificates() const = 0;

  const Pair& pair(PairId p) const { return pairs_[p]; }
  std::size_t pairs() const { return pairs_.size(); }
  // Puts these certificates in the place of those that the pair has: slot i is queries[i]. One that
  // says the same as an old one takes that over.
  void set_certificates(PairId p, std::span<const Query> queries);
  // A feature of a body: vertex or edge `i` of the polygon of its frame.
  struct Feature {
    bool edge = false;
    std::uint32_t i = 0;
  };
  // Reports the contact and ends the proof. Features of the second body are those of its negated
  // frame.
  void contact(PairId p, Feature of_a, Feature of_b);
  void report(PairId p, std::uint8_t kind) {
    kernel_.report(id_, kind, {pairs_[p].a, pairs_[p].b}, false);
  }
  void report_rebuild(const std::string& reason) { kernel_.count_rebuild(id_, reason); }

  Kernel& kernel_;
  const StructureId id_;
  const Scene& scene_;
  BodyFrames frames_;

 private:
  PairId add_pair(ObjectId a, ObjectId b);
  void remove_pair(PairId p);
  void follow(PairId p);
  void drop_certificates(PairId p);
  ObjectId feature_object(ObjectId body, bool negated, Feature feature);

  std::shared_ptr<const Construction> pose_;
  std::vector<Pair> pairs_;
  std::vector<PairId> free_;
  std::vector<std::vector<PairId>> pairs_of_;  // per body
  std::vector<std::uint8_t> alive_;
  CertificateId failed_ = kNoCertificate;  // while it is handled
  std::size_t live_pairs_ = 0, most_pairs_ = 0;
};

}  // namespace kinex

#endif
