// SPDX-License-Identifier: GPL-3.0-or-later
// The witness: CGAL's arrangement of the lines at exact positions, in which Arr_naive_point_location finds the
// face, edge or vertex with the point. The lines next to the point are on the boundary of its face:
//
//        \    /           Straight above the point is an edge, or a vertex of several lines, not all
//     ----\--/---- l      of which are on the boundary: of lines at one height the smaller id is the
//          \/             higher one, so the largest id is next above a point, the smallest below.
//          /\   p         Equal lines are one curve. A point on lines is below all of them, so what
//                         is below it is on the boundary of the face straight below.
#include <CGAL/Arr_linear_traits_2.h>
#include <CGAL/Arr_naive_point_location.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "structures/arrangement/points_in_arrangement.h"

namespace kinex {
namespace {

using Number = CGAL::Gmpq;
using Exact = CGAL::Simple_cartesian<Number>;
using Traits = CGAL::Arr_linear_traits_2<Exact>;
using Planar = CGAL::Arrangement_2<Traits>;
using Location = CGAL::Arr_naive_point_location<Planar>;
using Found = CGAL::Arr_point_location_result<Planar>;
using Face = Planar::Face_const_handle;
using Edge = Planar::Halfedge_const_handle;
using Vertex = Planar::Vertex_const_handle;
using Point = Exact::Point_2;
using Ids = std::vector<ObjectId>;

class PointsWitness {
 public:
  PointsWitness(const Snapshot& snapshot, const std::vector<bool>& is_line) {
    std::vector<Traits::Curve_2> curves;
    for (ObjectId l = 0; l < snapshot.objects(); ++l) {
      if (!is_line[l] || !snapshot.alive(l)) continue;
      const Number slope(snapshot.position(l, 0).raw()), height(snapshot.position(l, 1).raw());
      Ids& same = ids_[{slope, height}];
      if (same.empty()) curves.emplace_back(Exact::Line_2(slope, -1, height));
      same.push_back(l);
    }
    CGAL::insert(planar_, curves.begin(), curves.end());
    location_.attach(planar_);
  }

  // The lines above and below; kNoObject: none.
  std::array<ObjectId, 2> next_to(const Point& p) const {
    const auto found = location_.locate(p);
    if (const Vertex* v = Found::assign<Vertex>(&found)) {
      const auto lines = lines_of(*v);
      return {lines.back(), next_below(below(*v), p)};
    }
    if (const Edge* e = Found::assign<Edge>(&found)) {
      const bool left = (*e)->direction() == CGAL::ARR_RIGHT_TO_LEFT;
      return {lines_of(*e).back(), next_below(left ? (*e)->face() : (*e)->twin()->face(), p)};
    }
    const Face face = *Found::assign<Face>(&found);
    const Ids up = lines_next(face, p, CGAL::ARR_RIGHT_TO_LEFT);
    return {up.empty() ? kNoObject : up.back(), next_below(face, p)};
  }

 private:
  // Ascending.
  const Ids& lines_of(Edge e) const {
    const Exact::Line_2 line = e->curve().supporting_line();
    return ids_.at({-line.a() / line.b(), -line.c() / line.b()});
  }
  Ids lines_of(Vertex v) const {
    Ids result;
    auto e = v->incident_halfedges();
    const auto first = e;
    do {
      const Ids& more = lines_of(e);
      result.insert(result.end(), more.begin(), more.end());
    } while (++e != first);
    std::sort(result.begin(), result.end());
    return result;
  }
  // The face straight below: under the lowest, the steepest, of the edges that end here from the left.
  static Face below(Vertex v) {
    auto e = v->incident_halfedges();
    const auto first = e;
    Edge lowest;
    Number steepest;
    do {
      if (e->direction() != CGAL::ARR_LEFT_TO_RIGHT) continue;
      const Exact::Line_2 line = e->curve().supporting_line();
      const Number slope = -line.a() / line.b();
      if (lowest != Edge() && slope < steepest) continue;
      lowest = e;
      steepest = slope;
    } while (++e != first);
    return lowest->twin()->face();
  }
  ObjectId next_below(Face face, const Point& p) const {
    const Ids lines = lines_next(face, p, CGAL::ARR_LEFT_TO_RIGHT);
    return lines.empty() ? kNoObject : lines.front();
  }
  // Those through the point of the face's boundary straight above p, where halfedges with the face on
  // their left go from right to left, or straight below, where they go from left to right.
  Ids lines_next(Face face, const Point& p, CGAL::Arr_halfedge_direction direction) const {
    if (!face->has_outer_ccb()) return {};
    Planar::Ccb_halfedge_const_circulator e = face->outer_ccb();
    const auto first = e;
    do {
      if (e->is_fictitious() || e->direction() != direction) continue;
      bool within = true;
      for (const Vertex v : {e->source(), e->target()}) {
        if (v->is_at_open_boundary()) continue;
        if (v->point().x() == p.x()) return lines_of(v);
        // The vertex is on the other side of p's vertical than the edge's other end.
        const bool is_left = (v == e->source()) == (direction == CGAL::ARR_LEFT_TO_RIGHT);
        within = within && is_left == (v->point().x() < p.x());
      }
      if (within) return lines_of(e);
    } while (++e != first);
    return {};
  }

  std::map<std::pair<Number, Number>, Ids> ids_;  // by slope and height
  Planar planar_;
  Location location_;
};

}  // namespace

void PointsInArrangement::audit(const Snapshot& snapshot, AuditReport& report) const {
  const PointsWitness witness(snapshot, is_line_);
  Ids points;
  for (ObjectId p = 0; p < snapshot.objects(); ++p) {
    if (snapshot.alive(p) && !is_line_[p]) points.push_back(p);
  }
  report.check(points == points_, [] { return "other points than those that are there"; });
  for (const ObjectId p : points) {
    const Point point(Number(snapshot.position(p, 0).raw()), Number(snapshot.position(p, 1).raw()));
    const auto [above, below] = witness.next_to(point);
    report.check(places_[p].edges[kUp].line == above && places_[p].edges[kDown].line == below,
                 [p] { return "other lines are next to point " + std::to_string(p); });
  }
}

}  // namespace kinex
