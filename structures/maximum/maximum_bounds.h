// SPDX-License-Identifier: GPL-3.0-or-later
// Hard bounds that hold for every structure that maintains a maximum with one certificate per pair
// of opponents.
#ifndef KINEX_STRUCTURES_MAXIMUM_MAXIMUM_BOUNDS_H
#define KINEX_STRUCTURES_MAXIMUM_MAXIMUM_BOUNDS_H

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/engine/bound.h"
#include "structures/parts/key_order.h"

namespace kinex {

// Certificates: n - 1, or `certificates` if that is given. External events, without flight-plan
// changes: lambda_D(n) - 1, plus one for each tie ordered at a degenerate instant. With flight-plan
// changes each piece of a motion is a function on an interval: lambda_{D+2}(pieces) - 1, or one
// event per crossing, whichever is less.
std::vector<BoundCheck> maximum_bounds(std::string_view name, const KeyOrder& order,
                                       const BoundContext& context,
                                       std::optional<std::uint64_t> certificates = {});

// NAME.events: a pair of objects causes at most as many events as its keys have roots, plus the
// pieces of motion that meet. (At one instant a pair whose keys meet fails at most once.)
BoundCheck crossing_bound(std::string_view name, const KeyOrder& order,
                          const BoundContext& context);

// NAME.internal: every event changes the maximum.
BoundCheck no_internal_events(std::string_view name, const BoundContext& context);

}  // namespace kinex

#endif
