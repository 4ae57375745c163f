// SPDX-License-Identifier: GPL-3.0-or-later
// The witness for smallest enclosing circles. No other file of these structures includes CGAL.
#include "structures/extent/min_circle_audit.h"

#include <CGAL/Gmpq.h>
#include <CGAL/Min_circle_2.h>
#include <CGAL/Min_circle_2_traits_2.h>
#include <CGAL/Simple_cartesian.h>

#include "structures/parts/binomial.h"

namespace kinex {
namespace {

using Exact = CGAL::Simple_cartesian<CGAL::Gmpq>;
using Point = Exact::Point_2;
using Witness = CGAL::Min_circle_2<CGAL::Min_circle_2_traits_2<Exact>>;

Point point_of(const Snapshot& snapshot, ObjectId id) {
  return {CGAL::Gmpq(snapshot.position(id, 0).raw()), CGAL::Gmpq(snapshot.position(id, 1).raw())};
}

}  // namespace

void audit_min_circle(const std::vector<ObjectId>& circle, const Snapshot& snapshot,
                      AuditReport& report) {
  std::vector<Point> all, ours;
  for (ObjectId id = 0; id < snapshot.objects(); ++id) {
    if (snapshot.alive(id)) all.push_back(point_of(snapshot, id));
  }
  for (const ObjectId id : circle) {
    report.check(snapshot.alive(id), [] { return "an absent point is on the circle"; });
    if (snapshot.alive(id)) ours.push_back(point_of(snapshot, id));
  }
  report.check(ours.empty() == all.empty(), [] { return "there is no circle, or one too many"; });
  if (ours.empty() || all.empty()) return;
  const Witness witness(all.begin(), all.end(), false), own(ours.begin(), ours.end(), false);
  const auto &wanted = witness.circle(), &found = own.circle();
  report.check(wanted.center() == found.center() &&
                   wanted.squared_radius() == found.squared_radius(),
               [] { return "another circle is the smallest"; });
  for (const Point& p : ours) {
    report.check(wanted.has_on_boundary(p), [] { return "a point is not on the smallest circle"; });
  }
}

void guarantee_circle(int k, std::span<const ObjectId> chosen, const Snapshot& snapshot,
                      AuditReport& report) {
  std::vector<Point> all, ours;
  for (ObjectId id = 0; id < snapshot.objects(); ++id) {
    if (snapshot.alive(id)) all.push_back(point_of(snapshot, id));
  }
  for (const ObjectId id : chosen) ours.push_back(point_of(snapshot, id));
  const Witness whole(all.begin(), all.end(), false), part(ours.begin(), ours.end(), false);
  const CGAL::Gmpq radius = part.circle().squared_radius(), square(k * k);
  report.check(radius <= whole.circle().squared_radius(),
               [] { return "the circle is larger than that of all points"; });
  for (const Point& p : all) {
    report.check(CGAL::squared_distance(p, part.circle().center()) * square <=
                     radius * (square + 1),
                 [] { return "the circle is beyond its guarantee"; });
  }
}

void add_circle_bound(const std::string& structure, const BoundContext& context,
                      std::vector<BoundCheck>& checks) {
  if (!context.plain() || context.ledger->rebuilds != 0) return;
  const Integer n = counted(context.objects()), degree(context.degree);
  checks.push_back(at_most(structure + ".external",
                           "it changes where four points are on a circle, or three form a right "
                           "angle: 4d C(n,4) + 6d C(n,3)",
                           Integer(4) * degree * binomial(n, 4) +
                               Integer(6) * degree * binomial(n, 3),
                           counted(context.ledger->external)));
}

}  // namespace kinex
