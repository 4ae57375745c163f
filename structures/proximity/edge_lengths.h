// SPDX-License-Identifier: GPL-3.0-or-later
// EdgeLengths: edges between points, numbered, in the order of their lengths.
//
// Ties. Of edges whose lengths are identically equal the lexicographically smaller one is in front
// (PairDistances). So the minimum spanning tree is unique.
//
// Every point lists its edges by their other ends, so an edge is found, added or removed in time
// O(degree of its ends), which is 6 on average in a Delaunay triangulation of the plane.
#ifndef KINEX_STRUCTURES_PROXIMITY_EDGE_LENGTHS_H
#define KINEX_STRUCTURES_PROXIMITY_EDGE_LENGTHS_H

#include <cstddef>
#include <utility>
#include <vector>

#include "structures/parts/pair_distances.h"
#include "structures/proximity/tree_edges.h"

namespace kinex {

class EdgeLengths final : public AdjacentEdges {
 public:
  using Edge = PairDistances::Value;  // ids, ascending

  // `objects`: ids of points are below.
  EdgeLengths(Kernel& kernel, int dimension, std::size_t objects)
      : distances_(kernel, dimension), at_(objects) {}

  Query claim(Item a, Item b) const override { return distances_.claim(edges_[a], edges_[b]); }
  bool goes_first(Item a, Item b) const override { return edges_[a] < edges_[b]; }
  std::array<std::uint32_t, 2> ends(Item item) const override { return edges_[item]; }
  EdgeIds ids(Item item) const override { return edges_[item]; }
  std::span<const EdgeAt> at(std::uint32_t vertex) const override { return at_[vertex]; }

  // By edge, ascending. O(n) for n edges.
  std::vector<std::pair<Edge, Item>> items() const;
  // kNoItem if the edge has no number.
  Item find(const Edge& edge) const;
  // Numbers an edge that has no number.
  Item add(const Edge& edge);
  // Its number may be given to another edge.
  void remove(Item item);
  std::size_t bytes() const;

 private:
  PairDistances distances_;
  std::vector<Edge> edges_;               // by item
  std::vector<std::vector<EdgeAt>> at_;  // by point
  std::vector<Item> free_;
};

}  // namespace kinex

#endif
