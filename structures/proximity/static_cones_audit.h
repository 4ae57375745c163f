// SPDX-License-Identifier: GPL-3.0-or-later
// The first point in each cone of each point at exact positions, for audits: by definition, from
// coordinates alone.
#ifndef KINEX_STRUCTURES_PROXIMITY_STATIC_CONES_AUDIT_H
#define KINEX_STRUCTURES_PROXIMITY_STATIC_CONES_AUDIT_H

#include <array>
#include <vector>

#include "core/engine/audit.h"
#include "core/numbers/rational.h"

namespace kinex {

// By object and cone (ConeFrame, with so many corners); kNoObject: none, or the object is not alive.
// O(n^2).
std::vector<std::vector<ObjectId>> static_cones(const Snapshot& snapshot, int corners);
// The linear functions whose largest absolute value is the norm.
std::vector<std::array<Rational, 2>> static_units(int corners);

}  // namespace kinex

#endif
