// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/static_norm_audit.h"

#include <algorithm>
#include <utility>

namespace kinex {
namespace {

StaticUnit step(const Snapshot& snapshot, ObjectId a, ObjectId b) {
  return {snapshot.position(b, 0) - snapshot.position(a, 0),
          snapshot.position(b, 1) - snapshot.position(a, 1)};
}

Rational product(const StaticUnit& u, const StaticUnit& v) { return u[0] * v[0] + u[1] * v[1]; }

// Without its sign: that of the first part that is not zero.
StaticLength size_of(StaticLength parts) {
  for (const Rational& part : parts) {
    if (part.is_zero()) continue;
    if (part.sign() > 0) return parts;
    for (Rational& each : parts) each = -each;
    return parts;
  }
  return parts;
}

}  // namespace

Rational static_norm(const Snapshot& snapshot, std::span<const StaticUnit> units, ObjectId a,
                     ObjectId b) {
  const StaticUnit v = step(snapshot, a, b);
  Rational length;
  for (const StaticUnit& u : units) {
    Rational one = product(u, v);
    if (one.sign() < 0) one = -one;
    if (length < one) length = std::move(one);
  }
  return length;
}

StaticLength static_norm_length(const Snapshot& snapshot, std::span<const StaticUnit> units,
                                ObjectId a, ObjectId b) {
  const StaticUnit v = step(snapshot, a, b);
  const Rational ids(static_cast<int>(b - a));
  StaticLength largest;
  for (const StaticUnit& u : units) {
    largest = std::max(
        largest, size_of({product(u, v), product(u, {-v[1], v[0]}), product(u, {ids + ids, ids})}));
  }
  return largest;
}

std::vector<ObjectId> static_nearest_maximum_norm(
    const Snapshot& snapshot, const std::function<bool(ObjectId, ObjectId)>& counts) {
  const std::array<StaticUnit, 2> units{StaticUnit{1, 0}, StaticUnit{0, 1}};
  std::vector<ObjectId> nearest;
  StaticLength best;
  for (ObjectId a = 0; a < snapshot.objects(); ++a) {
    for (ObjectId b = a + 1; b < snapshot.objects(); ++b) {
      if (!snapshot.alive(a) || !snapshot.alive(b) || !counts(a, b)) continue;
      if (!nearest.empty() && best[0] < static_norm(snapshot, units, a, b)) continue;
      StaticLength length = static_norm_length(snapshot, units, a, b);
      if (!nearest.empty() && !(length < best)) continue;
      best = std::move(length);
      nearest = {a, b};
    }
  }
  return nearest;
}

}  // namespace kinex
