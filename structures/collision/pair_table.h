// SPDX-License-Identifier: GPL-3.0-or-later
// PairTable: the pairs of bodies that a structure for collisions follows: their states, their poses,
// and the certificates of their proofs.
//
// A pair has one proof at a time. Its certificates belong to one part of the structure, whose tags
// are those of the table: eight to a pair, one for each place in the proof.
#ifndef KINEX_STRUCTURES_COLLISION_PAIR_TABLE_H
#define KINEX_STRUCTURES_COLLISION_PAIR_TABLE_H

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/engine/kernel.h"
#include "core/engine/proof.h"
#include "core/motion/scene.h"
#include "predicates/bodies/body_frames.h"
#include "predicates/bodies/body_volumes.h"
#include "predicates/bodies/pose_predicates.h"
#include "structures/collision/sum_boundary.h"
#include "structures/parts/slots.h"

namespace kinex {

using PairId = std::uint32_t;  // the index of a pair of bodies
// No pair.
inline constexpr PairId kNoPair = 0xffffffffu;

// Two bodies whose volumes are near, and the proof that is maintained of them.
struct BodyPair {
  static constexpr std::uint32_t kMostCertificates = 8;  // of a proof
  // What is known of the two bodies right after now, and by which proof.
  enum class State : std::uint8_t {
    kFree,      // not in use
    kFar,       // apart: one certificate on volumes
    kApart,     // apart: the proof of the structure
    kResting,   // the same, and they touch over a time interval
    kOverlap,   // in contact: the overlap proof
    kInner,     // in contact: discs within the bodies overlap
    kUnproved,  // in contact: an inexact arithmetic has no proof
  };
  struct Repairs {              // of the proof of the structure, at one instant
    std::uint64_t instant = 0;  // Kernel::instant_number
    std::uint32_t count = 0;
  };

  ObjectId a = kNoObject, b = kNoObject;  // a < b
  ObjectId pose = kNoObject;              // kNoObject: not needed yet
  State state = State::kFree;
  std::uint8_t certificates = 0;
  SumBoundary::Edge ahead{};  // in contact: the edge ahead (overlap_proof.h)
  Repairs repairs;
  Slots* part = nullptr;  // of the certificates; nullptr: there are none
  std::array<CertificateId, kMostCertificates> slots = no_certificates();

  bool in_use() const { return state != State::kFree; }
  bool is_apart() const { return state == State::kApart || state == State::kResting; }
  bool in_contact() const { return state >= State::kOverlap; }
  std::span<const CertificateId> proof() const { return {slots.data(), certificates}; }

 private:
  static constexpr std::array<CertificateId, kMostCertificates> no_certificates() {
    std::array<CertificateId, kMostCertificates> none{};
    none.fill(kNoCertificate);
    return none;
  }
};

class PairTable {
 public:
  // Keeps a reference to the scene.
  PairTable(Kernel& kernel, StructureId id, const Scene& scene, CutPolicy policy);
  PairTable(const PairTable&) = delete;
  PairTable& operator=(const PairTable&) = delete;

  Kernel& kernel() const { return kernel_; }
  StructureId id() const { return id_; }
  const Scene& scene() const { return scene_; }
  BodyFrames& frames() { return frames_; }
  const BodyFrames& frames() const { return frames_; }
  BodyVolumes& volumes() { return volumes_; }
  const PosePredicates& predicates() const { return predicates_; }

  // ---- pairs
  std::size_t size() const { return pairs_.size(); }
  BodyPair& operator[](PairId p) { return pairs_[p]; }
  const BodyPair& operator[](PairId p) const { return pairs_[p]; }
  // The pairs of a body, in no particular but reproducible order.
  const std::vector<PairId>& of(ObjectId body) const { return of_body_[body]; }
  // O(pairs of the body); kNoPair: it is not followed.
  PairId find(ObjectId a, ObjectId b) const;
  PairId add(ObjectId a, ObjectId b);
  // Withdraws its certificates.
  void remove(PairId p);
  // Derives its pose, unless there is one.
  void make_pose(PairId p);
  // The boundary of the sum of the two bodies. Requires a pose.
  SumBoundary boundary(PairId p);

  // ---- certificates
  // The proof of the pair from now on, of this part: slot i gets queries[i]. A query that equals one
  // of the proof so far takes over its certificate, unless that has failed.
  void set(PairId p, Slots& part, std::span<const Query> queries);
  // A proof of one certificate on volumes that the bodies are apart; false: there is none.
  bool set_volume(PairId p);
  bool is_by_volume(PairId p) const { return pairs_[p].part == &by_volume_; }
  void drop(PairId p);
  // Makes the same certificate anew.
  void renew(PairId p, std::uint32_t slot) {
    CertificateId& c = pairs_[p].slots[slot];
    pairs_[p].part->set(c, kernel_.query(c), tag(p, slot));
  }
  // All certificates of the pair hold right after now.
  bool holds(PairId p) const;
  // A certificate of the table has failed. Where it was; until handled(), it has left the queue.
  struct Place {
    PairId pair;
    std::uint32_t slot;
  };
  Place failed(CertificateId c);
  void handled() { failed_ = kNoCertificate; }

  // ---- names
  const std::string& name(PairId p, std::uint8_t z) const {
    return scene_.objects[z == 0 ? pairs_[p].a : pairs_[p].b].id;
  }
  // A feature of body z of the pair, in the scene's list of vertices; a frame's list begins elsewhere.
  PolygonFeature feature(PairId p, std::uint8_t z, const Feature& feature) const;
  std::string feature_name(const PolygonFeature& feature) const;  // "a.v3", "a.e3"
  // The same as an object, for events.
  ObjectId feature_object(PairId p, std::uint8_t z, const Feature& feature);
  // The state of a proof for ProofVisitors: fills in kind, text and marks of the group, and returns
  // the role of each certificate, by slot. This one: of one certificate on volumes.
  using Roles = std::array<std::string_view, BodyPair::kMostCertificates>;
  Roles describe_volumes(PairId p, ProofGroup& group) const;

  // ---- checks
  std::uint32_t most_certificates() const { return most_certificates_; }  // of a pair, so far
  std::size_t most_pairs() const { return most_pairs_; }                  // at a time, so far
  bool check_tags(PairId p) const;
  std::size_t bytes() const;

 private:
  static std::uint32_t tag(PairId p, std::size_t slot) {
    return p * BodyPair::kMostCertificates + static_cast<std::uint32_t>(slot);
  }

  Kernel& kernel_;
  const StructureId id_;
  const Scene& scene_;
  BodyFrames frames_;
  BodyVolumes volumes_;
  PosePredicates predicates_;
  Slots by_volume_;
  std::shared_ptr<const Construction> pose_;
  std::vector<BodyPair> pairs_;
  std::vector<PairId> free_;
  std::vector<ObjectId> free_poses_;
  std::vector<std::vector<PairId>> of_body_;
  // The features named by events: per body, 4 for each place in its frame (kNoObject: not made yet).
  std::vector<std::vector<ObjectId>> features_;
  CertificateId failed_ = kNoCertificate;
  std::uint32_t most_certificates_ = 0;
  std::size_t live_pairs_ = 0, most_pairs_ = 0;
};

}  // namespace kinex

#endif
