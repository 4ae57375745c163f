// SPDX-License-Identifier: GPL-3.0-or-later
// FlatTriangulation: bounds, invariants, and the audit against CGAL's exact triangulation in space, which is
// the Delaunay triangulation of their plane for points that are all in one.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <utility>

#include "structures/parts/binomial.h"
#include "structures/triangulation/audit_text.h"
#include "structures/triangulation/flat_triangulation.h"
#include "structures/triangulation/in_plane_audit.h"

namespace kinex {
namespace {

using namespace in_plane_audit;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<ObjectId, Exact>;
using Witness = CGAL::Delaunay_triangulation_3<
    Exact, CGAL::Triangulation_data_structure_3<VertexBase,
                                                CGAL::Delaunay_triangulation_cell_base_3<Exact>>>;

}  // namespace

template bool InPlane<PlaneFlips<SewnTriangulation<RegularGeometry<PlaneComplex>>>>::holds_at(
    const Snapshot&) const;

std::vector<BoundCheck> FlatTriangulation::bounds(const BoundContext& context) const {
  std::vector<BoundCheck> checks;
  const StructureLedger& ledger = *context.ledger;
  if (corrupt_ || !context.plain() || ledger.rebuilds != 0 || sews_ != 0 || blocks_ != 0) {
    return checks;
  }
  const Integer n = counted(context.objects()), d(context.degree);
  checks.push_back(at_most("delaunay_3.line_events",
                           "two points on a line pass each other at most d times: d C(n,2)",
                           d * binomial(n, 2), counted(passes_)));
  const Integer quads = binomial(n, 4), triples = binomial(n, 3);
  if (ties_ != 0) {
    checks.push_back(
        at_most("delaunay_3.plane_events",
                "four points of the plane change at a root of their circle, or of their four "
                "orientations; three of the hull at one of their orientation, or of their three "
                "angles: 8d C(n,4) + 6d C(n,3)",
                Integer(8) * d * quads + Integer(6) * d * triples, counted(flips_)));
    return checks;
  }
  checks.push_back(at_most("delaunay_3.plane_events",
                           "each circle of the plane changes sign 4d times, each orientation 2d "
                           "times: 4d C(n,4) + 2d C(n,3)",
                           Integer(4) * d * quads + Integer(2) * d * triples, counted(flips_)));
  checks.push_back(at_most("delaunay_3.plane_responsiveness", "5 certificates for a flip",
                           Integer(5), counted(ledger.created_per_event.max)));
  return checks;
}

void FlatTriangulation::check_invariants(AuditReport& report) const {
  report.check(untold_.size() == 0,
               [] { return std::string("triangles of the plane that were not reported"); });
  report.check(flat_ ? store_.triangles() == 0 : store_.vertices() == vertices_.size(),
               [] { return std::string("the triangulation of the plane lacks a vertex"); });
  report.check(line_.size() == (flat_ && vertices_.size() > 1 ? vertices_.size() : 0),
               [] { return std::string("the chain lacks a point"); });
  line_.check(report, "the chain");
  const std::string defect = store_.defect();
  report.check(defect.empty(), [&] { return defect; });
  if (!defect.empty()) return;
  for (Facet h = 0; h < 3 * store_.triangle_capacity(); ++h) {
    if (!store_.live(PlaneComplex::cell(h)) || store_.twin(h) < h) continue;
    const CertificateId label = store_.label(h);
    const auto holds = [&](Facet tag) {
      const bool tie = kernel_->sign_after(claim_of(tag)) == Sign::kZero;
      return facets_.holds(label, tie ? tie_claim_of(tag) : claim_of(tag), tag);
    };
    const auto text = [&](const char* what) {
      return named("edge", {store_.origin(h), store_.target(h)}) + what;
    };
    report.check(holds(h) || holds(store_.twin(h)),
                 [&] { return text(" has no certificate or another edge's"); });
    report.check(!facets_.is_tie(label), [&] { return text(" is identically flat"); });
  }
}

void FlatTriangulation::audit(const Snapshot& snapshot, AuditReport& report) const {
  std::vector<Point> points(store_.infinity());
  std::vector<std::pair<Point, ObjectId>> input;
  for (const ObjectId id : vertices_) {
    points[id] = point_of(snapshot, id);
    input.emplace_back(points[id], id);
  }
  const Witness witness(input.begin(), input.end());
  if (flat_) {
    report.check(witness.dimension() < 2, [] { return std::string("not on one line"); });
    if (witness.number_of_vertices() != input.size()) return;  // two points touch
    report.check(edges() == edges_of(witness),
                 [] { return std::string("other neighbours on the line than the witness"); });
    return;
  }
  report.check(witness.dimension() < 3, [] { return std::string("not in one plane"); });
  // Points may touch and turn back without any event: at such an instant triangles may be flat.
  if (witness.dimension() != 2 || witness.number_of_vertices() != input.size()) return;
  const WitnessPlane plane = plane_of(witness);
  const std::optional<bool> ties = check_triangles(
      store_, vertices_, points, plane,
      [&](const Corners& c, ObjectId v) {
        switch (CGAL::coplanar_side_of_bounded_circle(points[c[0]], points[c[1]], points[c[2]],
                                                      points[v])) {
          case CGAL::ON_BOUNDED_SIDE:
            return CGAL::NEGATIVE;
          case CGAL::ON_BOUNDARY:
            return CGAL::ZERO;
          default:
            return CGAL::POSITIVE;
        }
      },
      [this](const Corners& c, ObjectId v) {
        return kernel_->sign_after(geometry_.power_claim(c, v)) == Sign::kZero;
      },
      {"inside the circle: points", "on the circle, and inside by its id: points"}, report);
  if (!ties) return;
  // Of points on one circle the witness may have other edges.
  report.check(*ties || edges() == edges_of(witness),
               [] { return std::string("the edges of the plane differ from the witness"); });
}

}  // namespace kinex
