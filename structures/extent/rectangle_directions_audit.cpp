// SPDX-License-Identifier: GPL-3.0-or-later
// RectangleDirections: its audit: the best box by exact comparison of all, and its guarantee.
#include <string>

#include "predicates/points/unit_directions.h"
#include "structures/extent/extent_guarantees_audit.h"
#include "structures/extent/rectangle_directions.h"

namespace kinex {
namespace {

struct Extent {
  ObjectId high = kNoObject, low = kNoObject;
  Rational length;
};

Extent extent_along(const DirectionVector& u, const Snapshot& now) {
  Extent result;
  Rational most, least;
  for (const ObjectId id : living(now)) {
    const Rational along = u[0] * now.position(id, 0) + u[1] * now.position(id, 1);
    if (result.high == kNoObject || most < along) result.high = id, most = along;
    if (result.low == kNoObject || along < least) result.low = id, least = along;
  }
  result.length = most - least;
  return result;
}

}  // namespace

void RectangleDirections::audit(const Snapshot& snapshot, AuditReport& report) const {
  const std::vector<DirectionVector> directions = unit_directions_2(k_);
  std::vector<ObjectId> expected;
  Rational best;
  for (std::size_t i = 0; i < count(); ++i) {
    const Extent along = extent_along(directions[i], snapshot);
    const Extent across = extent_along(directions[i + count()], snapshot);
    const Rational size =
        is_area() ? along.length * across.length : along.length + across.length;
    if (i != 0 && !(size < best)) continue;
    best = size;
    expected = {along.high, along.low, across.high, across.low};
    if (along.length.is_zero() && across.length.is_zero()) expected.clear();
  }
  report.check(expected == attribute().ids,
               [] { return std::string("another box is the smallest"); });
  const std::vector<ObjectId> hull = exact_hull(snapshot, living(snapshot));
  const Rational square(Integer(k_) * Integer(k_)), one(1);
  const auto beyond = [] { return std::string("the rectangle is beyond its guarantee"); };
  if (is_area()) {
    const Rational least = least_area(snapshot, hull);
    const Rational error =
        Rational(2 * k_) * squared_diameter(snapshot, hull) / (square + one);
    report.check(!(best < least) && !(least + error < best), beyond);
  } else {
    const Rational least = squared_half_perimeter(snapshot, hull), found = best * best;
    report.check(!(found < least) &&
                     !(least * Rational(k_ + 1) * Rational(k_ + 1) < found * (square + one)),
                 beyond);
  }
}

}  // namespace kinex
