// SPDX-License-Identifier: GPL-3.0-or-later
// Regular2: the audit against CGAL's exact triangulation. No other file of this
// structure includes CGAL.
#include <CGAL/Gmpq.h>
#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "structures/triangulation/audit_text.h"
#include "structures/triangulation/regular_2.h"
#include "structures/triangulation/spread_out.h"

namespace kinex {
namespace {

using Exact = CGAL::Simple_cartesian<CGAL::Gmpq>;
using Number = Exact::FT;
using Point = Exact::Point_2;
using Weighted = Exact::Weighted_point_2;
using VertexBase =
    CGAL::Triangulation_vertex_base_with_info_2<ObjectId, Exact,
                                                CGAL::Regular_triangulation_vertex_base_2<Exact>>;
using FaceBase = CGAL::Regular_triangulation_face_base_2<Exact>;
using Witnesses =
    CGAL::Regular_triangulation_2<Exact,
                                  CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;
using Corners = std::array<ObjectId, 3>;

Corners sorted(Corners t) {
  std::sort(t.begin(), t.end());
  return t;
}

// The point of equal power to the corners of a triangle that is not flat, and that power: the plane
// through them, all lifted.
using Centre = std::pair<Point, Number>;

Centre centre_of(const std::vector<Weighted>& points, const Corners& t) {
  const Weighted& corner = points[t[0]];
  const Point centre =
      Exact().construct_weighted_circumcenter_2_object()(corner, points[t[1]], points[t[2]]);
  return {centre, CGAL::squared_distance(centre, corner.point()) - corner.weight()};
}

// The height of v over the plane of a triangle that is not flat, all lifted.
Number height_over(const std::vector<Weighted>& points, const Corners& t, ObjectId v) {
  const auto lift = [&](ObjectId i) {
    const Point& p = points[i].point();
    return Number(p.x() * p.x() + p.y() * p.y() - points[i].weight());
  };
  const auto area = [&](ObjectId a, ObjectId b, ObjectId c) {
    return Number(CGAL::area(points[a].point(), points[b].point(), points[c].point()));
  };
  const Number whole = area(t[0], t[1], t[2]);
  return lift(v) - (area(v, t[1], t[2]) * lift(t[0]) + area(t[0], v, t[2]) * lift(t[1]) +
                    area(t[0], t[1], v) * lift(t[2])) /
                       whole;
}

// A point in the plane of an upright triangle: true if it is below once heights are lowered by eps_i,
// smaller ids much more. v is lowered by eps_v, the plane at v by the sum of its coordinates times eps.
bool below_by_ties(const std::vector<Weighted>& points, const Corners& t, ObjectId v) {
  std::array<ObjectId, 4> order{t[0], t[1], t[2], v};
  std::sort(order.begin(), order.end());
  for (const ObjectId lowered : order) {
    if (lowered == v) return true;
    Corners with = t;
    for (ObjectId& corner : with) {
      if (corner == lowered) corner = v;
    }
    const auto turn = CGAL::orientation(points[with[0]].point(), points[with[1]].point(),
                                        points[with[2]].point());
    if (turn != CGAL::COLLINEAR) return turn == CGAL::RIGHT_TURN;
  }
  return true;
}

}  // namespace

bool Regular2::holds_at(const Snapshot& snapshot) const {
  return flat_ || is_spread_out(store_, [&snapshot](ObjectId v) {
           const auto at = [&](int axis) {
             return Number(CGAL::Gmpq(snapshot.position(v, axis).raw()));
           };
           return Point(at(0), at(1));
         });
}

void Regular2::audit(const Snapshot& snapshot, AuditReport& report) const {
  std::vector<Weighted> points(present_.size());
  std::vector<ObjectId> ids;
  Witnesses witness;
  for (ObjectId id = 0; id < present_.size(); ++id) {
    report.check(present_[id] == snapshot.alive(id), [&] { return named("alive or not:", {id}); });
    if (!present_[id] || !snapshot.alive(id)) continue;
    const auto at = [&](int axis) { return Number(CGAL::Gmpq(snapshot.position(id, axis).raw())); };
    const Number w = at(2);
    points[id] = Weighted(Point(at(0), at(1)), geometry_.reads_radii() ? Number(w * w) : w);
    witness.insert(points[id])->info() = id;
    ids.push_back(id);
  }
  if (flat_) {
    report.check(witness.dimension() < 2, [] { return std::string("not on one line"); });
    return;
  }
  std::set<Corners> theirs;
  Number area = 0, whole = 0;
  for (auto f = witness.finite_faces_begin(); f != witness.finite_faces_end(); ++f) {
    theirs.insert(sorted({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()}));
    whole += CGAL::area(f->vertex(0)->point().point(), f->vertex(1)->point().point(),
                        f->vertex(2)->point().point());
  }
  // Points may touch and turn back without any event: at such an instant triangles may be flat.
  bool flat = false, ties = false;
  std::vector<Corners> upright;
  std::size_t cells = 0, common = 0;
  const bool all_points = ids.size() <= 24;
  for (Triangle t = 0; t < store_.triangle_capacity(); ++t) {
    if (!store_.live(t) || store_.ghost(t)) continue;
    const Corners c = store_.corners(t);
    ++cells;
    common += theirs.count(sorted(c));
    const auto turn =
        CGAL::orientation(points[c[0]].point(), points[c[1]].point(), points[c[2]].point());
    report.check(turn != CGAL::RIGHT_TURN,
                 [&] { return named("clockwise triangle", {c[0], c[1], c[2]}); });
    flat = flat || turn == CGAL::COLLINEAR;
    if (turn != CGAL::LEFT_TURN) continue;
    upright.push_back(c);
    area += CGAL::area(points[c[0]].point(), points[c[1]].point(), points[c[2]].point());
    const auto look_at = [&](ObjectId v) {
      if (v == c[0] || v == c[1] || v == c[2]) return;
      const auto side = CGAL::sign(height_over(points, c, v));
      report.check(side != CGAL::NEGATIVE, [&] {
        return named("below the plane: points", {c[0], c[1], c[2], v});
      });
      if (side != CGAL::ZERO) return;
      ties = true;
      // A tie of this time only may be decided either way.
      if (kernel_->sign_after(geometry_.power_claim(c, v)) != Sign::kZero) return;
      report.check(!below_by_ties(points, c, v), [&] {
        return named("in the plane, and below by its id: points", {c[0], c[1], c[2], v});
      });
    };
    if (all_points) {
      for (const ObjectId v : ids) look_at(v);
    } else {
      for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
        const ObjectId v = store_.apex(store_.twin(h));
        if (v != store_.infinity()) look_at(v);
      }
    }
  }
  if (flat) return;
  report.check(area == whole, [] { return std::string("the triangles do not fill the hull"); });
  if (!ties && cells == theirs.size() && common == cells) return;
  // Of points in one lifted plane the witness may make other triangles, and keep another one of a vertex and
  // hidden points, which are not compared in a large scene; the planes are the same.
  std::set<Centre> ours, of_witness;
  for (const Corners& t : upright) ours.insert(centre_of(points, t));
  for (const Corners& t : theirs) of_witness.insert(centre_of(points, t));
  report.check(ours == of_witness,
               [] { return std::string("the power diagram differs from that of the witness"); });
}

}  // namespace kinex
