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
#include <string_view>
#include <vector>

#include "structures/collision/closest_features.h"

namespace kinex {

class BoundingVolumes final : public ClosestFeatures {
 public:
  BoundingVolumes(Kernel& kernel, StructureId id, const Scene& scene);

  std::string_view name() const override { return "bounding_volumes"; }
  std::size_t bytes() const override;

 protected:
  Roles describe(PairId p, ProofGroup& group) const override;
  bool start(PairId p) override;
  void fail(PairId p, std::uint32_t slot) override;
  std::optional<Features> touch(PairId p, When when) override;
  std::uint32_t most_certificates() const override { return 6; }
  std::optional<Query> extra(PairId p) override;

 private:
  bool put_volume(PairId p);

  std::vector<std::uint8_t> near_;  // per pair
};

}  // namespace kinex

#endif
