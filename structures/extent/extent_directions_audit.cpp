// SPDX-License-Identifier: GPL-3.0-or-later
// ExtentDirections: its audit: the best extent by exact comparison of all, and its guarantee.
#include <algorithm>
#include <string>

#include "structures/extent/extent_directions.h"
#include "structures/extent/extent_guarantees_audit.h"

namespace kinex {

void ExtentDirections::audit(const Snapshot& snapshot, AuditReport& report) const {
  const std::vector<ObjectId> all = living(snapshot);
  std::vector<ObjectId> expected;
  Rational best;
  bool first = true;
  for (const DirectionVector& u : unit_directions_2(k_)) {
    ObjectId high = kNoObject, low = kNoObject;
    Rational most, least;
    for (const ObjectId id : all) {
      const Rational along = u[0] * snapshot.position(id, 0) + u[1] * snapshot.position(id, 1);
      if (high == kNoObject || most < along) high = id, most = along;
      if (low == kNoObject || along < least) low = id, least = along;
    }
    const Rational extent = most - least;
    if (!first && !(maximum() ? best < extent : extent < best)) continue;
    first = false;
    best = extent;
    expected.clear();
    if (!extent.is_zero()) expected = {std::min(high, low), std::max(high, low)};
  }
  report.check(expected == ends(), [] { return std::string("another extent is the best"); });
  const std::vector<ObjectId> hull = exact_hull(snapshot, all);
  const Rational diameter = squared_diameter(snapshot, hull), square = best * best;
  const Rational grown(Integer(k_) * Integer(k_) + Integer(1));
  const auto beyond = [] { return std::string("the extent is beyond its guarantee"); };
  if (maximum()) {
    const Rational chord = squared_diameter(snapshot, expected);
    report.check(!(diameter < chord) && !(chord < square) &&
                     !(square * grown < diameter * (grown - Rational(1))),
                 beyond);
  } else {
    const Rational width = squared_width(snapshot, hull);
    report.check(!(square < width) && root_at_most_sum(square, width, diameter / grown), beyond);
  }
}

}  // namespace kinex
