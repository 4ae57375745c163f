// SPDX-License-Identifier: GPL-3.0-or-later
// RegularGraph: a regular triangulation of discs, in the plane or in space, as a graph, for structures
// that work on its edges.
//
// Balls that are all in one plane have no cells, but the edges of the triangulation there. Of discs that are all
// on one line, or too few, all pairs are edges. Hidden discs have none.
#ifndef KINEX_STRUCTURES_PROXIMITY_REGULAR_EDGES_H
#define KINEX_STRUCTURES_PROXIMITY_REGULAR_EDGES_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "structures/proximity/delaunay_edges.h"
#include "structures/triangulation/regular_2.h"
#include "structures/triangulation/regular_3.h"

namespace kinex {

class RegularGraph {
 public:
  // A regular_2 or a regular_3, which outlives it; std::bad_cast for any other structure.
  static RegularGraph of(const Structure& triangulation);

  int dimension() const { return in_plane_ != nullptr ? 2 : 3; }
  StructureId id() const { return in_plane_ != nullptr ? in_plane_->id() : in_space_->id(); }
  // All pairs are edges.
  bool has_all_pairs() const {
    return in_plane_ != nullptr ? in_plane_->flat() : in_space_->has_all_pairs();
  }
  // The edges are those of a triangulation of a plane: at most 3n - 6.
  bool is_of_plane() const {
    return !has_all_pairs() && (in_plane_ != nullptr || in_space_->planar());
  }
  // Discs are hidden, and not all pairs are edges. O(n).
  bool hides() const {
    if (has_all_pairs()) return false;
    return in_plane_ != nullptr ? !in_plane_->hidden().empty() : !in_space_->hidden().empty();
  }
  // All of them, ascending. O(n log n) for n edges.
  std::vector<DelaunayEdge> edges() const {
    return in_plane_ != nullptr ? in_plane_->edges() : in_space_->edges();
  }
  // Which edges may have come or gone; nullptr: all may have, for there are no cells.
  const EdgeJournal* journal() const {
    if (in_plane_ != nullptr) {
      return in_plane_->flat() ? nullptr : &in_plane_->triangulation().journal();
    }
    return in_space_->flat() ? nullptr : &in_space_->triangulation().journal();
  }
  // Hidden discs have no edges.
  std::uint64_t hidden_changes() const { return 0; }
  bool is_hidden_pair(const DelaunayEdge&) const { return false; }
  // Requires a journal. O(degree of the first end).
  bool has(const DelaunayEdge& edge) const;
  // The other ends of the edges at a disc, ascending. Requires a journal. O(k log k) for k of them.
  std::vector<ObjectId> neighbours(ObjectId disc) const;
  // The change that an external event of the triangulation states; nullopt if it has to be read off
  // the triangulation.
  std::optional<DelaunayEdgeChange> change(const Event& event) const;
  // As change(), of what watched_changed() gets: no event means that edges have changed and no cells have.
  // Asked for there alone.
  std::optional<DelaunayEdgeChange> told(const Event* event) const {
    if (event != nullptr) return change(*event);
    return in_space_ != nullptr ? in_space_->change_within() : std::nullopt;
  }

 private:
  const Regular2* in_plane_ = nullptr;
  const Regular3* in_space_ = nullptr;
};

}  // namespace kinex

#endif
