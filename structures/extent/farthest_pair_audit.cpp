// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/farthest_pair_audit.h"

namespace kinex {

std::vector<ObjectId> static_farthest_pair(const Snapshot& snapshot) {
  std::vector<ObjectId> farthest;
  Rational most;
  for (ObjectId a = 0; a < snapshot.objects(); ++a) {
    if (!snapshot.alive(a)) continue;
    for (ObjectId b = a + 1; b < snapshot.objects(); ++b) {
      if (!snapshot.alive(b)) continue;
      Rational distance;
      for (int axis = 0; axis < snapshot.dimension(); ++axis) {
        const Rational d = snapshot.position(b, axis) - snapshot.position(a, axis);
        distance += d * d;
      }
      if (!farthest.empty() && !(most < distance)) continue;
      most = distance;
      farthest = {a, b};
    }
  }
  return farthest;
}

}  // namespace kinex
