// SPDX-License-Identifier: GPL-3.0-or-later
// The points above lines at exact positions: for audits.
#ifndef KINEX_STRUCTURES_ARRANGEMENT_STATIC_SIDES_AUDIT_H
#define KINEX_STRUCTURES_ARRANGEMENT_STATIC_SIDES_AUDIT_H

#include <vector>

#include "core/engine/audit.h"

namespace kinex {

// All pairs of a living line and a living point strictly above it, each in the order of the two
// ids, flattened, ascending.
std::vector<ObjectId> static_points_above(const Snapshot& snapshot,
                                          const std::vector<bool>& is_line);

}  // namespace kinex

#endif
