// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/counted_edges.h"

#include "core/engine/bound.h"

namespace kinex {

std::vector<DelaunayEdge> CountedEdges::all() const {
  std::vector<DelaunayEdge> edges = graph_.edges();
  std::erase_if(edges, [this](const DelaunayEdge& edge) { return !counts(edge[0], edge[1]); });
  return edges;
}

CountedEdges::Most CountedEdges::most(std::size_t n) const {
  if (!classes_) {
    return {graph_.most_edges(n), "a tournament of the edges: at most 3n - 6, in space all pairs"};
  }
  const std::size_t product = classes_->size(0) * classes_->size(1);
  const std::size_t in_plane = n < 3 ? graph_.most_edges(n) : 2 * n - 4;  // bipartite and planar
  return {graph_.dimension() == 3 ? product : in_plane,
          "a tournament of the edges between two classes: at most 2n - 4, in space all pairs of "
          "them"};
}

Integer CountedEdges::most_pairs(std::size_t n) const {
  if (!classes_) return pairs(counted(n));
  return counted(classes_->size(0)) * counted(classes_->size(1));
}

}  // namespace kinex
