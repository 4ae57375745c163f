// SPDX-License-Identifier: GPL-3.0-or-later
// What readers of a Delaunay triangulation, in the plane or in space, see of it as a graph: every
// pair of points that some proximity structure may need. Those are the edges, and the pairs of a
// vertex and a point that is hidden behind it, being identically equal.
#ifndef KINEX_STRUCTURES_PROXIMITY_DELAUNAY_EDGES_H
#define KINEX_STRUCTURES_PROXIMITY_DELAUNAY_EDGES_H

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "structures/triangulation/delaunay_2.h"
#include "structures/triangulation/delaunay_3.h"

namespace kinex {

using DelaunayEdge = std::array<ObjectId, 2>;  // ids, ascending

// Edges that a change of the triangulation removes and adds.
using DelaunayEdgeChange = EdgeChange;

// A Delaunay triangulation, in the plane or in space, as a graph.
class DelaunayGraph {
 public:
  // The triangulation outlives its readers.
  DelaunayGraph(const Delaunay2& in_plane) : in_plane_(&in_plane) {}
  DelaunayGraph(const Delaunay3& in_space) : in_space_(&in_space) {}
  // A delaunay_2 or a delaunay_3; std::bad_cast for any other structure.
  static DelaunayGraph of(const Structure& triangulation);

  int dimension() const { return in_plane_ != nullptr ? 2 : 3; }
  StructureId id() const { return in_plane_ != nullptr ? in_plane_->id() : in_space_->id(); }
  // The number of the scene's objects, alive or not.
  std::size_t objects() const {
    return in_plane_ != nullptr ? in_plane_->objects() : in_space_->objects();
  }
  // The vertex for `object`: itself, or the one it is hidden behind; kNoObject: not present.
  ObjectId representative(ObjectId object) const {
    return in_plane_ != nullptr ? in_plane_->representative(object)
                                : in_space_->representative(object);
  }
  // The vertices that an edge joins to a vertex, ascending. O(k log k) for k of them.
  std::vector<ObjectId> neighbours(ObjectId vertex) const {
    return in_plane_ != nullptr ? in_plane_->neighbours(vertex) : in_space_->neighbours(vertex);
  }
  // All of them, ascending. O(n log n) for n edges.
  std::vector<DelaunayEdge> edges() const;
  // The change that an external event of the triangulation states; nullopt if it has to be read off
  // the triangulation.
  std::optional<DelaunayEdgeChange> change(const Event& event) const;
  // As change(), of what watched_changed() gets: no event means that edges have changed and no cells have.
  // Asked for there alone.
  std::optional<DelaunayEdgeChange> told(const Event* event) const {
    if (event != nullptr) return change(*event);
    return in_space_ != nullptr ? in_space_->change_within() : std::nullopt;
  }
  // Which edges may have come or gone, but for those of hidden points; nullptr: all may have.
  const EdgeJournal* journal() const {
    return in_plane_ != nullptr ? in_plane_->journal() : in_space_->journal();
  }
  // Different numbers: pairs with hidden points may have come or gone.
  std::uint64_t hidden_changes() const {
    return in_plane_ != nullptr ? in_plane_->hidden_changes() : in_space_->hidden_changes();
  }
  // Requires a journal. O(degree of the first end).
  bool has(const DelaunayEdge& edge) const;
  // One is hidden behind the other.
  bool is_hidden_pair(const DelaunayEdge& edge) const {
    return representative(edge[0]) == edge[1] || representative(edge[1]) == edge[0];
  }
  // The largest number of edges that n points can have: 3n - 6 in the plane, all pairs in space.
  std::size_t most_edges(std::size_t n) const;

 private:
  const Delaunay2* in_plane_ = nullptr;
  const Delaunay3* in_space_ = nullptr;
};

}  // namespace kinex

#endif
