// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/regular_edges.h"

#include "structures/parts/sort_unique.h"

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

bool RegularGraph::has(const DelaunayEdge& edge) const {
  const auto [a, b] = edge;
  if (in_plane_ == nullptr) return in_space_->triangulation().adjacent(a, b);
  return in_plane_->triangulation().between(a, b) != Triangulation2::kNone;
}

std::vector<ObjectId> RegularGraph::neighbours(ObjectId disc) const {
  std::vector<ObjectId> result;
  if (in_plane_ != nullptr) {
    const Triangulation2& store = in_plane_->triangulation();
    if (!store.has(disc)) return result;
    Triangulation2::HalfEdge h = store.out(disc);
    do {
      if (store.target(h) != store.infinity()) result.push_back(store.target(h));
      h = store.around(h);
    } while (h != store.out(disc));
  } else {
    const Triangulation3& store = in_space_->triangulation();
    std::vector<Triangulation3::Cell> cells;
    store.star(disc, cells);
    for (const Triangulation3::Cell c : cells) {
      for (const ObjectId other : store.quad(c)) {
        if (other != disc && other != store.infinity()) result.push_back(other);
      }
    }
  }
  sort_unique(result);
  return result;
}

std::optional<DelaunayEdgeChange> RegularGraph::change(const Event& event) const {
  return in_plane_ != nullptr ? change_in_plane(event) : change_in_space(event);
}

}  // namespace kinex
