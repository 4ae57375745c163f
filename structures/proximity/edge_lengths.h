// SPDX-License-Identifier: GPL-3.0-or-later
// EdgeLengths: edges between points, numbered, in the order of their lengths.
//
// Ties. Of edges whose lengths are identically equal the lexicographically smaller one is in front
// (PairDistances). So the minimum spanning tree is unique.
//
// An edge that has been removed may be kept: it is listed, and has its number, as long as it is used.
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
  // Numbers an edge that has no number; one that is kept gets its old one.
  Item add(const Edge& edge);
  // The edge has no number any more. `uses(item)`: it is kept as long as that is true, so that its
  // number is given to no other edge. Amortised O(1) calls of it.
  template <class Uses>
  void remove(Item item, const Uses& uses) {
    is_kept_[item] = true;
    if (is_listed_[item]) return;
    is_listed_[item] = true;
    kept_.push_back(item);
    if (kept_.size() < most_kept_) return;
    std::size_t left = 0;
    for (const Item one : kept_) {
      if (is_kept_[one] && uses(one)) {
        kept_[left++] = one;
        continue;
      }
      is_listed_[one] = false;
      if (is_kept_[one]) forget(one);
    }
    kept_.resize(left);
    most_kept_ = 2 * left + kFewKept;
  }
  std::size_t bytes() const;

 private:
  static constexpr std::size_t kFewKept = 64;

  Item known(const Edge& edge) const;
  void forget(Item item);

  PairDistances distances_;
  std::vector<Edge> edges_;               // by item
  std::vector<std::vector<EdgeAt>> at_;  // by point
  std::vector<Item> free_;
  // Edges that are kept, and some that have come back.
  std::vector<Item> kept_;
  std::vector<bool> is_kept_, is_listed_;  // by item
  std::size_t most_kept_ = kFewKept;
};

}  // namespace kinex

#endif
