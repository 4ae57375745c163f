// SPDX-License-Identifier: GPL-3.0-or-later
// ExtentDirections: its audit: the best extent by exact comparison of all, and its guarantee.
#include <algorithm>
#include <string>

#include "predicates/points/unit_directions_3.h"
#include "structures/extent/extent_directions.h"
#include "structures/extent/extent_guarantees_audit.h"

namespace kinex {

void ExtentDirections::audit(const Snapshot& snapshot, AuditReport& report) const {
  const std::vector<ObjectId> all = living(snapshot);
  std::vector<ObjectId> expected;
  Rational best;
  bool first = true;
  for (const DirectionVector& u : unit_directions(k_, dimension_)) {
    ObjectId high = kNoObject, low = kNoObject;
    Rational most, least;
    for (const ObjectId id : all) {
      Rational along;
      for (int axis = 0; axis < dimension_; ++axis) {
        along += u[static_cast<std::size_t>(axis)] * snapshot.position(id, axis);
      }
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
  report.check(expected == attribute().ids,
               [] { return std::string("another extent is the best"); });
  // In space the farthest pair is that of all pairs.
  const std::vector<ObjectId> hull = dimension_ == 2 ? exact_hull(snapshot, all) : all;
  const Rational diameter = squared_diameter(snapshot, hull), square = best * best;
  const Rational grown(Integer(k_) * Integer(k_) + Integer(1));
  const auto beyond = [] { return std::string("the extent is beyond its guarantee"); };
  if (maximum()) {
    const Rational chord = squared_diameter(snapshot, expected);
    // k^2 / (k^2 + 1) in the plane, (1 - 1/k^2)^2 in space.
    const Rational inner = Rational(1) - Rational(1) / (grown - Rational(1));
    const Rational proven = dimension_ == 2 ? (grown - Rational(1)) / grown : inner * inner;
    report.check(!(diameter < chord) && !(chord < square) && !(square < diameter * proven), beyond);
  } else {
    const Rational width = squared_width(snapshot, hull);
    report.check(!(square < width) && root_at_most_sum(square, width, diameter / grown), beyond);
  }
}

}  // namespace kinex
