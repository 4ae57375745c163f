// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/static_box_audit.h"

#include "core/numbers/rational.h"

namespace kinex {

std::vector<ObjectId> static_box(const Snapshot& snapshot) {
  std::vector<ObjectId> box;
  for (int axis = 0; axis < snapshot.dimension(); ++axis) {
    ObjectId least = kNoObject, most = kNoObject;
    for (ObjectId id = 0; id < snapshot.objects(); ++id) {
      if (!snapshot.alive(id)) continue;
      const Rational& x = snapshot.position(id, axis);
      if (least == kNoObject || x < snapshot.position(least, axis)) least = id;
      if (most == kNoObject || snapshot.position(most, axis) < x) most = id;
    }
    if (least != kNoObject) box.insert(box.end(), {least, most});
  }
  return box;
}

}  // namespace kinex
