// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/parts/key_value.h"

#include <algorithm>

namespace kinex {

Rational key_value(const Key& key, const Snapshot& snapshot, ObjectId object) {
  if (key.kind == Key::Kind::kCoordinate) return snapshot.position(object, key.axis);
  Rational sum;
  for (int axis = 0; axis < snapshot.dimension(); ++axis) {
    const Rational& x = snapshot.position(object, axis);
    if (key.kind == Key::Kind::kDirection) {
      sum += key.direction[static_cast<std::size_t>(axis)] * x;
    } else {
      const Rational d = x - snapshot.position(key.object, axis);
      sum += d * d;
    }
  }
  return sum;
}

std::vector<std::pair<Rational, ObjectId>> sorted_keys(const Key& key, const Snapshot& snapshot,
                                                       std::size_t objects) {
  std::vector<std::pair<Rational, ObjectId>> result;
  for (ObjectId id = 0; id < objects; ++id) {
    if (!snapshot.alive(id)) continue;
    if (key.kind == Key::Kind::kSquaredDistance && id == key.object) continue;
    result.emplace_back(key_value(key, snapshot, id), id);
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace kinex
