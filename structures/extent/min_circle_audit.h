// SPDX-License-Identifier: GPL-3.0-or-later
// What all structures for the smallest enclosing circle share: the audit, and the bound on changes.
#ifndef KINEX_STRUCTURES_EXTENT_MIN_CIRCLE_AUDIT_H
#define KINEX_STRUCTURES_EXTENT_MIN_CIRCLE_AUDIT_H

#include <span>
#include <string>
#include <vector>

#include "core/engine/audit.h"
#include "core/engine/bound.h"

namespace kinex {

// Compares the points on the circle with CGAL's Min_circle_2 on exact positions: they are on the
// smallest circle of all points, and no smaller circle encloses them.
void audit_min_circle(const std::vector<ObjectId>& circle, const Snapshot& snapshot,
                      AuditReport& report);

// The guarantee of the circle of `chosen`, the extreme points of 4k directions: it is not larger than
// the smallest one of all points, and about the same centre, larger by a factor of
// sqrt(1 + 1/k^2), it contains them.
void guarantee_circle(int k, std::span<const ObjectId> chosen, const Snapshot& snapshot,
                      AuditReport& report);

// Without flight-plan changes: the circle changes where four points are on a circle, or three form
// a right angle: 4d C(n,4) + 6d C(n,3) instants.
void add_circle_bound(const std::string& structure, const BoundContext& context,
                      std::vector<BoundCheck>& checks);

}  // namespace kinex

#endif
