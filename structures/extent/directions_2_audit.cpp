// SPDX-License-Identifier: GPL-3.0-or-later
// Directions2: its audit: the extreme objects by exact comparison of all, the polygon against
// CGAL's hull of these, and the guarantees on diameter and width.
#include <string>

#include "structures/extent/directions_2.h"
#include "structures/extent/extent_guarantees_audit.h"

namespace kinex {

void Directions2::audit(const Snapshot& snapshot, AuditReport& report) const {
  std::vector<DirectionVector> directions = unit_directions_2(k_);
  for (std::size_t i = 0, half = directions.size(); i < half; ++i) {
    directions.push_back({-directions[i][0], -directions[i][1]});
  }
  Snapshot extreme(snapshot.time(), 2, 2, snapshot.objects());
  for (std::size_t i = 0; i < directions.size(); ++i) {
    ObjectId best = kNoObject;
    Rational most;
    for (const ObjectId id : living(snapshot)) {
      Rational along = directions[i][0] * snapshot.position(id, 0) +
                       directions[i][1] * snapshot.position(id, 1);
      if (best == kNoObject || most < along) {
        best = id;
        most = std::move(along);
      }
    }
    report.check(best == maxima_->winner(i), [i] {
      return "another object is extreme in direction " + std::to_string(i);
    });
    if (best == kNoObject) continue;
    for (const int axis : {0, 1}) extreme.set(best, axis, snapshot.position(best, axis));
  }
  HullSource::audit(extreme, report);
  guarantee_diameter(k_, attribute().ids, snapshot, report);
  guarantee_width(k_, attribute().ids, snapshot, report);
}

}  // namespace kinex
