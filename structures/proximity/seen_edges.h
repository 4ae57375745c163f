// SPDX-License-Identifier: GPL-3.0-or-later
// SeenEdges: up to where a structure has followed the edges of a triangulation, so that it looks at
// those alone that have been touched since then (edge_journal.h).
//
// Cost, for k touched edges: O(k log k), and their degrees in the triangulation.
#ifndef KINEX_STRUCTURES_PROXIMITY_SEEN_EDGES_H
#define KINEX_STRUCTURES_PROXIMITY_SEEN_EDGES_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "structures/proximity/delaunay_edges.h"

namespace kinex {

template <class Graph>
class SeenEdges {
 public:
  // Nothing is seen. The graph outlives this.
  explicit SeenEdges(const Graph& graph) : graph_(&graph) {}

  // The edges that may have come or gone since the last look, ascending; nullopt: all of the graph, and
  // all that the reader has. The reader looks at them now.
  std::optional<std::vector<DelaunayEdge>> look() {
    const EdgeJournal* const journal = graph_->journal();
    std::optional<std::vector<DelaunayEdge>> touched;
    if (journal != nullptr && hidden_changes_ == graph_->hidden_changes()) {
      touched = journal->since(seen_);
    }
    seen_ = journal == nullptr ? 0 : journal->position();
    hidden_changes_ = graph_->hidden_changes();
    return touched;
  }
  // The reader has followed a change that it was told of. If there is no other one, it has seen all.
  void followed(const DelaunayEdgeChange& change) {
    const EdgeJournal* const journal = graph_->journal();
    if (journal == nullptr) return;
    std::array<DelaunayEdge, 2> edges{};
    std::size_t count = 0;
    for (const auto* const edge : {&change.gone, &change.came}) {
      if (*edge) edges[count++] = **edge;
    }
    if (journal->are_all_since(seen_, std::span(edges).first(count))) seen_ = journal->position();
  }
  // The next look is at all edges.
  void forget() { seen_ = 0; }

 private:
  const Graph* graph_;
  EdgeJournal::Position seen_ = 0;
  std::uint64_t hidden_changes_ = 0;
};

}  // namespace kinex

#endif
