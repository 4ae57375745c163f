// SPDX-License-Identifier: GPL-3.0-or-later
// CountedEdges: the Delaunay edges among which a closest pair is sought: all of them
// (closest_pair_delaunay), or those between two classes of points (bichromatic_pair_delaunay).
// README.md says why they suffice.
#ifndef KINEX_STRUCTURES_PROXIMITY_COUNTED_EDGES_H
#define KINEX_STRUCTURES_PROXIMITY_COUNTED_EDGES_H

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/numbers/integer.h"
#include "structures/parts/object_sets.h"
#include "structures/proximity/delaunay_edges.h"

namespace kinex {

class CountedEdges {
 public:
  // `classes`: edges between points of different classes alone; nullopt: all edges.
  CountedEdges(const DelaunayGraph& graph, std::optional<TwoClasses> classes)
      : graph_(graph), classes_(std::move(classes)) {}

  const DelaunayGraph& graph() const { return graph_; }
  bool counts(ObjectId a, ObjectId b) const { return !classes_ || classes_->differ(a, b); }
  // Ascending. O(n log n) for n edges of the triangulation.
  std::vector<DelaunayEdge> all() const;
  // The most edges that count, of n points, and why there are no more.
  struct Most {
    std::size_t edges;
    std::string why;
  };
  Most most(std::size_t n) const;
  // The pairs of n points that would count as edges.
  Integer most_pairs(std::size_t n) const;
  std::size_t bytes() const { return classes_ ? classes_->bytes() : 0; }

 private:
  DelaunayGraph graph_;
  std::optional<TwoClasses> classes_;
};

}  // namespace kinex

#endif
