// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/regular_edges.h"

namespace kinex {
namespace {

// A disc that shows or hides, and cells that are sewn, change several edges.
std::optional<DelaunayEdgeChange> change_in_plane(const Event& event) {
  const auto& ids = event.ids;
  switch (event.kind) {
    case Regular2::kFlip:
      return DelaunayEdgeChange{DelaunayEdge{ids[0], ids[1]}, DelaunayEdge{ids[2], ids[3]}};
    case Regular2::kEnter:
      return DelaunayEdgeChange{DelaunayEdge{ids[1], ids[2]}, {}};
    case Regular2::kLeave:
      return DelaunayEdgeChange{{}, DelaunayEdge{ids[1], ids[2]}};
    default:
      return std::nullopt;
  }
}

std::optional<DelaunayEdgeChange> change_in_space(const Event& event) {
  const DelaunayEdge edge{event.ids[0], event.ids[1]};
  switch (event.kind) {
    case Regular3::kFlip23:
    case Regular3::kHull23:
      return DelaunayEdgeChange{{}, edge};
    case Regular3::kFlip32:
    case Regular3::kHull32:
      return DelaunayEdgeChange{edge, {}};
    case Regular3::kEnter:
    case Regular3::kLeave:
      return DelaunayEdgeChange{};
    default:
      return std::nullopt;
  }
}

}  // namespace

RegularGraph RegularGraph::of(const Structure& triangulation) {
  RegularGraph graph;
  graph.in_space_ = dynamic_cast<const Regular3*>(&triangulation);
  if (graph.in_space_ == nullptr) graph.in_plane_ = &dynamic_cast<const Regular2&>(triangulation);
  return graph;
}

std::optional<DelaunayEdgeChange> RegularGraph::change(const Event& event) const {
  return in_plane_ != nullptr ? change_in_plane(event) : change_in_space(event);
}

}  // namespace kinex
