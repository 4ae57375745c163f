// SPDX-License-Identifier: GPL-3.0-or-later
// The neighbours of a site at exact positions, by definition: another site r is a neighbour of s if
// points of their bisector are at least as near to s as to all others. Those points are an interval
// of the bisector, bounded by the other bisectors: O(n) for each r, and less where it is soon seen to be empty.
#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "core/engine/audit.h"
#include "core/numbers/rational.h"
#include "structures/proximity/voronoi_cell_2.h"

namespace kinex {
namespace {

struct Spot {
  Rational x, y;
  friend Spot operator-(const Spot& a, const Spot& b) { return {a.x - b.x, a.y - b.y}; }
};

Rational dot(const Spot& a, const Spot& b) { return a.x * b.x + a.y * b.y; }
Rational cross(const Spot& a, const Spot& b) { return a.x * b.y - a.y * b.x; }

// 0 for directions from that of the positive x axis on, by less than half a turn, else 1.
int half(const Spot& v) { return v.y.sign() > 0 || (v.y.sign() == 0 && v.x.sign() > 0) ? 0 : 1; }

// The edge that another spot r has in the cell of the origin. A cell may have an edge of length zero,
// where four spots or more are on an empty circle.
enum class CellEdge { kNone, kPoint, kLong };

// The point r / 2 + z (-r.y, r.x) of the bisector is at most as far from the origin as from q iff
// 2 z r x q <= q.q - r.q.
CellEdge edge_of(ObjectId r, const std::map<ObjectId, Spot>& spots) {
  const Spot& at = spots.at(r);
  std::optional<Rational> low, high;
  for (const auto& [q, other] : spots) {
    if (q == r) continue;
    const Rational slope = Rational(2) * cross(at, other);
    const Rational rest = dot(other, other) - dot(at, other);
    if (slope.is_zero()) {
      if (rest.sign() < 0) return CellEdge::kNone;
      continue;
    }
    const Rational end = rest / slope;
    if (slope.sign() > 0 && (!high || end < *high)) high = end;
    if (slope.sign() < 0 && (!low || *low < end)) low = end;
    if (low && high && *high < *low) return CellEdge::kNone;
  }
  if (!low || !high || *low < *high) return CellEdge::kLong;
  return *low == *high ? CellEdge::kPoint : CellEdge::kNone;
}

}  // namespace

// Edges of length zero may be there or not: of those that are so at this time alone nothing is known.
void VoronoiCell2::audit(const Snapshot& snapshot, AuditReport& report) const {
  const std::vector<ObjectId> ours = attribute().ids;
  if (site_ >= snapshot.objects() || !snapshot.alive(site_)) {
    return report.check(ours.empty(), [] { return "the cell of a site that is not there"; });
  }
  std::map<std::pair<Rational, Rational>, ObjectId> places;  // the smallest site at each
  for (ObjectId q = static_cast<ObjectId>(snapshot.objects()); q-- > 0;) {
    if (snapshot.alive(q)) places[{snapshot.position(q, 0), snapshot.position(q, 1)}] = q;
  }
  const Spot origin{snapshot.position(site_, 0), snapshot.position(site_, 1)};
  std::map<ObjectId, Spot> spots;
  for (const auto& [place, q] : places) {
    const Spot spot = Spot{place.first, place.second} - origin;
    if (!spot.x.is_zero() || !spot.y.is_zero()) spots.emplace(q, spot);
  }
  std::vector<ObjectId> cycle;
  for (const auto& [r, spot] : spots) {
    const CellEdge edge = edge_of(r, spots);
    const bool there = std::find(ours.begin(), ours.end(), r) != ours.end();
    report.check(there ? edge != CellEdge::kNone : edge != CellEdge::kLong,
                 [r = r] { return "a neighbour too many or too few: " + std::to_string(r); });
    if (there) cycle.push_back(r);
  }
  std::sort(cycle.begin(), cycle.end(), [&spots](ObjectId a, ObjectId b) {
    const Spot &u = spots.at(a), &v = spots.at(b);
    return half(u) != half(v) ? half(u) < half(v) : cross(u, v).sign() > 0;
  });
  if (!cycle.empty()) {
    std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
  }
  report.check(cycle == ours, [] { return "the neighbours are in another order"; });
}

}  // namespace kinex
