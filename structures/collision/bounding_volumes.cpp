// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/collision/bounding_volumes.h"

namespace kinex {

SeparationProof::Repair BoundingVolumes::repair(PairId p, std::uint32_t slot) {
  if (!pairs_.is_by_volume(p) && !near_.is_disc_slot(p, slot)) return near_.repair(p, slot);
  if (start(p, nullptr)) return Repair::changed(CollisionEvent::kVolume);
  pairs_.kernel().corrupt(pairs_.id(), "the bodies meet although a volume was between them");
  return {};
}

}  // namespace kinex
