// SPDX-License-Identifier: GPL-3.0-or-later
// FarthestDelaunay2: bounds, invariants, and the audit: every circle against every point, exactly.
// Over a hull of directions: against every vertex, and the guarantee for all points.
#include <array>
#include <span>
#include <string>

#include "core/numbers/rational.h"
#include "structures/extent/extent_guarantees_audit.h"
#include "structures/extent/farthest_delaunay_2.h"
#include "structures/parts/binomial.h"

namespace kinex {
namespace {

struct Vector {
  Rational x, y;
};

Vector from_to(const Snapshot& snapshot, ObjectId a, ObjectId b) {
  return {snapshot.position(b, 0) - snapshot.position(a, 0),
          snapshot.position(b, 1) - snapshot.position(a, 1)};
}

Rational cross(const Vector& u, const Vector& v) { return u.x * v.y - u.y * v.x; }

// Positive iff d is inside the circle through a, b, c, for a, b, c counter-clockwise.
Rational in_circle(const Snapshot& snapshot, ObjectId a, ObjectId b, ObjectId c, ObjectId d) {
  const Vector u = from_to(snapshot, d, a), v = from_to(snapshot, d, b), w = from_to(snapshot, d, c);
  const auto square = [](const Vector& r) { return r.x * r.x + r.y * r.y; };
  return square(u) * cross(v, w) + square(v) * cross(w, u) + square(w) * cross(u, v);
}

// The corners a, b, c of a circle, and every point that is farther from its centre than the radius
// and D'/2k together: what sticks out of an edge of the vertices' hull is that high at most.
void guarantee_circle(int k, const std::array<ObjectId, 3>& corners, const Rational& diameter,
                      const Snapshot& snapshot, AuditReport& report) {
  const auto [a, b, c] = corners;
  const Vector u = from_to(snapshot, a, b), v = from_to(snapshot, a, c);
  const Rational turn = Rational(2) * cross(u, v);
  if (turn.is_zero()) return;
  const Rational uu = u.x * u.x + u.y * u.y, vv = v.x * v.x + v.y * v.y;
  const Vector centre{(v.y * uu - u.y * vv) / turn, (u.x * vv - v.x * uu) / turn};  // from a
  const Rational radius = centre.x * centre.x + centre.y * centre.y;
  const Rational error = diameter / Rational(Integer(4) * Integer(k) * Integer(k));
  for (const ObjectId p : living(snapshot)) {
    const Vector to = from_to(snapshot, a, p);
    const Rational x = to.x - centre.x, y = to.y - centre.y;
    report.check(root_at_most_sum(x * x + y * y, radius, error),
                 [] { return std::string("a circle is beyond its guarantee"); });
  }
}

}  // namespace

std::vector<BoundCheck> FarthestDelaunay2::bounds(const BoundContext& context) const {
  const StructureLedger& ledger = *context.ledger;
  const Integer n = counted(context.objects());
  std::vector<BoundCheck> checks{
      at_most("farthest_delaunay_2.certificates", "one for each diagonal of the hull",
              Integer(3) < n ? n - Integer(3) : Integer(0), counted(ledger.max_live))};
  // Vertices of a hull of directions jump.
  if (!context.plain() || ledger.rebuilds != 0 || hull_->fineness() != 0) return checks;
  const Integer degree(context.degree);
  checks.push_back(at_most(
      "farthest_delaunay_2.external",
      "it changes where four points are on a circle, three on a line or two meet: instants, "
      "4d C(n,4) + 2d C(n,3) + d C(n,2)",
      Integer(4) * degree * binomial(n, 4) + Integer(2) * degree * binomial(n, 3) +
          degree * binomial(n, 2),
      counted(ledger.external)));
  return checks;
}

void FarthestDelaunay2::check_invariants(AuditReport& report) const {
  const HullRing& ring = hull_->ring();
  report.check(cycle() == (ring.size() == 0 ? std::vector<ObjectId>{} : ring.cycle()),
               [] { return "its cycle is not that of the hull"; });
  report.check(untold_.size() == 0 && failing_.empty() && ties_.empty(),
               [] { return "an instant is not over"; });
  const std::string defect = store_.defect();
  report.check(defect.empty(), [&] { return defect; });
  report.check(few_.empty() || store_.vertices() == 0, [] { return "two kinds of vertices"; });
  for (HalfEdge h = 0; h < store_.half_edge_capacity(); ++h) {
    if (!store_.live(Triangulation2::triangle(h)) || to_infinity(h) || named(h) != h) continue;
    const auto name = [&] {
      return "wrong at the edge " + std::to_string(store_.origin(h)) + " " +
             std::to_string(store_.target(h));
    };
    const CertificateId slot = store_.label(h);
    report.check(is_diagonal(h) ? slots_.holds(slot, query_of(h), h) : slot == kNoCertificate, name);
    report.check(!is_diagonal(h) || !wants_other_diagonal(h), name);
  }
}

void FarthestDelaunay2::audit(const Snapshot& snapshot, AuditReport& report) const {
  const auto circles = [this, &report](const Snapshot& points) { audit_circles(points, report); };
  const auto guarantee = [this](int k, std::span<const ObjectId> chosen, const Snapshot& all,
                                AuditReport& into) {
    const Rational diameter = squared_diameter(all, chosen);
    for (Triangle t = 0; t < store_.triangle_capacity(); ++t) {
      if (!store_.live(t) || store_.ghost(t)) continue;
      guarantee_circle(k, {store_.origin(3 * t), store_.origin(3 * t + 1), store_.origin(3 * t + 2)},
                       diameter, all, into);
    }
  };
  audit_reader(*hull_, snapshot, report, circles, guarantee);
}

// Vertices that only touch at the time of the snapshot make flat triangles, which have no circle.
void FarthestDelaunay2::audit_circles(const Snapshot& snapshot, AuditReport& report) const {
  std::size_t triangles = 0;
  for (Triangle t = 0; t < store_.triangle_capacity(); ++t) {
    if (!store_.live(t) || store_.ghost(t)) continue;
    ++triangles;
    const ObjectId a = store_.origin(3 * t), b = store_.origin(3 * t + 1);
    const ObjectId c = store_.origin(3 * t + 2);
    const int turn = cross(from_to(snapshot, a, b), from_to(snapshot, a, c)).sign();
    const auto name = [&](const char* what) {
      return what + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c);
    };
    report.check(turn >= 0, [&] { return name("clockwise triangle "); });
    for (ObjectId d = 0; d < snapshot.objects() && turn > 0; ++d) {
      if (!snapshot.alive(d)) continue;
      report.check(in_circle(snapshot, a, b, c, d).sign() >= 0, [&] {
        return "object " + std::to_string(d) + name(" is outside the circle of ");
      });
    }
  }
  report.check(triangles == (store_.vertices() == 0 ? 0 : store_.vertices() - 2),
               [] { return "the number of triangles is wrong"; });
}

}  // namespace kinex
