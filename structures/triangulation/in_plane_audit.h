// SPDX-License-Identifier: GPL-3.0-or-later
// What the audits of triangulations of points of space in one plane have in common. For those files alone, which
// include CGAL.
#ifndef KINEX_STRUCTURES_TRIANGULATION_IN_PLANE_AUDIT_H
#define KINEX_STRUCTURES_TRIANGULATION_IN_PLANE_AUDIT_H

#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "structures/triangulation/audit_text.h"
#include "structures/triangulation/in_plane.h"

namespace kinex::in_plane_audit {

// The kernel of these audits, whose numbers are rational.
using Exact = CGAL::Simple_cartesian<CGAL::Gmpq>;
// A coordinate.
using Number = Exact::FT;
// A position in space.
using Point = Exact::Point_3;
// Of a triangle.
using Corners = std::array<ObjectId, 3>;

// A coordinate of an object.
inline Number at(const Snapshot& snapshot, ObjectId id, int axis) {
  return Number(CGAL::Gmpq(snapshot.position(id, axis).raw()));
}
// The position of an object.
inline Point point_of(const Snapshot& snapshot, ObjectId id) {
  return Point(at(snapshot, id, 0), at(snapshot, id, 1), at(snapshot, id, 2));
}

// Twice the area of a triangle in projection on two axes.
inline Number area(const AxisPair& axes, const Point& a, const Point& b, const Point& c) {
  const auto u = [&](const Point& p) { return Number(p[axes.first] - a[axes.first]); };
  const auto v = [&](const Point& p) { return Number(p[axes.second] - a[axes.second]); };
  return u(b) * v(c) - v(b) * u(c);
}

// A point that is in the plane of a triangle, all lifted (on its circle), `turn` the triangle's sign in projection:
// true if it is below (inside) once the lifted heights have been lowered by eps_i, smaller ids much more.
inline bool below_by_ties(const AxisPair& axes, const std::vector<Point>& points, const Corners& t,
                          ObjectId v) {
  std::array<ObjectId, 4> order{t[0], t[1], t[2], v};
  std::sort(order.begin(), order.end());
  const auto turn = [&](const Corners& c) {
    return CGAL::sign(area(axes, points[c[0]], points[c[1]], points[c[2]]));
  };
  for (const ObjectId lowered : order) {
    if (lowered == v) return true;
    Corners with = t;
    std::replace(with.begin(), with.end(), lowered, v);
    if (turn(with) != CGAL::ZERO) return turn(with) != turn(t);
  }
  return true;
}

// The edges of a CGAL triangulation whose vertices know their ids: smaller id first, ascending.
template <class Witness>
std::vector<std::array<ObjectId, 2>> edges_of(const Witness& witness) {
  std::vector<std::array<ObjectId, 2>> result;
  for (auto e = witness.finite_edges_begin(); e != witness.finite_edges_end(); ++e) {
    const ObjectId a = e->first->vertex(e->second)->info();
    const ObjectId b = e->first->vertex(e->third)->info();
    result.push_back({std::min(a, b), std::max(a, b)});
  }
  std::sort(result.begin(), result.end());
  return result;
}

// The corner of a facet of one.
inline const Point& bare(const Point& p) { return p; }
inline const Point& bare(const Exact::Weighted_point_3& p) { return p.point(); }

// Of a CGAL triangulation of dimension 2: axes on which its plane is not upright, and twice its area on these.
struct WitnessPlane {
  AxisPair axes;
  Number whole = 0;
};
template <class Witness>
WitnessPlane plane_of(const Witness& witness) {
  WitnessPlane plane;
  const auto corner = [](const auto& f, int i) -> const Point& {
    return bare(f->first->vertex(i)->point());
  };
  const auto facet = witness.finite_facets_begin();
  for (const AxisPair& pair : kAxisPairs) {
    if (area(pair, corner(facet, 0), corner(facet, 1), corner(facet, 2)) != 0) plane.axes = pair;
  }
  for (auto f = witness.finite_facets_begin(); f != witness.finite_facets_end(); ++f) {
    plane.whole += CGAL::abs(area(plane.axes, corner(f, 0), corner(f, 1), corner(f, 2)));
  }
  return plane;
}

// The messages about a point below a triangle (inside its circle), and of one level with it that is below by its
// id.
struct BelowMessages {
  const char* below;
  const char* below_by_ties;
};

// Checks the triangles of `store`: all are turned to one side, they fill the hull, and no other point is below
// them: none of `ids` in small scenes, and no apex beyond an edge in others. `height_over(corners, id)`: the sign
// of the height of a point over a triangle; `is_tie(corners, id)`: it is level with it for a while. Returns
// whether some point was level; nullopt, with no more checked, if triangles are flat: points may touch and turn
// back without any event.
template <class Ids, class Height, class Tie>
std::optional<bool> check_triangles(const Triangulation2& store, const Ids& ids,
                                    const std::vector<Point>& points, const WitnessPlane& plane,
                                    const Height& height_over, const Tie& is_tie,
                                    const BelowMessages& messages, AuditReport& report) {
  Number filled = 0;
  bool is_flat = false, is_level = false;
  CGAL::Sign side = CGAL::ZERO;  // of the plane, from which triangles are counter-clockwise
  const bool all_points = ids.size() <= 24;
  for (Triangulation2::Triangle t = 0; t < store.triangle_capacity(); ++t) {
    if (!store.live(t) || store.ghost(t)) continue;
    const Corners c = store.corners(t);
    const Number twice = area(plane.axes, points[c[0]], points[c[1]], points[c[2]]);
    const CGAL::Sign turn = CGAL::sign(twice);
    filled += CGAL::abs(twice);
    is_flat = is_flat || turn == CGAL::ZERO;
    if (turn == CGAL::ZERO) continue;
    report.check(side == CGAL::ZERO || side == turn, [&] {
      return named("a triangle of the plane is turned over:", {c[0], c[1], c[2]});
    });
    side = turn;
    const auto look_at = [&](ObjectId v) {
      if (v == c[0] || v == c[1] || v == c[2]) return;
      const CGAL::Sign height = height_over(c, v);
      report.check(height != CGAL::NEGATIVE, [&] {
        return named(messages.below, {c[0], c[1], c[2], v});
      });
      if (height != CGAL::ZERO) return;
      is_level = true;
      // A tie of this time only may be decided either way.
      if (!is_tie(c, v)) return;
      report.check(!below_by_ties(plane.axes, points, c, v), [&] {
        return named(messages.below_by_ties, {c[0], c[1], c[2], v});
      });
    };
    if (all_points) {
      for (const ObjectId v : ids) look_at(v);
    } else {
      for (Triangulation2::HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
        const ObjectId v = store.apex(store.twin(h));
        if (v != store.infinity()) look_at(v);
      }
    }
  }
  if (is_flat) return std::nullopt;
  report.check(filled == plane.whole,
               [] { return std::string("the triangles do not fill the hull"); });
  return is_level;
}

}  // namespace kinex::in_plane_audit

