// SPDX-License-Identifier: GPL-3.0-or-later
// FarthestDelaunay2: bounds, invariants, and the audit: every circle against every point, exactly.
#include <array>
#include <string>

#include "core/numbers/rational.h"
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

}  // namespace

std::vector<BoundCheck> FarthestDelaunay2::bounds(const BoundContext& context) const {
  const StructureLedger& ledger = *context.ledger;
  const Integer n = counted(context.objects());
  std::vector<BoundCheck> checks{
      at_most("farthest_delaunay_2.certificates", "one for each diagonal of the hull",
              Integer(3) < n ? n - Integer(3) : Integer(0), counted(ledger.max_live))};
  if (!context.plain() || ledger.rebuilds != 0) return checks;
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

// Vertices that only touch at the time of the snapshot make flat triangles, which have no circle.
void FarthestDelaunay2::audit(const Snapshot& snapshot, AuditReport& report) const {
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
