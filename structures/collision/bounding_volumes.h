// SPDX-License-Identifier: GPL-3.0-or-later
// BoundingVolumes: collision detection by squares and discs around the bodies, and by the pair of
// closest features where the discs overlap. A baseline.
//
// The volumes do not turn: a disc about the frame's origin that holds the body however it turns,
// and the square around that disc. Certificates of a pair:
//   squares apart on an axis, or discs apart    1: that gap
//   discs overlap                               those of ClosestFeatures, and 1 that the discs
//                                               overlap, which fails when they part
// Compactness: 1 certificate for a pair far apart, at most 6 for one that is near. Responsiveness:
// O(1) signs, O(n) when the discs begin to overlap. Events: changes of volumes, and near contact
// those of ClosestFeatures. Ties: those of CollisionPairs.
#ifndef KINEX_STRUCTURES_COLLISION_BOUNDING_VOLUMES_H
#define KINEX_STRUCTURES_COLLISION_BOUNDING_VOLUMES_H

#include <cstdint>
#include <optional>

#include "structures/collision/closest_features.h"
#include "structures/collision/separation_proof.h"

namespace kinex {

class BoundingVolumes final : public SeparationProof {
 public:
  explicit BoundingVolumes(PairTable& pairs) : pairs_(pairs), near_(pairs, true) {}

  bool start(PairId p, const Edge* left) override {
    return pairs_.set_volume(p) || near_.start(p, left);
  }
  Repair repair(PairId p, std::uint32_t slot) override;
  // Volumes are larger than the bodies: while one is the proof, the bodies do not touch.
  std::optional<Features> touch(PairId p, When when) override {
    return pairs_.is_by_volume(p) ? std::nullopt : near_.touch(p, when);
  }
  Roles describe(PairId p, ProofGroup& group) const override {
    return pairs_.is_by_volume(p) ? pairs_.describe_volumes(p, group) : near_.describe(p, group);
  }
  std::uint32_t most_certificates() const override { return near_.most_certificates(); }
  std::size_t bytes() const override { return near_.bytes(); }

 private:
  PairTable& pairs_;
  ClosestFeatures near_;
};

}  // namespace kinex

#endif
