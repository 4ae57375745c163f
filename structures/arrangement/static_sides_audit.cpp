// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/arrangement/static_sides_audit.h"

#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>

#include <cstddef>

#include "structures/arrangement/incidences_all.h"

namespace kinex {

namespace {

using Exact = CGAL::Simple_cartesian<CGAL::Gmpq>;

}  // namespace

std::vector<ObjectId> static_points_above(const Snapshot& snapshot,
                                          const std::vector<bool>& is_line) {
  std::vector<Exact::Line_2> lines(snapshot.objects());
  std::vector<Exact::Point_2> points(snapshot.objects());
  for (ObjectId a = 0; a < snapshot.objects(); ++a) {
    if (!snapshot.alive(a)) continue;
    const CGAL::Gmpq u(snapshot.position(a, 0).raw()), v(snapshot.position(a, 1).raw());
    if (is_line[a]) {
      // From left to right, so that the left side is above.
      lines[a] = Exact::Line_2(Exact::Point_2(0, v), Exact::Point_2(1, u + v));
    } else {
      points[a] = Exact::Point_2(u, v);
    }
  }
  std::vector<ObjectId> result;
  for (ObjectId a = 0; a < snapshot.objects(); ++a) {
    for (ObjectId b = a + 1; snapshot.alive(a) && b < snapshot.objects(); ++b) {
      if (!snapshot.alive(b) || is_line[a] == is_line[b]) continue;
      const ObjectId line = is_line[a] ? a : b, point = is_line[a] ? b : a;
      if (lines[line].has_on_positive_side(points[point])) result.insert(result.end(), {a, b});
    }
  }
  return result;
}

void IncidencesAll::audit(const Snapshot& snapshot, AuditReport& report) const {
  report.check(static_points_above(snapshot, is_line_) == attribute().ids,
               [] { return "other points are above lines"; });
}

}  // namespace kinex
