// SPDX-License-Identifier: GPL-3.0-or-later
// The guarantees of extents by directions, for audits: exact rational arithmetic, nothing in common
// with the predicates.
#ifndef KINEX_STRUCTURES_EXTENT_EXTENT_GUARANTEES_AUDIT_H
#define KINEX_STRUCTURES_EXTENT_EXTENT_GUARANTEES_AUDIT_H

#include <span>
#include <vector>

#include "core/engine/audit.h"
#include "core/numbers/rational.h"

namespace kinex {

// All living objects of a snapshot, ascending.
std::vector<ObjectId> living(const Snapshot& snapshot);
// Of these objects: the largest squared distance of two, and the square of the width in the plane
// (the least distance of two parallel lines around them); 0 for fewer than two.
Rational squared_diameter(const Snapshot& snapshot, std::span<const ObjectId> objects);
Rational squared_width(const Snapshot& snapshot, std::span<const ObjectId> objects);
// The strict vertices of their convex hull in the plane, counter-clockwise; of equal points the
// smallest id.
std::vector<ObjectId> exact_hull(const Snapshot& snapshot, std::span<const ObjectId> objects);
// sqrt(a) <= sqrt(b) + sqrt(c) for numbers >= 0.
bool root_at_most_sum(const Rational& a, const Rational& b, const Rational& c);

// Diameter and width of `chosen`, the extreme ones of 4k directions, against those of all.
void audit_guarantees(int k, std::span<const ObjectId> chosen, const Snapshot& snapshot,
                      AuditReport& report);

}  // namespace kinex

#endif
