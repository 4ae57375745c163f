// SPDX-License-Identifier: GPL-3.0-or-later
// BoundingBox2Hull: its audit, the extreme coordinates by exact comparison of all points.
#include "core/numbers/rational.h"
#include "structures/extent/bounding_box_2_hull.h"

namespace kinex {

void BoundingBox2Hull::audit(const Snapshot& snapshot, AuditReport& report) const {
  for (ObjectId id = 0; id < snapshot.objects(); ++id) {
    if (!snapshot.alive(id)) continue;
    report.check(!box_.empty(), [] { return "there is no box"; });
    for (std::size_t side = 0; side < box_.size(); ++side) {
      const int axis = static_cast<int>(side / 2);
      const Rational& extreme = snapshot.position(box_[side], axis);
      const Rational& x = snapshot.position(id, axis);
      report.check(side % 2 == 0 ? !(x < extreme) : !(extreme < x),
                   [] { return "a point is outside the box"; });
    }
  }
}

}  // namespace kinex
