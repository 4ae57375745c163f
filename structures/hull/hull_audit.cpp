// SPDX-License-Identifier: GPL-3.0-or-later
// HullSource: the audit. No other file of this family includes CGAL.
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "structures/hull/hull_source.h"

namespace kinex {
namespace {

using Exact = CGAL::Simple_cartesian<CGAL::Gmpq>;
using Point = Exact::Point_2;

Point point_of(const Snapshot& snapshot, ObjectId id) {
  return Point(CGAL::Gmpq(snapshot.position(id, 0).raw()),
               CGAL::Gmpq(snapshot.position(id, 1).raw()));
}

std::string listed(const std::vector<ObjectId>& ids) {
  std::string text;
  for (const ObjectId id : ids) text += " " + std::to_string(id);
  return text;
}

}  // namespace

void HullSource::audit(const Snapshot& snapshot, AuditReport& report) const {
  const std::vector<ObjectId> cycle = attribute().ids;
  std::vector<Point> points;
  for (ObjectId id = 0; id < snapshot.objects(); ++id) {
    if (snapshot.alive(id)) points.push_back(point_of(snapshot, id));
  }
  std::vector<Point> witness;
  CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(witness), Exact());
  std::vector<Point> ours;
  for (const ObjectId id : cycle) {
    if (!snapshot.alive(id)) {
      report.check(false, [&] { return "a hull vertex that is not there: " + std::to_string(id); });
      return;
    }
    ours.push_back(point_of(snapshot, id));
  }
  const auto differs = [&] {
    return std::string("the hull differs from the witness:") + listed(cycle);
  };
  report.check(cycle.empty() || *std::min_element(cycle.begin(), cycle.end()) == cycle.front(),
               [&] { return "the cycle does not start at its smallest id"; });
  // Every vertex of the witness, in the same cyclic order; all others lie on its edges.
  std::vector<Point> strict;
  std::vector<Point> rest;
  for (const Point& p : ours) {
    const bool vertex = std::find(witness.begin(), witness.end(), p) != witness.end();
    const bool again = !strict.empty() && (strict.back() == p || strict.front() == p);
    if (vertex && !again) {
      strict.push_back(p);
    } else {
      rest.push_back(p);
    }
  }
  report.check(strict.size() == witness.size(), differs);
  if (strict.size() != witness.size()) return;
  if (!witness.empty()) {
    const auto first = std::find(strict.begin(), strict.end(), witness.front());
    if (first != strict.end()) std::rotate(strict.begin(), first, strict.end());
  }
  report.check(strict == witness, differs);
  for (const Point& p : rest) {
    bool on_boundary = false;
    for (std::size_t i = 0; i < witness.size() && !on_boundary; ++i) {
      const Point& a = witness[i];
      const Point& b = witness[i + 1 == witness.size() ? 0 : i + 1];
      on_boundary = p == a || p == b || CGAL::collinear_are_ordered_along_line(a, p, b);
    }
    report.check(on_boundary, differs);
  }
}

}  // namespace kinex
