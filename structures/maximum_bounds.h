// SPDX-License-Identifier: GPL-3.0-or-later
// Hard bounds that hold for every structure that maintains a maximum with one certificate per pair
// of opponents.
#ifndef KINEX_STRUCTURES_MAXIMUM_BOUNDS_H
#define KINEX_STRUCTURES_MAXIMUM_BOUNDS_H

#include <string_view>
#include <vector>

#include "core/bound.h"
#include "structures/key_order.h"

namespace kinex {

// Certificates: n - 1. External events, without flight-plan changes: lambda_D(n) - 1, plus one for
// each tie that was put in order at a degenerate instant.
std::vector<BoundCheck> maximum_bounds(std::string_view name, const KeyOrder& order,
                                       const BoundContext& context);

}  // namespace kinex

#endif
