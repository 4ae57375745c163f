// SPDX-License-Identifier: GPL-3.0-or-later
// CaliperExtremum: its audits at exact positions: the diameter by all pairs; strips and the area of
// rectangles by CGAL; perimeters, and ids, by all edges of the hull. Over a hull of directions: among
// its vertices, and the guarantees for all points.
#include <CGAL/Gmpq.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/min_quadrilateral_2.h>

#include <algorithm>
#include <iterator>
#include <string>

#include "structures/extent/caliper_extremum.h"
#include "structures/extent/extent_guarantees_audit.h"
#include "structures/extent/farthest_pair_audit.h"

namespace kinex {
namespace {

using Exact = CGAL::Simple_cartesian<CGAL::Gmpq>;
using Number = CGAL::Gmpq;
using Point = Exact::Point_2;
using Vector = Exact::Vector_2;

Point point_of(const Snapshot& snapshot, ObjectId id) {
  return Point(Number(snapshot.position(id, 0).raw()), Number(snapshot.position(id, 1).raw()));
}

std::vector<Point> points_of(const Snapshot& snapshot) {
  std::vector<Point> points;
  for (ObjectId id = 0; id < snapshot.objects(); ++id) {
    if (snapshot.alive(id)) points.push_back(point_of(snapshot, id));
  }
  return points;
}

std::vector<Point> hull_of(const std::vector<Point>& points) {
  std::vector<Point> hull;
  CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull), Exact());
  return hull;
}

// The extents of points on the edge from a to b, times the length of the edge, and its square.
struct CaliperExtents {
  Number height, width, square;
};
CaliperExtents extents_of(const std::vector<Point>& points, const Point& a, const Point& b) {
  const Vector u = b - a;
  Number height(0), least(0), most(0);
  for (const Point& p : points) {
    height = std::max(height, CGAL::determinant(u, p - a));
    least = std::min(least, u * (p - a));
    most = std::max(most, u * (p - a));
  }
  return {height, most - least, u * u};
}

// Of a strip the squared width; of a rectangle the area, or the square of half its perimeter.
Number value_of(const CaliperExtents& e, CaliperMeasure measure) {
  switch (measure) {
    case CaliperMeasure::kWidth:
      return e.height * e.height / e.square;
    case CaliperMeasure::kArea:
      return e.height * e.width / e.square;
    default:
      return (e.height + e.width) * (e.height + e.width) / e.square;
  }
}

}  // namespace

void CaliperExtremum::audit(const Snapshot& snapshot, AuditReport& report) const {
  const auto best_of = [this, &report](const Snapshot& points) { audit_best(points, report); };
  switch (measure_) {
    case CaliperMeasure::kDiameter:
      return audit_reader(*hull_, snapshot, report, best_of, guarantee_diameter);
    case CaliperMeasure::kWidth:
      return audit_reader(*hull_, snapshot, report, best_of, guarantee_width);
    case CaliperMeasure::kArea:
      return audit_reader(*hull_, snapshot, report, best_of, guarantee_area);
    default:
      return audit_reader(*hull_, snapshot, report, best_of, guarantee_perimeter);
  }
}

void CaliperExtremum::audit_best(const Snapshot& snapshot, AuditReport& report) const {
  for (const ObjectId id : best()) {
    if (snapshot.alive(id)) continue;
    return report.check(false, [] { return "it names an object that is not there"; });
  }
  switch (measure_) {
    case CaliperMeasure::kDiameter:
      return audit_diameter(snapshot, report);
    case CaliperMeasure::kWidth:
      return audit_strip(snapshot, report);
    default:
      return audit_rectangle(snapshot, report);
  }
}

void CaliperExtremum::audit_diameter(const Snapshot& snapshot, AuditReport& report) const {
  report.check(static_farthest_pair(snapshot) == best(),
               [] { return "another pair is the farthest"; });
}

void CaliperExtremum::audit_strip(const Snapshot& snapshot, AuditReport& report) const {
  const std::vector<Point> points = points_of(snapshot), hull = hull_of(points);
  const std::vector<ObjectId> ids = best();
  if (hull.size() < 3 || ids.empty()) {
    return report.check((hull.size() < 3) == ids.empty(),
                        [] { return "there is a strip where all points are on a line"; });
  }
  std::vector<Exact::Line_2> lines;
  CGAL::min_strip_2(hull.begin(), hull.end(), std::back_inserter(lines));
  const Number right = CGAL::squared_distance(lines[0], lines[1].point());
  const Point a = point_of(snapshot, ids[0]), b = point_of(snapshot, ids[1]),
              c = point_of(snapshot, ids[2]);
  if (a == b) return report.check(false, [] { return "the edge of the strip has no length"; });
  const CaliperExtents there = extents_of(points, a, b);
  report.check(value_of(there, measure_) == right, [] { return "another strip is narrower"; });
  report.check(CGAL::determinant(b - a, c - a) == there.height,
               [] { return "another vertex is opposite to the edge"; });
  for (const Point& p : points) {
    report.check(CGAL::determinant(b - a, p - a) >= 0,
                 [] { return "the edge is not on the hull"; });
  }
}

void CaliperExtremum::audit_rectangle(const Snapshot& snapshot, AuditReport& report) const {
  const std::vector<Point> points = points_of(snapshot), hull = hull_of(points);
  const std::vector<ObjectId> ids = best();
  if (hull.size() < 3 || ids.empty()) {
    return report.check((hull.size() < 3) == ids.empty(),
                        [] { return "there is a rectangle where all points are on a line"; });
  }
  std::vector<Point> at;
  for (const ObjectId id : ids) at.push_back(point_of(snapshot, id));
  if (at[0] == at[1]) return report.check(false, [] { return "an edge without length"; });
  const CaliperExtents there = extents_of(points, at[0], at[1]);
  Number right = value_of(extents_of(points, hull[0], hull[1]), measure_);
  for (std::size_t i = 1; i < hull.size(); ++i) {
    const Point& to = hull[i + 1 == hull.size() ? 0 : i + 1];
    right = std::min(right, value_of(extents_of(points, hull[i], to), measure_));
  }
  if (measure_ == CaliperMeasure::kArea) {
    std::vector<Point> corners;
    CGAL::min_rectangle_2(hull.begin(), hull.end(), std::back_inserter(corners));
    const Number area = CGAL::determinant(corners[1] - corners[0], corners[2] - corners[0]);
    report.check(area == right, [] { return "the two witnesses of the area differ"; });
  }
  report.check(value_of(there, measure_) == right, [] { return "another rectangle is smaller"; });
  const Vector u = at[1] - at[0];
  report.check(
      CGAL::determinant(u, at[3] - at[0]) == there.height && u * (at[2] - at[4]) == there.width,
      [] { return "other vertices touch the rectangle"; });
}

}  // namespace kinex
