// SPDX-License-Identifier: GPL-3.0-or-later
// The minimum spanning forest of a graph, for audits: by boost::graph, not by what the structures use.
#ifndef KINEX_STRUCTURES_PROXIMITY_STATIC_FOREST_AUDIT_H
#define KINEX_STRUCTURES_PROXIMITY_STATIC_FOREST_AUDIT_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace kinex {

// The places, ascending, of the edges that boost::kruskal_minimum_spanning_tree chooses. `edges` are in
// ascending order of length: a place is the weight of its edge. Ends are below `vertices`. O(m log m).
std::vector<std::size_t> static_forest(std::span<const std::array<std::uint32_t, 2>> edges,
                                       std::size_t vertices);

}  // namespace kinex

#endif
