// SPDX-License-Identifier: GPL-3.0-or-later
// What structures for spanning trees share: Kruskal's algorithm, a bound, and the static tree for
// audits.
#ifndef KINEX_STRUCTURES_PROXIMITY_SPANNING_TREE_H
#define KINEX_STRUCTURES_PROXIMITY_SPANNING_TREE_H

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/engine/audit.h"
#include "core/engine/bound.h"
#include "structures/proximity/edge_lengths.h"

namespace kinex {

// Kruskal's algorithm: of edges in ascending order of length, true for those of the minimum spanning
// forest. Ids are below `vertices`. Almost linear.
std::vector<bool> kruskal(std::span<const EdgeLengths::Edge> edges, std::size_t vertices);

// "`structure`.external": a change of the tree exchanges two of the C(n, 2) pairs of points in the
// order of their distances, which happens at most 2d times for motions of degree d: at most
// 2d C(C(n, 2), 2) changes. For plain runs of two or more points.
BoundCheck spanning_tree_bound(const std::string& structure, const BoundContext& context);

// The edges of the Euclidean minimum spanning tree of all living objects in any dimension,
// ascending, from the exact squared distances of all pairs. Of equal ones the lexicographically
// smaller pair comes first. O(n^2 log n) operations on rationals.
std::vector<ObjectId> static_spanning_tree(const Snapshot& snapshot);

}  // namespace kinex

#endif
