// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay2: bounds, invariants, and the audit against CGAL's exact triangulation. No other file of
// this structure includes CGAL.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Lazy_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <set>
#include <utility>

#include "structures/parts/binomial.h"
#include "structures/triangulation/audit_text.h"
#include "structures/triangulation/delaunay_2.h"
#include "structures/triangulation/spread_out.h"

namespace kinex {
namespace {

using Exact = CGAL::Lazy_kernel<CGAL::Simple_cartesian<CGAL::Gmpq>>;
using Point = Exact::Point_2;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<ObjectId, Exact>;
using Witness =
    CGAL::Delaunay_triangulation_2<Exact, CGAL::Triangulation_data_structure_2<VertexBase>>;
using Edge = std::pair<ObjectId, ObjectId>;

Point point_of(const Snapshot& snapshot, ObjectId id) {
  return Point(Exact::FT(CGAL::Gmpq(snapshot.position(id, 0).raw())),
               Exact::FT(CGAL::Gmpq(snapshot.position(id, 1).raw())));
}

Edge edge_of(ObjectId a, ObjectId b) { return {std::min(a, b), std::max(a, b)}; }

}  // namespace

std::vector<BoundCheck> Delaunay2::bounds(const BoundContext& context) const {
  std::vector<BoundCheck> checks;
  const StructureLedger& ledger = *context.ledger;
  if (corrupt_) return checks;
  if (!on_line_) {
    BoundCheck check;
    check.id = "delaunay_2.certificates";
    check.source =
        "Euler's formula: one certificate per edge of the closed triangulation, 3(n + 1) - 6";
    check.bound = Integer(3) * Integer(static_cast<std::int64_t>(store_.vertices())) - Integer(3);
    check.observed = Integer(static_cast<std::int64_t>(ledger.live));
    check.holds = check.bound == check.observed;
    checks.push_back(std::move(check));
  }
  const Integer all(static_cast<std::int64_t>(context.objects()));
  checks.push_back(at_most("delaunay_2.compactness",
                           "at any time one certificate per edge at most, 3(n + 1) - 6",
                           Integer(3) * (all.is_zero() ? Integer(1) : all) - Integer(3),
                           Integer(static_cast<std::int64_t>(ledger.max_live))));
  // The theorems count flips in general position; degenerate instants may fail more certificates.
  const auto blocked = ledger.by_kind.find("blocked");
  const bool degenerate =
      (blocked != ledger.by_kind.end() && blocked->second != 0) || reinsertions_ != 0;
  if (!context.plain() || ledger.rebuilds != 0 || degenerate) return checks;
  const Integer n(static_cast<std::int64_t>(context.objects()));
  const Integer d(context.degree);
  const auto events = static_cast<std::int64_t>(ledger.failures);
  if (!on_line_) {
    checks.push_back(at_most("delaunay_2.events",
                             "each in_circle_2 changes sign 4d times, each orientation_2 2d times: "
                             "4d C(n,4) + 2d C(n,3)",
                             Integer(4) * d * binomial(n, 4) + Integer(2) * d * binomial(n, 3),
                             Integer(events)));
    if (tie_flips_ == 0) {
      checks.push_back(at_most("delaunay_2.responsiveness",
                               straight_ ? "a flip renews 5 certificates, of up to 3 hull vertices "
                                           "whose turn is identically zero twice"
                                         : "a flip renews 5 certificates",
                               Integer(straight_ ? 8 : 5),
                               Integer(static_cast<std::int64_t>(ledger.created_per_event.max))));
    }
  } else {
    checks.push_back(at_most("delaunay_2.passes", "d C(n,2): two points on a line meet d times",
                             d * binomial(n, 2), Integer(events)));
  }
  return checks;
}

bool Delaunay2::holds_claim(HalfEdge h) const {
  const CertificateId label = store_.label(h);
  if (edges_.holds(label, query_of(h), h)) return !at_infinity(h) || !edges_.is_tie(label);
  return at_infinity(h) && edges_.holds(label, straight_query_of(h), h) &&
         (!exact_ || kernel_->sign_after(query_of(h)) == Sign::kZero);
}

void Delaunay2::check_invariants(AuditReport& report) const {
  const std::size_t vertices =
      points_.check(report, [this](ObjectId id) { return store_.has(id); });
  if (on_line_) {
    report.check(line_.size() == vertices && store_.vertices() == 0,
                 [] { return std::string("the chain does not hold every vertex"); });
    return line_.check(report, "the chain");
  }
  report.check(line_.size() == 0 && store_.vertices() == vertices,
               [] { return std::string("the triangulation does not hold every vertex"); });
  const std::string defect = store_.defect();
  report.check(defect.empty(), [&] { return defect; });
  for (HalfEdge h = 0; h < store_.half_edge_capacity(); ++h) {
    if (!store_.live(Triangulation2::triangle(h)) || h > store_.twin(h)) continue;
    report.check(holds_claim(h) || holds_claim(store_.twin(h)), [&] {
      return "edge " + std::to_string(store_.origin(h)) + " " + std::to_string(store_.target(h)) +
             " has no certificate or another edge's";
    });
    report.check(!wants_other_diagonal(h), [&] {
      return "cocircular points: edge " + std::to_string(store_.origin(h)) + " " +
             std::to_string(store_.target(h)) + " does not hold the smallest id";
    });
  }
}

bool Delaunay2::holds_at(const Snapshot& snapshot) const {
  return on_line_ ||
         is_spread_out(store_, [&snapshot](ObjectId v) { return point_of(snapshot, v); });
}

void Delaunay2::audit(const Snapshot& snapshot, AuditReport& report) const {
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
  Witness witness(input.begin(), input.end());
  // Points may touch and turn back, or three be on one line, without any event: at such an instant
  // triangles may be flat, and edges are not compared.
  bool flat = witness.number_of_vertices() != input.size();
  const Attribute edges = attribute();
  std::vector<Edge> ours;
  for (std::size_t i = 0; i < edges.ids.size(); i += 2)
    ours.emplace_back(edges.ids[i], edges.ids[i + 1]);

  std::set<Edge> theirs;
  for (auto e = witness.finite_edges_begin(); e != witness.finite_edges_end(); ++e) {
    theirs.insert(edge_of(e->first->vertex(Witness::cw(e->second))->info(),
                          e->first->vertex(Witness::ccw(e->second))->info()));
  }
  if (on_line_) {
    report.check(witness.dimension() < 2, [&] { return named("not on one line:", {}); });
    if (flat) return;
    report.check(std::equal(ours.begin(), ours.end(), theirs.begin(), theirs.end()),
                 [&] { return named("the chain's edges differ from the witness", {}); });
    return;
  }

  std::size_t faces = 0;
  for (Triangle t = 0; t < store_.triangle_capacity(); ++t) {
    if (!store_.live(t) || store_.ghost(t)) continue;
    ++faces;
    const ObjectId a = store_.origin(3 * t), b = store_.origin(3 * t + 1),
                   c = store_.origin(3 * t + 2);
    const auto turned = CGAL::orientation(points[a], points[b], points[c]);
    flat = flat || turned == CGAL::COLLINEAR;
    report.check(turned != CGAL::RIGHT_TURN, [&] {
      return named("clockwise triangle", {a, b, c});
    });
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
      const ObjectId d = store_.apex(store_.twin(h));
      if (d == store_.infinity() || h > store_.twin(h)) continue;
      const auto side = CGAL::side_of_oriented_circle(points[a], points[b], points[c], points[d]);
      report.check(turned == CGAL::COLLINEAR || side != CGAL::ON_POSITIVE_SIDE, [&] {
        return named("inside the circle: points", {a, b, c, d});
      });
      if (side == CGAL::ON_ORIENTED_BOUNDARY) {  // the witness may have the other diagonal
        theirs.erase(edge_of(store_.apex(h), d));
        theirs.insert(edge_of(store_.origin(h), store_.target(h)));
      }
    }
  }
  if (flat) return;
  report.check(faces == witness.number_of_faces(),
               [&] { return named("the number of triangles differs from the witness", {}); });
  for (const Edge& e : ours) {
    report.check(theirs.count(e) != 0, [&] {
      return named("an edge that the witness does not have:", {e.first, e.second});
    });
  }
  std::vector<ObjectId> corners;
  auto around = witness.incident_vertices(witness.infinite_vertex());
  const auto first = around;
  do corners.push_back(around->info());
  while (--around != first);  // counter-clockwise around infinity is clockwise around the hull
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  const auto listed = [](const std::vector<ObjectId>& ids) {
    std::string text;
    for (const ObjectId id : ids) text += " " + std::to_string(id);
    return text;
  };
  report.check(corners == hull(), [&] {
    return named("the hull differs from the witness:", {}) + ":" + listed(hull()) + " instead of" +
           listed(corners);
  });
}

}  // namespace kinex
