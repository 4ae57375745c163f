// SPDX-License-Identifier: GPL-3.0-or-later
// What readers of a Delaunay triangulation see of it as a graph: every pair of points that some
// proximity structure may need. Those are the edges, and the pairs of a vertex and a point that is
// hidden behind it, being identically equal.
#ifndef KINEX_STRUCTURES_PROXIMITY_DELAUNAY_EDGES_H
#define KINEX_STRUCTURES_PROXIMITY_DELAUNAY_EDGES_H

#include <array>
#include <optional>
#include <vector>

#include "structures/triangulation/delaunay_2.h"

namespace kinex {

using DelaunayEdge = std::array<ObjectId, 2>;  // ids, ascending

// All of them, ascending. O(n).
std::vector<DelaunayEdge> delaunay_edges(const Delaunay2& triangulation);

// A change of one or two edges.
struct DelaunayEdgeChange {
  std::optional<DelaunayEdge> gone, came;
};
// The change that an external event of the triangulation states; nullopt if it has to be read off
// the triangulation.
std::optional<DelaunayEdgeChange> delaunay_edge_change(const Event& event);

}  // namespace kinex

#endif
