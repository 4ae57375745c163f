// SPDX-License-Identifier: GPL-3.0-or-later
// The guarantees of extents by directions, for audits: exact rational arithmetic, nothing in common
// with the predicates. README.md has them as a table, with their reasons.
#ifndef KINEX_STRUCTURES_EXTENT_EXTENT_GUARANTEES_AUDIT_H
#define KINEX_STRUCTURES_EXTENT_EXTENT_GUARANTEES_AUDIT_H

#include <span>
#include <vector>

#include "core/engine/audit.h"
#include "core/numbers/rational.h"
#include "structures/hull/hull_source.h"

namespace kinex {

// All living objects of a snapshot, ascending.
std::vector<ObjectId> living(const Snapshot& snapshot);
// Of these objects: the largest squared distance of two, and the square of the width in the plane
// (the least distance of two parallel lines around them); 0 for fewer than two.
Rational squared_diameter(const Snapshot& snapshot, std::span<const ObjectId> objects);
Rational squared_width(const Snapshot& snapshot, std::span<const ObjectId> objects);
// Of the least rectangles around these objects: the area, and the square of half the perimeter. A
// segment has the area 0, and is half its perimeter long.
Rational least_area(const Snapshot& snapshot, std::span<const ObjectId> objects);
Rational squared_half_perimeter(const Snapshot& snapshot, std::span<const ObjectId> objects);
// The strict vertices of their convex hull in the plane, counter-clockwise; of equal points the
// smallest id.
std::vector<ObjectId> exact_hull(const Snapshot& snapshot, std::span<const ObjectId> objects);
// sqrt(a) <= sqrt(b) + sqrt(c) for numbers >= 0.
bool root_at_most_sum(const Rational& a, const Rational& b, const Rational& c);

// Of `chosen`, the extreme ones of 4k directions, against those of all.
void guarantee_diameter(int k, std::span<const ObjectId> chosen, const Snapshot& snapshot,
                        AuditReport& report);
void guarantee_width(int k, std::span<const ObjectId> chosen, const Snapshot& snapshot,
                     AuditReport& report);
void guarantee_area(int k, std::span<const ObjectId> chosen, const Snapshot& snapshot,
                    AuditReport& report);
void guarantee_perimeter(int k, std::span<const ObjectId> chosen, const Snapshot& snapshot,
                         AuditReport& report);

// The audit of a reader of `hull`: audit(snapshot) if that is the hull of all points. If it is that
// of directions, audit(the same with the vertices alone), which the reader knows to be there, and
// guarantee(k, the vertices, snapshot, report), whose error is proven. (A ring of one vertex: all
// points are equal.)
template <class Audit, class Guarantee>
void audit_reader(const HullSource& hull, const Snapshot& snapshot, AuditReport& report,
                  const Audit& audit, const Guarantee& guarantee) {
  const std::vector<ObjectId> cycle = hull.ring().size() < 2 ? std::vector<ObjectId>{}
                                                             : hull.ring().cycle();
  if (hull.fineness() == 0 || cycle.empty()) return audit(snapshot);
  std::vector<bool> is_vertex(snapshot.objects(), false);
  for (const ObjectId vertex : cycle) is_vertex[vertex] = true;
  audit(snapshot.of(is_vertex));
  guarantee(hull.fineness(), std::span<const ObjectId>(cycle), snapshot, report);
}

}  // namespace kinex

#endif
