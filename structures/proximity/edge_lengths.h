// SPDX-License-Identifier: GPL-3.0-or-later
// EdgeLengths: edges between points, numbered, in the order of their lengths.
//
// Ties. Of edges whose lengths are identically equal the lexicographically smaller one is in front
// (PairDistances). So the minimum spanning tree is unique.
#ifndef KINEX_STRUCTURES_PROXIMITY_EDGE_LENGTHS_H
#define KINEX_STRUCTURES_PROXIMITY_EDGE_LENGTHS_H

#include <cstddef>
#include <map>
#include <vector>

#include "structures/parts/pair_distances.h"
#include "structures/proximity/tree_edges.h"

namespace kinex {

class EdgeLengths final : public TreeEdges {
 public:
  using Edge = PairDistances::Value;  // ids, ascending

  EdgeLengths(Kernel& kernel, int dimension) : distances_(kernel, dimension) {}

  Query claim(Item a, Item b) const override { return distances_.claim(edges_[a], edges_[b]); }
  bool goes_first(Item a, Item b) const override { return edges_[a] < edges_[b]; }
  std::array<std::uint32_t, 2> ends(Item item) const override { return edges_[item]; }
  EdgeIds ids(Item item) const override { return edges_[item]; }

  // By edge, ascending.
  const std::map<Edge, Item>& items() const { return item_of_; }
  // kNoItem if the edge has no number.
  Item find(const Edge& edge) const {
    const auto place = item_of_.find(edge);
    return place == item_of_.end() ? kNoItem : place->second;
  }
  // Numbers an edge that has no number.
  Item add(const Edge& edge);
  // Its number may be given to another edge.
  void remove(Item item);
  std::size_t bytes() const {
    return edges_.capacity() * sizeof(Edge) + item_of_.size() * (sizeof(Edge) + 48) +
           free_.capacity() * sizeof(Item);
  }

 private:
  PairDistances distances_;
  std::vector<Edge> edges_;  // by item
  std::map<Edge, Item> item_of_;
  std::vector<Item> free_;
};

}  // namespace kinex

#endif
