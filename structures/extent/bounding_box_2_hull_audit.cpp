// SPDX-License-Identifier: GPL-3.0-or-later
// BoundingBox2Hull: its audit, the extreme coordinates by exact comparison of all points.
#include "core/numbers/rational.h"
#include "structures/extent/bounding_box_2_hull.h"
#include "structures/extent/static_box_audit.h"

namespace kinex {

void BoundingBox2Hull::audit(const Snapshot& snapshot, AuditReport& report) const {
  const std::vector<ObjectId> extreme = static_box(snapshot);
  report.check(extreme.size() == box_.size(), [] { return "there is no box, or no point in it"; });
  for (std::size_t side = 0; side < box_.size() && side < extreme.size(); ++side) {
    const int axis = static_cast<int>(side / 2);
    report.check(snapshot.position(box_[side], axis) == snapshot.position(extreme[side], axis),
                 [] { return "another point is extreme"; });
  }
}

}  // namespace kinex
