// SPDX-License-Identifier: GPL-3.0-or-later
// EdgeGroup: a set of edges that come and go, and the shortest of them, by a tournament of extrema.
//
// The tree is complete and lies in an array, as that of KineticTournament; its nodes are those of an
// EdgeExtrema, so that many small groups share the certificates of one part. g - 1 nodes for g edges;
// one that comes or goes changes the operands of three nodes at most.
#ifndef KINEX_STRUCTURES_PROXIMITY_EDGE_GROUP_H
#define KINEX_STRUCTURES_PROXIMITY_EDGE_GROUP_H

#include <cstddef>
#include <vector>

#include "structures/proximity/edge_extrema.h"

namespace kinex {

class EdgeGroup {
 public:
  using Value = EdgeExtrema::Value;

  std::size_t size() const { return values_.size() / 2; }
  // The shortest one; requires that there is one.
  const Value& shortest() const { return values_[1]; }
  // In the order of their leaves.
  std::vector<Item> edges() const;
  // No bound may read the shortest one while it changes: read it anew.
  void put_in(EdgeExtrema& extrema, Item edge);
  void take_out(EdgeExtrema& extrema, Item edge);
  void clear(EdgeExtrema& extrema);
  std::size_t bytes() const { return values_.capacity() * sizeof(Value); }

 private:
  // Its parent has another operand from now on.
  void put(EdgeExtrema& extrema, std::size_t v, const Value& value);

  // From 1: of g edges g - 1 nodes, then the edges. The operands of node v are 2v and 2v + 1.
  std::vector<Value> values_;
};

}  // namespace kinex

#endif
