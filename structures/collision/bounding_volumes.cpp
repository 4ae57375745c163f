// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/collision/bounding_volumes.h"

namespace kinex {

BoundingVolumes::BoundingVolumes(Kernel& kernel, StructureId id, const Scene& scene)
    : ClosestFeatures(kernel, id, scene) {}

bool BoundingVolumes::put_volume(PairId p) {
  const auto proof = volumes_.proof(pair(p).a, pair(p).b);
  near_[p] = proof ? 0 : 1;
  if (proof) set_certificates(p, {&*proof, 1});
  return proof.has_value();
}

bool BoundingVolumes::start(PairId p) {
  if (near_.size() <= p) near_.resize(p + std::size_t{1}, 0);
  return put_volume(p) || ClosestFeatures::start(p);
}

std::optional<Query> BoundingVolumes::extra(PairId p) {
  return volumes_.discs_overlap(pair(p).a, pair(p).b);
}

// Volumes are larger than the bodies: while one is the proof, the bodies do not touch.
std::optional<CollisionPairs::Features> BoundingVolumes::touch(PairId p, When when) {
  if (near_[p] == 0) return std::nullopt;
  return ClosestFeatures::touch(p, when);
}

void BoundingVolumes::fail(PairId p, std::uint32_t slot) {
  const bool parted = near_[p] != 0 && slot == extra_slot(p);
  if (near_[p] != 0 && !parted) {
    ClosestFeatures::fail(p, slot);
    return;
  }
  if (!put_volume(p) && !ClosestFeatures::start(p)) {
    kernel_.corrupt(id_, "the bodies meet although a volume was between them");
    return;
  }
  report(p, kVolume);
}

std::size_t BoundingVolumes::bytes() const { return ClosestFeatures::bytes() + near_.capacity(); }

}  // namespace kinex
