// SPDX-License-Identifier: GPL-3.0-or-later
// GraphWeights: the objects of a scene of one axis as the edges of a graph (SceneObject::ends), in
// the order of their coordinates, which are their weights. The number of an edge is its object.
//
// Ties. Of edges whose weights are identically equal the smaller object is in front.
#ifndef KINEX_STRUCTURES_PROXIMITY_GRAPH_WEIGHTS_H
#define KINEX_STRUCTURES_PROXIMITY_GRAPH_WEIGHTS_H

#include <cstddef>
#include <vector>

#include "core/engine/kernel.h"
#include "core/motion/scene.h"
#include "structures/proximity/tree_edges.h"

namespace kinex {

class GraphWeights final : public TreeEdges {
 public:
  // Requires a scene all of whose objects have ends. Vertices are numbered as they first occur.
  GraphWeights(Kernel& kernel, const Scene& scene);

  Query claim(Item a, Item b) const override { return Query(order_, {a, b}); }
  bool goes_first(Item a, Item b) const override { return a < b; }
  std::array<std::uint32_t, 2> ends(Item item) const override { return ends_[item]; }
  EdgeIds ids(Item item) const override { return {item, kNoObject}; }

  std::size_t vertices() const { return vertices_; }
  std::size_t bytes() const { return ends_.capacity() * sizeof(ends_[0]); }

 private:
  PredicateId order_;
  std::vector<std::array<std::uint32_t, 2>> ends_;  // by object
  std::size_t vertices_ = 0;
};

}  // namespace kinex

#endif
