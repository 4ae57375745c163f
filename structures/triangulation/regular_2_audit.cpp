// SPDX-License-Identifier: GPL-3.0-or-later
// Regular2: bounds, invariants, and the audit against CGAL's exact triangulation. No other file of this
// structure includes CGAL.
#include <CGAL/Gmpq.h>
#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "structures/parts/binomial.h"
#include "structures/triangulation/audit_text.h"
#include "structures/triangulation/regular_2.h"

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

std::vector<BoundCheck> Regular2::bounds(const BoundContext& context) const {
  std::vector<BoundCheck> checks;
  const StructureLedger& ledger = *context.ledger;
  if (corrupt_) return checks;
  BoundCheck check;
  check.id = "regular_2.certificates";
  check.source =
      "Euler's formula: 3n' - 3 edges of the closed triangulation of n' vertices; 4 for each hidden "
      "point";
  const auto vertices = static_cast<std::int64_t>(store_.vertices());
  const auto all = static_cast<std::int64_t>(flat_ ? 0 : hidden().size());
  check.bound = flat_ ? Integer(0) : Integer(3 * vertices - 3 + 4 * all);
  check.observed = Integer(static_cast<std::int64_t>(ledger.live));
  check.holds = check.bound == check.observed;
  checks.push_back(std::move(check));
  const auto n = static_cast<std::int64_t>(context.objects());
  checks.push_back(at_most("regular_2.compactness",
                           "3n' - 3 + 4 (n - n') for n' >= 3 vertices: at most 4n - 6",
                           Integer(std::max<std::int64_t>(0, 4 * n - 6)),
                           Integer(static_cast<std::int64_t>(ledger.max_live))));
  // The theorems count changes in general position; degenerate instants may fail more certificates.
  const bool degenerate =
      ledger.rebuilds != 0 || sews_ != 0 || blocks_ != 0 || waits_ != 0 || ties_ != 0;
  if (!context.plain() || degenerate) return checks;
  const Integer d(context.degree), objects(n);
  const Integer most =
      Integer(4) * d * binomial(objects, 4) + Integer(2) * d * binomial(objects, 3);
  const char* const source =
      "each power changes sign 4D times, each orientation 2D times: 4D C(n,4) + 2D C(n,3)";
  checks.push_back(at_most("regular_2.events", source, most,
                           Integer(static_cast<std::int64_t>(changes_))));
  checks.push_back(at_most("regular_2.witnesses", source, most,
                           Integer(static_cast<std::int64_t>(witnesses_.line().failures))));
  checks.push_back(at_most("regular_2.responsiveness",
                           "5 certificates for a flip, 6 for a point that shows, 7 for one that hides",
                           Integer(7),
                           Integer(static_cast<std::int64_t>(ledger.created_per_event.max))));
  return checks;
}

void Regular2::check_invariants(AuditReport& report) const {
  for (ObjectId id = 0; id < present_.size(); ++id) {
    const bool has = witness_[id].corners[0] != kNoObject;
    const bool wanted = present_[id] && !flat_ && !store_.has(id);
    report.check(has == wanted && (present_[id] || !store_.has(id)),
                 [&] { return named("a vertex with a witness, or hidden without one:", {id}); });
    if (!has) continue;
    for (unsigned i = 0; i < 4; ++i) {
      report.check(witnesses_.holds(witness_[id].certificates[i], witness_query(id, i), id),
                   [&] { return named("a wrong certificate of hidden point", {id}); });
    }
    report.check(geometry_.orientation(witness_[id].corners) == Sign::kPositive &&
                     !geometry_.below(witness_[id].corners, id),
                 [&] { return named("a witness that proves nothing, of point", {id}); });
  }
  report.check(waiting_.empty(), [] { return std::string("hidden points wait for a witness"); });
  report.check(!flat_ || store_.triangles() == 0,
               [] { return std::string("triangles of points on one line"); });
  report.check(untold_.size() == 0, [] { return std::string("triangles that were not reported"); });
  const std::string defect = store_.defect();
  report.check(defect.empty(), [&] { return defect; });
  if (!defect.empty()) return;
  for (HalfEdge h = 0; h < store_.half_edge_capacity(); ++h) {
    if (!store_.live(Triangulation2::triangle(h)) || h > store_.twin(h)) continue;
    const CertificateId label = store_.label(h);
    const auto holds = [&](HalfEdge tag) {
      const bool tie = kernel_->sign_after(claim_of(tag)) == Sign::kZero;
      return edges_.holds(label, tie ? tie_claim_of(tag) : claim_of(tag), tag);
    };
    const auto text = [&](const char* what) {
      return named("edge", {store_.origin(h), store_.target(h)}) + what;
    };
    report.check(holds(h) || holds(store_.twin(h)),
                 [&] { return text(" has no certificate or another edge's"); });
    report.check(!edges_.is_tie(label), [&] { return text(" is identically flat"); });
  }
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
  // Of points in one lifted plane the witness may make other triangles.
  report.check(ties || (cells == theirs.size() && common == cells),
               [] { return std::string("the triangles differ from the witness"); });
}

}  // namespace kinex
