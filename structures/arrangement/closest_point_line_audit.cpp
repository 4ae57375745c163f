// SPDX-License-Identifier: GPL-3.0-or-later
// The witness: distances of all lines and points in CGAL's exact kernel.
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>

#include "core/engine/audit.h"
#include "structures/arrangement/closest_point_line.h"

namespace kinex {

namespace {

using ExactPlane = CGAL::Simple_cartesian<CGAL::Gmpq>;

}  // namespace

void ClosestPointLine::audit(const Snapshot& snapshot, AuditReport& report) const {
  std::vector<ObjectId> nearest;
  CGAL::Gmpq best;
  for (ObjectId a = 0; a < snapshot.objects(); ++a) {
    for (ObjectId b = a + 1; snapshot.alive(a) && b < snapshot.objects(); ++b) {
      if (!snapshot.alive(b) || !is_pair(a, b)) continue;
      const ObjectId line = pairs_.claims().is_line(a) ? a : b, point = line == a ? b : a;
      const CGAL::Gmpq slope(snapshot.position(line, 0).raw());
      const CGAL::Gmpq height(snapshot.position(line, 1).raw());
      const ExactPlane::Line_2 l(ExactPlane::Point_2(0, height), ExactPlane::Point_2(1, slope + height));
      const ExactPlane::Point_2 p(CGAL::Gmpq(snapshot.position(point, 0).raw()),
                             CGAL::Gmpq(snapshot.position(point, 1).raw()));
      const CGAL::Gmpq distance =
          measure_ == LineMeasure::kHeight
              ? CGAL::squared_distance(p, ExactPlane::Point_2(p.x(), l.y_at_x(p.x())))
              : CGAL::squared_distance(p, l);
      if (!nearest.empty() && best <= distance) continue;
      nearest = {a, b};
      best = distance;
    }
  }
  report.check(nearest == attribute().ids, [] { return "another line and point are the closest"; });
}

}  // namespace kinex
