// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay3: bounds, invariants, and the audit against CGAL's exact triangulation. No other file of
// this structure includes CGAL.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Lazy_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <set>
#include <utility>

#include "structures/parts/binomial.h"
#include "structures/triangulation/audit_text.h"
#include "structures/triangulation/delaunay_3.h"

namespace kinex {
namespace {

using Exact = CGAL::Lazy_kernel<CGAL::Simple_cartesian<CGAL::Gmpq>>;
using Number = Exact::FT;
using Point = Exact::Point_3;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<ObjectId, Exact>;
using CellBase = CGAL::Delaunay_triangulation_cell_base_3<Exact>;
using Witness =
    CGAL::Delaunay_triangulation_3<Exact,
                                   CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;
using Quad = std::array<ObjectId, 4>;

Point point_of(const Snapshot& snapshot, ObjectId id) {
  const auto at = [&](int axis) { return Number(CGAL::Gmpq(snapshot.position(id, axis).raw())); };
  return Point(at(0), at(1), at(2));
}

Quad sorted(Quad quad) {
  std::sort(quad.begin(), quad.end());
  return quad;
}

// A point on the sphere of an upright cell: true if it lies inside after the heights of the points
// have been lowered by eps_i, smaller ids much more. The first nonzero coefficient of the lifted
// determinant, in which the heights are the last column, decides: that of eps_i has 1 there for
// point i and 0 for the others.
bool inside_by_ties(const std::vector<Point>& points, const Quad& cell, ObjectId v) {
  std::array<ObjectId, 5> row{cell[0], cell[1], cell[2], cell[3], v};
  std::array<ObjectId, 5> order = row;
  std::sort(order.begin(), order.end());
  for (const ObjectId lowered : order) {
    // Expanded along the last column: the minor without the row of the point, with a column of ones.
    const auto at =
        static_cast<std::size_t>(std::find(row.begin(), row.end(), lowered) - row.begin());
    std::array<ObjectId, 4> others{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < 5; ++i) {
      if (i != at) others[count++] = row[i];
    }
    const auto sign = CGAL::orientation(points[others[0]], points[others[1]], points[others[2]],
                                        points[others[3]]);
    if (sign == CGAL::COPLANAR) continue;
    // v alone gives the upright cell, and lowering v brings it inside; signs of cofactors alternate.
    return ((4 - at) % 2 == 0) == (sign == CGAL::POSITIVE);
  }
  return false;
}

}  // namespace

// Certificates that have failed an even number of times since now are positive again, though cells have
// turned over.
bool Delaunay3::holds_at(const Snapshot& snapshot) const {
  if (planar()) return plane_->holds_at(snapshot);
  for (Cell c = 0; c < store_.cell_capacity(); ++c) {
    if (!store_.live(c) || store_.ghost(c)) continue;
    const Quad quad = store_.quad(c);
    const auto at = [&](std::size_t i) { return point_of(snapshot, quad[i]); };
    if (CGAL::orientation(at(0), at(1), at(2), at(3)) != CGAL::POSITIVE) return false;
  }
  return true;
}

std::vector<BoundCheck> Delaunay3::bounds(const BoundContext& context) const {
  std::vector<BoundCheck> checks;
  const StructureLedger& ledger = *context.ledger;
  if (corrupt_ || (plane_ != nullptr && plane_->corrupt())) return checks;
  BoundCheck check;
  check.id = "delaunay_3.certificates";
  check.source =
      "Euler's formula: one certificate per facet, twice the number of cells, ghosts included; of "
      "points "
      "in one plane one per edge, 3n - 3";
  check.bound = counted(2 * store_.cells() + (planar() ? plane_->wanted() : 0));
  check.observed = Integer(static_cast<std::int64_t>(ledger.live));
  check.holds = check.bound == check.observed;
  checks.push_back(std::move(check));
  const Integer n(static_cast<std::int64_t>(context.objects()));
  const Integer most = (n + Integer(1)) * (n - Integer(2));
  checks.push_back(at_most(
      "delaunay_3.compactness", "2 (E - V) facets, V = n + 1, E <= C(n + 1, 2)",
      most.sign() < 0 ? Integer(0) : most, Integer(static_cast<std::int64_t>(ledger.max_live))));
  checks.push_back(at_most(
      "delaunay_3.largest_sew",
      "the cells of the largest part that was sewn: not all, of which there are E - V",
      most.sign() < 0 ? Integer(0) : floor_divide(most, Integer(2)), counted(largest_sew())));
  if (plane_ != nullptr) {
    for (BoundCheck& of_plane : plane_->bounds(context)) checks.push_back(std::move(of_plane));
    return checks;
  }
  // The theorems count flips in general position; degenerate instants may fail more certificates.
  if (!context.plain() || ledger.rebuilds != 0 || sews_ != 0 || blocks_ != 0) return checks;
  const Integer d(context.degree);
  // All facets with one polynomial touch zero together, and nothing changes.
  const auto touches = ledger.by_kind.find("touch");
  const Integer touched = counted(touches == ledger.by_kind.end() ? 0 : touches->second);
  if (ties_ != 0) {
    checks.push_back(
        at_most("delaunay_3.events",
                "five points change at a root of in_sphere_3, or of their five orientations; four "
                "of the hull at one of their orientation, or of the angles at their six edges: "
                "15d C(n,5) + 24d C(n,4)",
                Integer(15) * d * binomial(n, 5) + Integer(24) * d * binomial(n, 4),
                counted(ledger.processed) - touched));
    return checks;
  }
  checks.push_back(at_most("delaunay_3.events",
                           "each in_sphere_3 changes sign 5d times, each orientation_3 3d times: "
                           "5d C(n,5) + 3d C(n,4)",
                           Integer(5) * d * binomial(n, 5) + Integer(3) * d * binomial(n, 4),
                           counted(ledger.failures) - touched));
  checks.push_back(at_most("delaunay_3.responsiveness", "a flip renews 9 certificates at most",
                           Integer(9),
                           Integer(static_cast<std::int64_t>(ledger.created_per_event.max))));
  return checks;
}

void Delaunay3::check_invariants(AuditReport& report) const {
  const std::size_t vertices =
      points_.check(report, [this](ObjectId id) { return store_.has(id); });
  for (ObjectId id = 0; id < objects() && !flat_; ++id) {
    if (points_.is_vertex(id)) {
      report.check(store_.has(id), [&] { return named("no vertex:", {id}); });
    }
  }
  report.check(flat_ ? store_.cells() == 0 : store_.vertices() == vertices,
               [] { return std::string("the triangulation does not hold every vertex"); });
  report.check(untold_.size() == 0, [] { return std::string("cells that were not reported"); });
  if (plane_ != nullptr) plane_->check_invariants(report);
  const std::string defect = store_.defect();
  report.check(defect.empty(), [&] { return defect; });
  if (!defect.empty()) return;
  for (Cell c = 0; c < store_.cell_capacity(); ++c) {
    if (!store_.live(c)) continue;
    for (Facet f = 4 * c; f < 4 * c + 4; ++f) {
      if (f > store_.mate(f)) continue;
      const CertificateId label = store_.label(f);
      const Facet g = store_.mate(f);
      const auto holds = [&](Facet tag) {
        const bool tie = kernel_->sign_after(claim_of(tag)) == Sign::kZero;
        return facets_.holds(label, tie ? tie_claim_of(tag) : claim_of(tag), tag);
      };
      const auto text = [&](const char* what) {
        const Triangulation3::Triple t = store_.triple(f);
        return named("facet", {t[0], t[1], t[2]}) + what;
      };
      report.check(holds(f) || holds(g),
                   [&] { return text(" has no certificate or another facet's"); });
      report.check(!facets_.is_tie(label), [&] { return text(" is identically flat"); });
    }
  }
}

void Delaunay3::audit(const Snapshot& snapshot, AuditReport& report) const {
  std::vector<Point> points(objects());
  std::vector<std::pair<Point, ObjectId>> input;
  for (ObjectId id = 0; id < objects(); ++id) {
    const bool present = points_.present(id);
    report.check(present == snapshot.alive(id), [&] { return named("alive or not:", {id}); });
    if (!present || !snapshot.alive(id)) continue;
    points[id] = point_of(snapshot, id);
    if (points_.is_vertex(id)) {
      input.emplace_back(points[id], id);
    } else {
      report.check(points[id] == point_of(snapshot, representative(id)), [&] {
        return named("hidden but not equal:", {id, representative(id)});
      });
    }
  }
  const Witness witness(input.begin(), input.end());
  if (flat_) {
    report.check(witness.dimension() < 3, [] { return std::string("not in one plane"); });
    if (planar()) plane_->audit(snapshot, report);
    return;
  }
  // Points may touch and turn back without any event: at such an instant cells may be flat.
  bool flat = witness.number_of_vertices() != input.size();
  bool ties = false;
  Number volume = 0, whole = 0;
  std::set<Quad> theirs;
  for (auto c = witness.finite_cells_begin(); c != witness.finite_cells_end(); ++c) {
    theirs.insert(sorted(
        {c->vertex(0)->info(), c->vertex(1)->info(), c->vertex(2)->info(), c->vertex(3)->info()}));
    whole += CGAL::volume(c->vertex(0)->point(), c->vertex(1)->point(), c->vertex(2)->point(),
                          c->vertex(3)->point());
  }
  std::size_t cells = 0, common = 0;
  const bool all_points = input.size() <= 16;
  for (Cell c = 0; c < store_.cell_capacity(); ++c) {
    if (!store_.live(c)) continue;
    const Quad quad = store_.quad(c);
    const auto at = [&](std::size_t i) -> const Point& { return points[quad[i]]; };
    if (store_.ghost(c)) continue;
    ++cells;
    common += theirs.count(sorted(quad));
    const auto turned = CGAL::orientation(at(0), at(1), at(2), at(3));
    flat = flat || turned == CGAL::COPLANAR;
    report.check(turned != CGAL::NEGATIVE, [&] {
      return named("a cell is turned over:", {quad[0], quad[1], quad[2], quad[3]});
    });
    if (turned != CGAL::POSITIVE) continue;
    volume += CGAL::volume(at(0), at(1), at(2), at(3));
    const auto look_at = [&](ObjectId v) {
      if (std::find(quad.begin(), quad.end(), v) != quad.end()) return;
      const auto side = CGAL::side_of_oriented_sphere(at(0), at(1), at(2), at(3), points[v]);
      report.check(side != CGAL::ON_POSITIVE_SIDE, [&] {
        return named("inside the sphere: points", {quad[0], quad[1], quad[2], quad[3], v});
      });
      if (side != CGAL::ON_ORIENTED_BOUNDARY) return;
      ties = true;
      // A tie of this time only may be decided either way.
      const Query claim = geometry_.power_claim(quad, v);
      if (kernel_->sign_after(claim) != Sign::kZero) return;
      report.check(!inside_by_ties(points, quad, v), [&] {
        return named("on the sphere, and inside by its id: points",
                     {quad[0], quad[1], quad[2], quad[3], v});
      });
    };
    if (all_points) {
      for (const auto& [point, v] : input) look_at(v);
    } else {
      for (Facet f = 4 * c; f < 4 * c + 4; ++f) {
        const ObjectId v = store_.apex(store_.mate(f));
        if (v != store_.infinity()) look_at(v);
      }
    }
  }
  if (flat) return;
  report.check(volume == whole, [] { return std::string("the cells do not fill the hull"); });
  // Of points on one sphere the witness may make other cells.
  report.check(ties || (cells == theirs.size() && common == cells),
               [] { return std::string("the cells differ from the witness"); });
}

}  // namespace kinex
