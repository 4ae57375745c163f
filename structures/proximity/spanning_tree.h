// SPDX-License-Identifier: GPL-3.0-or-later
// Functions shared by the structures for spanning trees: Kruskal's algorithm, a bound, and the static
// tree for audits.
#ifndef KINEX_STRUCTURES_PROXIMITY_SPANNING_TREE_H
#define KINEX_STRUCTURES_PROXIMITY_SPANNING_TREE_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/engine/audit.h"
#include "core/engine/bound.h"
#include "core/motion/scene.h"

namespace kinex {

// Kruskal's algorithm: of edges in ascending order of length, true for those of the minimum spanning
// forest. Ends are below `vertices`. Almost linear.
std::vector<bool> kruskal(std::span<const std::array<std::uint32_t, 2>> edges,
                          std::size_t vertices);

// "`structure`.external": a change of the tree exchanges two edges in the order of their lengths,
// which happens at most kd times for lengths of degree k in motions of degree d: at most
// kd C(edges, 2) changes. For plain runs.
BoundCheck spanning_tree_bound(const std::string& structure, const Integer& edges, int k,
                               const BoundContext& context);

// The edges of the Euclidean minimum spanning tree of all living objects in any dimension,
// ascending, from the exact squared distances of all pairs. Of equal ones the lexicographically
// smaller pair comes first. O(n^2 log n) operations on rationals.
std::vector<ObjectId> static_spanning_tree(const Snapshot& snapshot);

}  // namespace kinex

#endif