namespace kinex {

// As Regular2::holds_at, in projection on the axes in use.
template <class Base>
bool InPlane<Base>::holds_at(const Snapshot& snapshot) const {
  using in_plane_audit::Point;
  using in_plane_audit::point_of;
  if (this->flat_) return true;
  const Triangulation2& store = this->store_;
  for (Cell t = 0; t < store.triangle_capacity(); ++t) {
    if (!store.live(t) || store.ghost(t)) continue;
    const auto c = store.corners(t);
    const auto turn = in_plane_audit::area(axes(), point_of(snapshot, c[0]),
                                           point_of(snapshot, c[1]), point_of(snapshot, c[2]));
    if (CGAL::sign(turn) != CGAL::POSITIVE) return false;
  }
  const auto comes_before = [this](const Point& a, const Point& b) {
    const AxisPair& on = axes();
    return std::pair(a[on.first], a[on.second]) < std::pair(b[on.first], b[on.second]);
  };
  int ends = 0;  // of the part of the hull on which the first coordinate ascends
  const auto first = store.out(store.infinity());
  auto at = first;
  do {
    const auto next = store.around(at), last = store.around(next);
    const Point a = point_of(snapshot, store.target(at));
    const Point b = point_of(snapshot, store.target(next));
    const Point c = point_of(snapshot, store.target(last));
    if (comes_before(a, b) && !comes_before(b, c)) ++ends;
    at = next;
  } while (at != first);
  return ends == 1;
}

}  // namespace kinex

#endif
