// SPDX-License-Identifier: GPL-3.0-or-later
// The audit of every structure that maintains the convex hull of points in the plane.
#ifndef KINEX_STRUCTURES_HULL_HULL_AUDIT_H
#define KINEX_STRUCTURES_HULL_HULL_AUDIT_H

#include <cstddef>

#include "core/engine/audit.h"
#include "core/engine/structure.h"

namespace kinex {

// Compares a hull cycle with CGAL's convex_hull_2 on exact positions. At the time of the snapshot
// three vertices may be on one line, or two equal, without an event (they touch and turn back):
// there the cycle may hold more points than the witness, on its edges.
void audit_hull(const Attribute& attribute, std::size_t objects, const Snapshot& snapshot,
                AuditReport& report);

}  // namespace kinex

#endif
