// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/predicates/ccd/contact_witness.h"

#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>

namespace kinex::test {

namespace {

using K = CGAL::Simple_cartesian<CGAL::Gmpq>;

K::Point_3 cgal(const Point& p) {
  return {CGAL::Gmpq(p[0].raw()), CGAL::Gmpq(p[1].raw()), CGAL::Gmpq(p[2].raw())};
}

// CGAL requires non-degenerate bodies.
bool holds(const K::Point_3& u, const K::Point_3& v, const K::Point_3& p) {
  return u == v ? p == u : K::Segment_3(u, v).has_on(p);
}

}  // namespace

bool cgal_touches(ContactKind kind, const std::array<Point, 4>& points) {
  const K::Point_3 a = cgal(points[0]), b = cgal(points[1]), c = cgal(points[2]),
                   d = cgal(points[3]);
  if (kind == ContactKind::kVertexFace) {
    if (!CGAL::collinear(b, c, d)) return K::Triangle_3(b, c, d).has_on(a);
    return holds(b, c, a) || holds(c, d, a) || holds(d, b, a);
  }
  if (a == b) return holds(c, d, a);
  if (c == d) return holds(a, b, c);
  return CGAL::do_intersect(K::Segment_3(a, b), K::Segment_3(c, d));
}

}  // namespace kinex::test
