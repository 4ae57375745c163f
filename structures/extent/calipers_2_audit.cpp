// SPDX-License-Identifier: GPL-3.0-or-later
// Calipers2: its audit at exact positions: between each two directions of edges of CGAL's hull the
// extreme points, by looking at all of them. Over a hull of directions: its vertices, and the
// guarantee for the longest of the pairs.
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <iterator>

#include "structures/extent/calipers_2.h"
#include "structures/extent/extent_guarantees_audit.h"

namespace kinex {
namespace {

using Exact = CGAL::Simple_cartesian<CGAL::Gmpq>;
using Number = CGAL::Gmpq;
using Point = Exact::Point_2;
using Vector = Exact::Vector_2;
using Touched = std::vector<Point>;  // sorted

Number cross(const Vector& u, const Vector& v) { return u.x() * v.y() - u.y() * v.x(); }

// By one fold counter-clockwise.
Vector turned(const Vector& u, int folds) { return folds == 2 ? -u : Vector(-u.y(), u.x()); }

// In the half plane above the x axis, or in the first quadrant; the first side of it belongs to it.
bool is_in_first_fold(const Vector& u, int folds) {
  if (folds == 2) return u.y() > 0 || (u.y() == 0 && u.x() > 0);
  return u.x() > 0 && u.y() >= 0;
}

// The points that are lowest where the direction is to the right.
std::vector<Point> lowest(const std::vector<Point>& hull, const Vector& direction) {
  Number least = cross(direction, hull[0] - CGAL::ORIGIN);
  for (const Point& p : hull) least = std::min(least, cross(direction, p - CGAL::ORIGIN));
  std::vector<Point> result;
  for (const Point& p : hull) {
    if (cross(direction, p - CGAL::ORIGIN) == least) result.push_back(p);
  }
  return result;
}

// The directions of the edges modulo one fold, in order, no two alike.
std::vector<Vector> directions_of(const std::vector<Point>& hull, int folds) {
  std::vector<Vector> result;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    Vector u = hull[i + 1 == hull.size() ? 0 : i + 1] - hull[i];
    while (!is_in_first_fold(u, folds)) u = turned(u, folds);
    result.push_back(u);
  }
  std::sort(result.begin(), result.end(),
            [](const Vector& a, const Vector& b) { return cross(a, b) > 0; });
  const auto same = [](const Vector& a, const Vector& b) { return cross(a, b) == 0; };
  result.erase(std::unique(result.begin(), result.end(), same), result.end());
  return result;
}

// Each of the points is touched by calipers in this direction, and so is a point of each fold.
bool may_touch(const std::vector<Point>& hull, const Touched& points, Vector direction, int folds) {
  std::vector<bool> is_touched(points.size(), false);
  for (int k = 0; k < folds; ++k, direction = turned(direction, folds)) {
    bool any = false;
    for (const Point& p : lowest(hull, direction)) {
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i] != p) continue;
        any = is_touched[i] = true;
      }
    }
    if (!any) return false;
  }
  return std::find(is_touched.begin(), is_touched.end(), false) == is_touched.end();
}

}  // namespace

void Calipers2::audit(const Snapshot& snapshot, AuditReport& report) const {
  const auto touched = [this, &report](const Snapshot& points) { audit_touched(points, report); };
  audit_reader(calipers_.hull(), snapshot, report, touched, guarantee_diameter);
}

void Calipers2::audit_touched(const Snapshot& snapshot, AuditReport& report) const {
  const int folds = calipers().folds();
  const auto at = [&snapshot](ObjectId id) {
    return Point(Number(snapshot.position(id, 0).raw()), Number(snapshot.position(id, 1).raw()));
  };
  std::vector<Point> points, hull;
  for (ObjectId id = 0; id < snapshot.objects(); ++id) {
    if (snapshot.alive(id)) points.push_back(at(id));
  }
  CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull), Exact());
  const std::vector<ObjectId> ids = touched();
  std::vector<Touched> found;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (i % static_cast<std::size_t>(folds) == 0) found.emplace_back();
    if (!snapshot.alive(ids[i])) {
      return report.check(false, [] { return "it names an object that is not there"; });
    }
    found.back().push_back(at(ids[i]));
  }
  for (Touched& one : found) std::sort(one.begin(), one.end());
  const std::size_t tuples = hull.size() < 2 ? 0 : hull.size() == 2 ? 1 : hull.size();
  report.check(found.size() == tuples, [] { return "there is not one tuple for each edge"; });
  if (hull.size() == 2 && found.size() == 1) {
    std::sort(hull.begin(), hull.end());
    report.check(found[0].front() == hull[0] && found[0].back() == hull[1],
                 [] { return "the calipers touch other ends of the segment"; });
  }
  if (hull.size() < 3) return;
  const std::vector<Vector> directions = directions_of(hull, folds);
  std::vector<bool> is_certain(found.size(), false);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Vector next =
        i + 1 == directions.size() ? turned(directions[0], folds) : directions[i + 1];
    Vector between = directions[i] + next;
    Touched expected;
    for (int k = 0; k < folds; ++k, between = turned(between, folds)) {
      expected.push_back(lowest(hull, between).front());
    }
    std::sort(expected.begin(), expected.end());
    const auto there = std::find(found.begin(), found.end(), expected);
    report.check(there != found.end(), [] { return "it lacks what the calipers touch"; });
    if (there != found.end()) is_certain[static_cast<std::size_t>(there - found.begin())] = true;
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (is_certain[i]) continue;
    report.check(std::any_of(directions.begin(), directions.end(),
                             [&](const Vector& u) { return may_touch(hull, found[i], u, folds); }),
                 [] { return "the calipers do not touch this"; });
  }
}

}  // namespace kinex
