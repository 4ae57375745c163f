// SPDX-License-Identifier: GPL-3.0-or-later
// Regular3: the audit against CGAL's exact triangulation. No other file of this structure includes CGAL.
#include <CGAL/Gmpq.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "structures/triangulation/audit_text.h"
#include "structures/triangulation/regular_3.h"

namespace kinex {
namespace {

using Exact = CGAL::Simple_cartesian<CGAL::Gmpq>;
using Number = Exact::FT;
using Point = Exact::Point_3;
using Weighted = Exact::Weighted_point_3;
using VertexBase =
    CGAL::Triangulation_vertex_base_with_info_3<ObjectId, Exact,
                                                CGAL::Regular_triangulation_vertex_base_3<Exact>>;
using CellBase = CGAL::Regular_triangulation_cell_base_3<Exact>;
using Witnesses =
    CGAL::Regular_triangulation_3<Exact,
                                  CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;
using Quad = std::array<ObjectId, 4>;

Quad sorted(Quad quad) {
  std::sort(quad.begin(), quad.end());
  return quad;
}

Number volume(const std::vector<Weighted>& points, const Quad& q) {
  return CGAL::volume(points[q[0]].point(), points[q[1]].point(), points[q[2]].point(),
                      points[q[3]].point());
}

// The point of equal power to the corners of an upright cell, and that power: the plane through them, all
// lifted.
using Centre = std::pair<Point, Number>;

Centre centre_of(const std::vector<Weighted>& points, const Quad& q) {
  const Weighted& corner = points[q[0]];
  const Point centre = Exact().construct_weighted_circumcenter_3_object()(
      corner, points[q[1]], points[q[2]], points[q[3]]);
  return {centre, CGAL::squared_distance(centre, corner.point()) - corner.weight()};
}

Quad replaced(Quad quad, std::size_t place, ObjectId fresh) {
  quad[place] = fresh;
  return quad;
}

// The height of v over the plane of an upright cell, all lifted: by barycentric coordinates.
Number height_over(const std::vector<Weighted>& points, const Quad& quad, ObjectId v) {
  const auto lift = [&](ObjectId i) {
    const Point& p = points[i].point();
    return Number(p.x() * p.x() + p.y() * p.y() + p.z() * p.z() - points[i].weight());
  };
  Number plane = 0;
  for (std::size_t i = 0; i < 4; ++i) plane += volume(points, replaced(quad, i, v)) * lift(quad[i]);
  return lift(v) - plane / volume(points, quad);
}

// A point in the plane of an upright cell: true if it is below once heights are lowered by eps_i, smaller
// ids much more. v is lowered by eps_v, the plane at v by the sum of its coordinates times eps.
bool below_by_ties(const std::vector<Weighted>& points, const Quad& quad, ObjectId v) {
  std::array<ObjectId, 5> order{quad[0], quad[1], quad[2], quad[3], v};
  std::sort(order.begin(), order.end());
  for (const ObjectId lowered : order) {
    if (lowered == v) return true;
    const auto at =
        static_cast<std::size_t>(std::find(quad.begin(), quad.end(), lowered) - quad.begin());
    const auto turn = CGAL::sign(volume(points, replaced(quad, at, v)));
    if (turn != CGAL::ZERO) return turn == CGAL::NEGATIVE;
  }
  return true;
}

}  // namespace

// ---- bounds and invariants

std::vector<BoundCheck> Regular3::bounds(const BoundContext& context) const {
  std::vector<BoundCheck> checks;
  if (corrupt_ || (plane_ != nullptr && plane_->corrupt())) return checks;
  bounds_of_state(context, planar() ? plane_->wanted() : 0, checks);
  if (plane_ == nullptr) {
    bounds_of_events(context, "", checks);
  } else {
    plane_->add_bounds_of_events(context, checks);
  }
  return checks;
}

void Regular3::check_invariants(AuditReport& report) const {
  RegularTriangulation::check_invariants(report);
  if (plane_ == nullptr) return;
  plane_->check_invariants(report);
  report.check(flat_ || plane_->empty(),
               [] { return std::string("cells, and a triangulation of a common plane"); });
}

// ---- the audit

// Certificates that have failed an even number of times since now are positive again, though cells have
// turned over.
bool Regular3::holds_at(const Snapshot& snapshot) const {
  if (planar()) return plane_->holds_at(snapshot);
  std::vector<Weighted> points(objects());
  for (ObjectId v = 0; v < objects(); ++v) {
    if (!store_.has(v)) continue;
    const auto at = [&](int axis) { return Number(CGAL::Gmpq(snapshot.position(v, axis).raw())); };
    points[v] = Weighted(Point(at(0), at(1), at(2)), 0);
  }
  for (Cell c = 0; c < store_.cell_capacity(); ++c) {
    if (!store_.live(c) || store_.ghost(c)) continue;
    if (!(volume(points, store_.quad(c)) > 0)) return false;
  }
  return true;
}

void Regular3::audit(const Snapshot& snapshot, AuditReport& report) const {
  std::vector<Weighted> points(objects());
  std::vector<ObjectId> ids;
  std::vector<std::pair<Weighted, ObjectId>> input;
  for (ObjectId id = 0; id < objects(); ++id) {
    report.check(present_[id] == snapshot.alive(id), [&] { return named("alive or not:", {id}); });
    if (!present_[id] || !snapshot.alive(id)) continue;
    const auto at = [&](int axis) { return Number(CGAL::Gmpq(snapshot.position(id, axis).raw())); };
    const Number w = at(3);
    points[id] = Weighted(Point(at(0), at(1), at(2)), geometry_.reads_radii() ? Number(w * w) : w);
    input.emplace_back(points[id], id);
    ids.push_back(id);
  }
  const Witnesses witness(input.begin(), input.end());
  if (flat_) {
    report.check(witness.dimension() < 3, [] { return std::string("not in one plane"); });
    if (planar()) plane_->audit(snapshot, report);
    return;
  }
  std::set<Quad> theirs;
  Number filled = 0, whole = 0;
  for (auto c = witness.finite_cells_begin(); c != witness.finite_cells_end(); ++c) {
    const Quad quad{c->vertex(0)->info(), c->vertex(1)->info(), c->vertex(2)->info(),
                    c->vertex(3)->info()};
    theirs.insert(sorted(quad));
    whole += volume(points, quad);
  }
  // Points may touch and turn back without any event: at such an instant cells may be flat.
  bool flat = false, ties = false;
  std::vector<Quad> upright;
  std::size_t cells = 0, common = 0;
  const bool all_points = ids.size() <= 16;
  for (Cell c = 0; c < store_.cell_capacity(); ++c) {
    if (!store_.live(c) || store_.ghost(c)) continue;
    const Quad quad = store_.quad(c);
    ++cells;
    common += theirs.count(sorted(quad));
    const Number size = volume(points, quad);
    report.check(!(size < 0), [&] {
      return named("a cell is turned over:", {quad[0], quad[1], quad[2], quad[3]});
    });
    flat = flat || size == 0;
    if (!(size > 0)) continue;
    filled += size;
    upright.push_back(quad);
    const auto look_at = [&](ObjectId v) {
      if (std::find(quad.begin(), quad.end(), v) != quad.end()) return;
      const auto side = CGAL::sign(height_over(points, quad, v));
      report.check(side != CGAL::NEGATIVE, [&] {
        return named("below the plane: points", {quad[0], quad[1], quad[2], quad[3], v});
      });
      if (side != CGAL::ZERO) return;
      ties = true;
      // A tie of this time only may be decided either way.
      if (kernel_->sign_after(geometry_.power_claim(quad, v)) != Sign::kZero) return;
      report.check(!below_by_ties(points, quad, v), [&] {
        return named("in the plane, and below by its id: points",
                     {quad[0], quad[1], quad[2], quad[3], v});
      });
    };
    if (all_points) {
      for (const ObjectId v : ids) look_at(v);
    } else {
      for (Facet f = 4 * c; f < 4 * c + 4; ++f) {
        const ObjectId v = store_.apex(store_.mate(f));
        if (v != store_.infinity()) look_at(v);
      }
    }
  }
  if (flat) return;
  report.check(filled == whole, [] { return std::string("the cells do not fill the hull"); });
  if (!ties && cells == theirs.size() && common == cells) return;
  // Of points in one lifted plane the witness may make other cells, and keep another one of a vertex and
  // hidden points, which are not compared in a large scene; the planes are the same.
  std::set<Centre> ours, of_witness;
  for (const Quad& quad : upright) ours.insert(centre_of(points, quad));
  for (const Quad& quad : theirs) of_witness.insert(centre_of(points, quad));
  report.check(ours == of_witness,
               [] { return std::string("the power diagram differs from that of the witness"); });
}

}  // namespace kinex
