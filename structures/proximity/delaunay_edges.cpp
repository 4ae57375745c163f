// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/delaunay_edges.h"

#include <algorithm>

namespace kinex {

std::vector<DelaunayEdge> delaunay_edges(const Delaunay2& triangulation) {
  const std::vector<ObjectId> ids = triangulation.attribute().ids;
  std::vector<DelaunayEdge> result;
  for (std::size_t i = 0; i + 1 < ids.size(); i += 2) result.push_back({ids[i], ids[i + 1]});
  for (ObjectId object = 0; object < triangulation.objects(); ++object) {
    const ObjectId vertex = triangulation.representative(object);
    if (vertex != object && vertex != kNoObject) result.push_back({vertex, object});
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

std::optional<DelaunayEdgeChange> delaunay_edge_change(const Event& event) {
  const auto& ids = event.ids;
  switch (event.kind) {
    case Delaunay2::kFlip:
      return DelaunayEdgeChange{DelaunayEdge{ids[0], ids[1]}, DelaunayEdge{ids[2], ids[3]}};
    case Delaunay2::kEnter:
      return DelaunayEdgeChange{DelaunayEdge{ids[1], ids[2]}, {}};
    case Delaunay2::kLeave:
      return DelaunayEdgeChange{{}, DelaunayEdge{ids[1], ids[2]}};
    default:
      return std::nullopt;
  }
}

}  // namespace kinex
