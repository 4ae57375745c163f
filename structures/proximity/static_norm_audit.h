// SPDX-License-Identifier: GPL-3.0-or-later
// Lengths in the norm of a polygon at exact positions, for audits: shares no code with the
// predicates, the orders and the cones.
#ifndef KINEX_STRUCTURES_PROXIMITY_STATIC_NORM_AUDIT_H
#define KINEX_STRUCTURES_PROXIMITY_STATIC_NORM_AUDIT_H

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "core/engine/audit.h"
#include "core/numbers/rational.h"

namespace kinex {

// A linear function: of each two opposite ones of a norm one.
using StaticUnit = std::array<Rational, 2>;
// The first part that differs decides: the length as it is, what an infinitesimal turn adds, and
// what a step by the ids along (2, 1) adds.
using StaticLength = std::array<Rational, 3>;

// The first part of the length of the step between two points.
Rational static_norm(const Snapshot& snapshot, std::span<const StaticUnit> units, ObjectId a,
                     ObjectId b);
// The whole length. Requires a < b.
StaticLength static_norm_length(const Snapshot& snapshot, std::span<const StaticUnit> units,
                                ObjectId a, ObjectId b);

// The ids, ascending, of the pair of living points that is shortest in the maximum norm, among equal
// lengths the lexicographically smallest one; of the pairs that `counts` accepts alone. Empty if
// there is none. O(n^2).
std::vector<ObjectId> static_nearest_maximum_norm(
    const Snapshot& snapshot, const std::function<bool(ObjectId, ObjectId)>& counts);

}  // namespace kinex

#endif
