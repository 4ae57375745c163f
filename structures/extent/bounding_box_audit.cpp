// SPDX-License-Identifier: GPL-3.0-or-later
// BoundingBox: its audit, the extreme points by exact comparison of all.
#include <vector>

#include "core/numbers/rational.h"
#include "structures/extent/bounding_box.h"

namespace kinex {

void BoundingBox::audit(const Snapshot& snapshot, AuditReport& report) const {
  std::vector<ObjectId> expected;
  for (int axis = 0; axis < snapshot.dimension(); ++axis) {
    ObjectId least = kNoObject, most = kNoObject;
    for (ObjectId id = 0; id < snapshot.objects(); ++id) {
      if (!snapshot.alive(id)) continue;
      const Rational& x = snapshot.position(id, axis);
      if (least == kNoObject || x < snapshot.position(least, axis)) least = id;
      if (most == kNoObject || snapshot.position(most, axis) < x) most = id;
    }
    if (least != kNoObject) expected.insert(expected.end(), {least, most});
  }
  report.check(expected == box_, [] { return "the extreme points are others"; });
}

}  // namespace kinex
