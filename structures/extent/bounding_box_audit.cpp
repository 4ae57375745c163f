// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/bounding_box_audit.h"

#include "core/numbers/rational.h"
#include "structures/extent/bounding_box.h"

namespace kinex {

void audit_box(const std::vector<ObjectId>& box, const Snapshot& snapshot, AuditReport& report) {
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
  report.check(expected == box, [] { return "other points are extreme"; });
}

void BoundingBox::audit(const Snapshot& snapshot, AuditReport& report) const {
  audit_box(box_, snapshot, report);
}

}  // namespace kinex
