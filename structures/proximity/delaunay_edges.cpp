// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/delaunay_edges.h"

#include <algorithm>

namespace kinex {
namespace {

std::optional<DelaunayEdgeChange> change_in_plane(const Event& event) {
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

// A point that reaches the hull, or leaves it, keeps its edges.
std::optional<DelaunayEdgeChange> change_in_space(const Event& event) {
  const DelaunayEdge edge{event.ids[0], event.ids[1]};
  switch (event.kind) {
    case Delaunay3::kFlip23:
    case Delaunay3::kHull23:
      return DelaunayEdgeChange{{}, edge};
    case Delaunay3::kFlip32:
    case Delaunay3::kHull32:
      return DelaunayEdgeChange{edge, {}};
    case Delaunay3::kEnter:
    case Delaunay3::kLeave:
      return DelaunayEdgeChange{};
    default:
      return std::nullopt;
  }
}

}  // namespace

DelaunayGraph DelaunayGraph::of(const Structure& triangulation) {
  if (const auto* in_space = dynamic_cast<const Delaunay3*>(&triangulation)) return *in_space;
  return dynamic_cast<const Delaunay2&>(triangulation);
}

std::vector<DelaunayEdge> DelaunayGraph::edges() const {
  std::vector<DelaunayEdge> result;
  if (in_space_ != nullptr) {
    result = in_space_->edges();
  } else {
    const std::vector<ObjectId> ids = in_plane_->attribute().ids;
    for (std::size_t i = 0; i + 1 < ids.size(); i += 2) result.push_back({ids[i], ids[i + 1]});
  }
  for (ObjectId object = 0; object < objects(); ++object) {
    const ObjectId vertex = representative(object);
    if (vertex != object && vertex != kNoObject) result.push_back({vertex, object});
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

bool DelaunayGraph::has(const DelaunayEdge& edge) const {
  const auto [a, b] = edge;
  if (is_hidden_pair(edge)) return true;
  return in_plane_ != nullptr ? in_plane_->has_edge(a, b) : in_space_->has_edge(a, b);
}

std::optional<DelaunayEdgeChange> DelaunayGraph::change(const Event& event) const {
  return in_plane_ != nullptr ? change_in_plane(event) : change_in_space(event);
}

std::size_t DelaunayGraph::most_edges(std::size_t n) const {
  if (n < 2) return 0;
  if (in_space_ != nullptr || n < 3) return n * (n - 1) / 2;
  return 3 * n - 6;
}

}  // namespace kinex
