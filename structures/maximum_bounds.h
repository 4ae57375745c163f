// SPDX-License-Identifier: GPL-3.0-or-later
// Hard bounds that hold for every structure that maintains a maximum with one certificate per pair
// of opponents.
#ifndef KINEX_STRUCTURES_MAXIMUM_BOUNDS_H
#define KINEX_STRUCTURES_MAXIMUM_BOUNDS_H

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/bound.h"
#include "structures/key_order.h"

namespace kinex {

// Certificates: n - 1, or `certificates` if that is given. External events, without flight-plan
// changes: lambda_D(n) - 1, plus one for each tie that was put in order at a degenerate instant.
// With them a piece of a motion is a function on an interval: lambda_{D+2}(pieces) - 1, or one
// event per crossing, whichever is less.
std::vector<BoundCheck> maximum_bounds(std::string_view name, const KeyOrder& order,
                                       const BoundContext& context,
                                       std::optional<std::uint64_t> certificates = {});

// NAME.events: no pair of objects causes more events than its keys have roots, and pieces of motion
// that meet. (At an instant a pair whose keys meet fails once at most.)
BoundCheck crossing_bound(std::string_view name, const KeyOrder& order,
                          const BoundContext& context);

// NAME.internal: every event changes the maximum.
BoundCheck no_internal_events(std::string_view name, const BoundContext& context);

}  // namespace kinex

#endif
