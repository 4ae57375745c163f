// SPDX-License-Identifier: GPL-3.0-or-later
// FlatRegular: the audit against CGAL's exact regular triangulation in space, which is that of their plane for
// points that are all in one.
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <utility>

#include "structures/triangulation/flat_regular.h"
#include "structures/triangulation/in_plane_audit.h"

namespace kinex {
namespace {

using namespace in_plane_audit;
using Weighted = Exact::Weighted_point_3;
using WeightedVertexBase =
    CGAL::Triangulation_vertex_base_with_info_3<ObjectId, Exact,
                                                CGAL::Regular_triangulation_vertex_base_3<Exact>>;
using Witnesses = CGAL::Regular_triangulation_3<
    Exact, CGAL::Triangulation_data_structure_3<WeightedVertexBase,
                                                CGAL::Regular_triangulation_cell_base_3<Exact>>>;

// The height of v over the plane of a triangle, all lifted: `lifts`, by object. The triangle is not flat in
// projection on the axes.
Number height_over(const AxisPair& axes, const std::vector<Point>& points,
                   const std::vector<Number>& lifts, const Corners& t, ObjectId v) {
  Number plane = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    Corners with = t;
    with[i] = v;
    plane += area(axes, points[with[0]], points[with[1]], points[with[2]]) * lifts[t[i]];
  }
  return lifts[v] - plane / area(axes, points[t[0]], points[t[1]], points[t[2]]);
}

}  // namespace

template bool InPlane<PlaneRegular>::holds_at(const Snapshot&) const;

void FlatRegular::audit(const Snapshot& snapshot, AuditReport& report) const {
  std::vector<Point> points(present_.size());
  std::vector<Number> lifts(present_.size());
  std::vector<ObjectId> ids;
  std::vector<std::pair<Weighted, ObjectId>> input;
  for (ObjectId id = 0; id < present_.size(); ++id) {
    if (!present_[id] || !snapshot.alive(id)) continue;
    const Number w = at(snapshot, id, 3), weight = geometry_.reads_radii() ? Number(w * w) : w;
    const Point& p = points[id] = point_of(snapshot, id);
    lifts[id] = p.x() * p.x() + p.y() * p.y() + p.z() * p.z() - weight;
    input.emplace_back(Weighted(p, weight), id);
    ids.push_back(id);
  }
  const Witnesses witness(input.begin(), input.end());
  if (flat_) {
    report.check(witness.dimension() < 2, [] { return std::string("not on one line"); });
    return;
  }
  report.check(witness.dimension() < 3, [] { return std::string("not in one plane"); });
  if (witness.dimension() != 2) return;
  const WitnessPlane plane = plane_of(witness);
  const std::optional<bool> ties = check_triangles(
      store_, ids, points, plane,
      [&](const Corners& c, ObjectId v) {
        return CGAL::sign(height_over(plane.axes, points, lifts, c, v));
      },
      [this](const Corners& c, ObjectId v) {
        return kernel_->sign_after(geometry_.power_claim(c, v)) == Sign::kZero;
      },
      {"below the plane: points", "in the lifted plane, and below by its id: points"}, report);
  if (!ties || *ties || edges() == edges_of(witness)) return;
  // Of points in one lifted plane the witness may have other edges. In a large scene hidden
  // points have not been compared.
  bool is_level = false;
  for (Cell t = 0; t < store_.triangle_capacity(); ++t) {
    if (!store_.live(t) || store_.ghost(t)) continue;
    const Corners c = store_.corners(t);
    for (const ObjectId v : ids) {
      if (store_.has(v)) continue;
      const CGAL::Sign height = CGAL::sign(height_over(plane.axes, points, lifts, c, v));
      is_level = is_level || height == CGAL::ZERO;
      report.check(height != CGAL::NEGATIVE, [&] {
        return named("below the plane: points", {c[0], c[1], c[2], v});
      });
    }
  }
  report.check(is_level,
               [] { return std::string("the edges of the plane differ from the witness"); });
}

}  // namespace kinex
