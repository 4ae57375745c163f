// SPDX-License-Identifier: GPL-3.0-or-later
// TreeEdges: the edges of a changing graph, as the engines of spanning trees see them: numbered,
// between two vertices, and in the order of their lengths.
#ifndef KINEX_STRUCTURES_PROXIMITY_TREE_EDGES_H
#define KINEX_STRUCTURES_PROXIMITY_TREE_EDGES_H

#include <array>
#include <cstdint>
#include <span>

#include "structures/parts/claim.h"

namespace kinex {

// The objects by which events and attributes name an edge: its two points, ascending, or the one
// object that it is. Then the second is kNoObject.
using EdgeIds = std::array<ObjectId, 2>;

class TreeEdges {
 public:
  virtual ~TreeEdges() = default;

  // "Edge a is at most as long as edge b", for a != b.
  virtual Query claim(Item a, Item b) const = 0;
  // Of edges whose lengths are identically equal this one counts as the shorter: a strict total
  // order, so that the minimum spanning tree is unique.
  virtual bool goes_first(Item a, Item b) const = 0;
  // Its vertices, numbers from 0.
  virtual std::array<std::uint32_t, 2> ends(Item edge) const = 0;
  virtual EdgeIds ids(Item edge) const = 0;
};

// An edge, as one of its vertices sees it.
struct EdgeAt {
  std::uint32_t vertex;  // its other end
  Item edge;
};

// Edges between points, which are the vertices, by Euclidean length; known by vertex, at most one
// between two vertices.
class AdjacentEdges : public TreeEdges {
 public:
  // The edges at a vertex, ascending by their other ends, and those that have left the graph and are
  // still used (TreeEngine::uses). Valid until an edge comes or goes.
  virtual std::span<const EdgeAt> at(std::uint32_t vertex) const = 0;
};

// The claims of a part about edges (structures/parts/claim.h): the shorter edge is in front. Their
// order is that of Kruskal's algorithm.
class EdgeOrder {
 public:
  // `edges` outlives it.
  explicit EdgeOrder(const TreeEdges& edges) : edges_(&edges) {}
  Query claim(Item a, Item b) const { return edges_->claim(a, b); }
  bool goes_first(Item a, Item b) const { return edges_->goes_first(a, b); }

 private:
  const TreeEdges* edges_;
};

}  // namespace kinex

#endif
