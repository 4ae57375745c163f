// SPDX-License-Identifier: GPL-3.0-or-later
// SeenEdges: up to where a structure has followed the edges of a triangulation, so that it looks at
// those alone that have been touched since then (edge_journal.h).
//
// Cost, for k touched edges: O(k log k), and the degrees of their ends in the triangulation.
#ifndef KINEX_STRUCTURES_PROXIMITY_SEEN_EDGES_H
#define KINEX_STRUCTURES_PROXIMITY_SEEN_EDGES_H

#include <algorithm>
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
  // Nothing is seen.
  explicit SeenEdges(const Graph& graph) : graph_(graph) {}

  // The edges that may have come or gone since the last look, ascending; nullopt: all of the graph, and
  // all that the reader has. The reader looks at them now.
  std::optional<std::vector<DelaunayEdge>> look() {
    const EdgeJournal* const journal = graph_.journal();
    std::optional<std::vector<DelaunayEdge>> touched;
    if (journal != nullptr && hidden_changes_ == graph_.hidden_changes()) {
      touched = journal->since(seen_);
    }
    seen_ = journal == nullptr ? 0 : journal->position();
    hidden_changes_ = graph_.hidden_changes();
    if (!touched) ++full_looks_;
    return touched;
  }
  // The same: calls all(), or one(edge, it is there) for each.
  template <class All, class One>
  void look(const All& all, const One& one) {
    const auto touched = look();
    if (!touched) return all();
    for (auto from = touched->begin(); from != touched->end();) {
      const ObjectId end = (*from)[0];
      const auto to = std::find_if(from, touched->end(),
                                   [end](const DelaunayEdge& edge) { return edge[0] != end; });
      if (to - from > kFew) {  // about a hub, perhaps: its edges are listed once
        const std::vector<ObjectId> neighbours = graph_.neighbours(end);
        for (; from != to; ++from) {
          one(*from, std::binary_search(neighbours.begin(), neighbours.end(), (*from)[1]) ||
                         graph_.is_hidden_pair(*from));
        }
      } else {
        for (; from != to; ++from) one(*from, graph_.has(*from));
      }
    }
  }
  // The reader has followed a change that it was told of. It need not look at it, if that is the next one.
  void followed(const DelaunayEdgeChange& change) {
    const EdgeJournal* const journal = graph_.journal();
    if (journal == nullptr) return;
    std::array<DelaunayEdge, 2> edges{};
    std::size_t count = 0;
    for (const auto* const edge : {&change.gone, &change.came}) {
      if (*edge) edges[count++] = **edge;
    }
    seen_ = journal->behind(seen_, std::span(edges).first(count));
  }
  // The next look is at all edges.
  void forget() { seen_ = 0; }
  // Of those, how many were at all edges.
  std::uint64_t full_looks() const { return full_looks_; }

 private:
  static constexpr std::ptrdiff_t kFew = 8;

  Graph graph_;
  EdgeJournal::Position seen_ = 0;
  std::uint64_t hidden_changes_ = 0;
  std::uint64_t full_looks_ = 0;
};

}  // namespace kinex

#endif
