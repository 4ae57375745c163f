// SPDX-License-Identifier: GPL-3.0-or-later
// QueryTrace: the nodes of a tree that a query for a box looks at, as sets of points: for viewers,
// which know no tree.
#ifndef KINEX_STRUCTURES_PARTS_QUERY_TRACE_H
#define KINEX_STRUCTURES_PARTS_QUERY_TRACE_H

#include <cstdint>
#include <utility>
#include <vector>

#include "core/motion/scene.h"

namespace kinex {

// Where a node is, by what the tree knows of it.
enum class NodePlace : std::uint8_t { kOutside, kCrossed, kInside };

// A node that a query looks at.
struct NodeLookedAt {
  NodePlace place;
  std::vector<ObjectId> objects;  // below it
};

// In the order in which they are looked at. Nodes below one that is inside are left out.
using QueryTrace = std::vector<NodeLookedAt>;

// What a structure that answers queries (RangeSearch) can show of its work.
class TracedSearch {
 public:
  virtual ~TracedSearch() = default;
  // As RangeSearch::report, with the nodes instead of the costs. O(size) for each node.
  virtual void trace(ObjectId low, ObjectId high, std::vector<ObjectId>& out,
                     QueryTrace& nodes) = 0;
};

}  // namespace kinex

#endif
