// SPDX-License-Identifier: GPL-3.0-or-later
// CollisionPairs: the audit. The witness is CGAL's exact orientations of one polygon's vertices
// against the edges of the other. Polygons that only touch may be in contact (at its instant) or
// not.
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "core/numbers/show_text.h"
#include "structures/collision/collision_pairs.h"

namespace kinex {
namespace {

using Exact = CGAL::Simple_cartesian<CGAL::Gmpq>;
using Point = Exact::Point_2;

struct Placed {
  std::vector<Point> vertices;
  CGAL::Bbox_2 box;
};

Placed placed(const SceneObject& body, const Snapshot& snapshot, ObjectId id) {
  const Rational& x = snapshot.position(id, 0);
  const Rational& y = snapshot.position(id, 1);
  const Rational& p = snapshot.position(id, 2);
  const Rational& q = snapshot.position(id, 3);
  const Rational n = p * p + q * q;
  const Rational c = (p * p - q * q) / n, s = Rational(2) * p * q / n;
  Placed result;
  for (const Vertex2& v : body.polygon) {
    const Rational wx = x + c * v[0] - s * v[1], wy = y + s * v[0] + c * v[1];
    result.vertices.emplace_back(CGAL::Gmpq(wx.raw()), CGAL::Gmpq(wy.raw()));
  }
  for (const Point& v : result.vertices) result.box += v.bbox();
  return result;
}

// Some edge of `a` has all of `b` on its other side, and, if `strictly`, none of it on its line.
bool separates(const Placed& a, const Placed& b, bool strictly) {
  const std::size_t n = a.vertices.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point& from = a.vertices[i];
    const Point& to = a.vertices[(i + 1) % n];
    if (std::none_of(b.vertices.begin(), b.vertices.end(), [&](const Point& v) {
          const CGAL::Orientation turn = CGAL::orientation(from, to, v);
          return turn == CGAL::LEFT_TURN || (strictly && turn == CGAL::COLLINEAR);
        })) {
      return true;
    }
  }
  return false;
}

// Two convex polygons with disjoint interiors are on two sides of an edge of one of them.
bool overlap(const Placed& a, const Placed& b) {
  return CGAL::do_overlap(a.box, b.box) && !separates(a, b, false) && !separates(b, a, false);
}
bool meet(const Placed& a, const Placed& b) {
  return !separates(a, b, true) && !separates(b, a, true);
}

}  // namespace

bool CollisionPairs::holds_at(const Snapshot& snapshot) const {
  for (ObjectId id = 0; id < scene_.objects.size(); ++id) {
    if (snapshot.alive(id) && snapshot.position(id, 2).is_zero() &&
        snapshot.position(id, 3).is_zero()) {
      return false;
    }
  }
  return true;
}

void CollisionPairs::audit(const Snapshot& snapshot, AuditReport& report) const {
  std::vector<Placed> bodies(scene_.objects.size());
  std::vector<ObjectId> order;  // by the left ends of their boxes
  for (ObjectId id = 0; id < bodies.size(); ++id) {
    if (!snapshot.alive(id)) continue;
    bodies[id] = placed(scene_.objects[id], snapshot, id);
    order.push_back(id);
  }
  std::sort(order.begin(), order.end(), [&](ObjectId a, ObjectId b) {
    const double x = bodies[a].box.xmin(), y = bodies[b].box.xmin();
    return x != y ? x < y : a < b;
  });
  proof_->audit(snapshot, report);
  std::set<std::pair<ObjectId, ObjectId>> touching;
  const Attribute known = attribute();
  for (std::size_t i = 0; i + 1 < known.ids.size(); i += 2) {
    const ObjectId a = known.ids[i], b = known.ids[i + 1];
    touching.emplace(a, b);
    report.check(meet(bodies[a], bodies[b]), [&] {
      return show_text(scene_.objects[a].id) + " and " + show_text(scene_.objects[b].id) +
             " are apart, and in contact for the structure";
    });
  }
  for (std::size_t i = 0; i < order.size(); ++i) {
    ++report.checks;
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      const ObjectId a = std::min(order[i], order[j]), b = std::max(order[i], order[j]);
      if (bodies[order[j]].box.xmin() > bodies[order[i]].box.xmax()) break;
      if (touching.count({a, b}) != 0) continue;
      report.check(!overlap(bodies[a], bodies[b]), [&] {
        return show_text(scene_.objects[a].id) + " and " + show_text(scene_.objects[b].id) +
               " overlap, and no contact is known";
      });
    }
  }
}

}  // namespace kinex
