// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds that all structures for the convex hull in the plane share.
#ifndef KINEX_STRUCTURES_HULL_HULL_BOUNDS_H
#define KINEX_STRUCTURES_HULL_HULL_BOUNDS_H

#include <string_view>
#include <vector>

#include "core/engine/bound.h"
#include "core/engine/structure.h"

namespace kinex {

// The bound on hull changes; `tied`: some points were identically collinear or equal.
std::vector<BoundCheck> hull_bounds(std::string_view name, const BoundContext& context, bool tied);

// 2d C(n,3).
Integer turns_of_triples(const BoundContext& context);
// The number of events of these kinds.
std::uint64_t events_of(const StructureLedger& ledger, std::initializer_list<const char*> kinds);

}  // namespace kinex

#endif
