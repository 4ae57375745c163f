// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/static_closest_pair_audit.h"

#include <algorithm>
#include <utility>

namespace kinex {

std::vector<ObjectId> static_closest_pair(const Snapshot& snapshot,
                                          const std::function<bool(ObjectId, ObjectId)>& counts) {
  std::vector<ObjectId> along, closest;
  for (ObjectId id = 0; id < snapshot.objects(); ++id) {
    if (snapshot.alive(id)) along.push_back(id);
  }
  std::sort(along.begin(), along.end(), [&](ObjectId a, ObjectId b) {
    return snapshot.position(a, 0) < snapshot.position(b, 0);
  });
  Rational best;
  for (std::size_t i = 0; i < along.size(); ++i) {
    for (std::size_t j = i + 1; j < along.size(); ++j) {
      const auto squared = [&](int axis) {
        const Rational d = snapshot.position(along[j], axis) - snapshot.position(along[i], axis);
        return d * d;
      };
      Rational distance = squared(0);
      if (!closest.empty() && best < distance) break;
      if (counts && !counts(along[i], along[j])) continue;
      for (int axis = 1; axis < snapshot.dimension(); ++axis) distance += squared(axis);
      std::vector<ObjectId> pair{std::min(along[i], along[j]), std::max(along[i], along[j])};
      if (closest.empty() || distance < best || (distance == best && pair < closest)) {
        best = distance;
        closest = std::move(pair);
      }
    }
  }
  return closest;
}

}  // namespace kinex
