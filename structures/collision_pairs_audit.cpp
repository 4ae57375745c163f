// SPDX-License-Identifier: GPL-3.0-or-later
// The witness of CollisionPairs: CGAL's exact intersection tests of the polygons' edges.
#include <CGAL/Gmpq.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "structures/collision_pairs.h"

namespace kinex {
namespace {

using Exact = CGAL::Simple_cartesian<CGAL::Gmpq>;
using Point = Exact::Point_2;
using Segment = Exact::Segment_2;

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

bool meet(const Placed& a, const Placed& b) {
  if (!CGAL::do_overlap(a.box, b.box)) return false;
  const std::size_t n = a.vertices.size(), m = b.vertices.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Segment edge(a.vertices[i], a.vertices[(i + 1) % n]);
    const CGAL::Bbox_2 box = edge.bbox();
    if (!CGAL::do_overlap(box, b.box)) continue;
    for (std::size_t j = 0; j < m; ++j) {
      const Segment other(b.vertices[j], b.vertices[(j + 1) % m]);
      if (CGAL::do_overlap(box, other.bbox()) && CGAL::do_intersect(edge, other)) return true;
    }
  }
  const auto inside = [](const Point& p, const std::vector<Point>& polygon) {
    return CGAL::bounded_side_2(polygon.begin(), polygon.end(), p, Exact()) !=
           CGAL::ON_UNBOUNDED_SIDE;
  };
  return inside(a.vertices.front(), b.vertices) || inside(b.vertices.front(), a.vertices);
}

}  // namespace

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
  std::set<std::pair<ObjectId, ObjectId>> touching;
  const Attribute known = attribute();
  for (std::size_t i = 0; i + 1 < known.ids.size(); i += 2) {
    touching.emplace(known.ids[i], known.ids[i + 1]);
  }
  for (std::size_t i = 0; i < order.size(); ++i) {
    ++report.checks;
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      const ObjectId a = std::min(order[i], order[j]), b = std::max(order[i], order[j]);
      if (bodies[order[j]].box.xmin() > bodies[order[i]].box.xmax()) break;
      if (touching.count({a, b}) != 0) continue;
      report.check(!meet(bodies[a], bodies[b]), [&] {
        return scene_.objects[a].id + " and " + scene_.objects[b].id +
               " meet, and no contact is known, at t = " + snapshot.time().to_string();
      });
    }
  }
}

}  // namespace kinex
