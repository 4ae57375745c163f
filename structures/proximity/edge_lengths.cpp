// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/edge_lengths.h"

#include <algorithm>

namespace kinex {
namespace {

auto place_of(auto& list, std::uint32_t vertex) {
  return std::lower_bound(list.begin(), list.end(), vertex,
                          [](const EdgeAt& one, std::uint32_t v) { return one.vertex < v; });
}

}  // namespace

std::vector<std::pair<EdgeLengths::Edge, Item>> EdgeLengths::items() const {
  std::vector<std::pair<Edge, Item>> result;
  for (const std::vector<EdgeAt>& list : at_) {
    for (const EdgeAt& one : list) {
      const Edge& edge = edges_[one.edge];
      if (edge[1] == one.vertex && !is_kept_[one.edge]) result.emplace_back(edge, one.edge);
    }
  }
  return result;
}

Item EdgeLengths::find(const Edge& edge) const {
  const Item item = known(edge);
  return item == kNoItem || is_kept_[item] ? kNoItem : item;
}

// The same for edges that are kept, too.
Item EdgeLengths::known(const Edge& edge) const {
  const auto& list = at_[edge[0]];
  const auto place = place_of(list, edge[1]);
  return place == list.end() || place->vertex != edge[1] ? kNoItem : place->edge;
}

Item EdgeLengths::add(const Edge& edge) {
  Item item = known(edge);
  if (item != kNoItem) {
    is_kept_[item] = false;
    return item;
  }
  if (free_.empty()) {
    item = static_cast<Item>(edges_.size());
    edges_.push_back(edge);
    is_kept_.push_back(false);
    is_listed_.push_back(false);
  } else {
    item = free_.back();
    free_.pop_back();
    edges_[item] = edge;
  }
  for (const int i : {0, 1}) {
    auto& list = at_[edge[i]];
    list.insert(place_of(list, edge[1 - i]), {edge[1 - i], item});
  }
  return item;
}

void EdgeLengths::forget(Item item) {
  const Edge& edge = edges_[item];
  for (const int i : {0, 1}) {
    auto& list = at_[edge[i]];
    list.erase(place_of(list, edge[1 - i]));
  }
  is_kept_[item] = false;
  free_.push_back(item);
}

std::size_t EdgeLengths::bytes() const {
  std::size_t sum = edges_.capacity() * sizeof(Edge) +
                    (free_.capacity() + kept_.capacity()) * sizeof(Item) + is_kept_.capacity() / 4 +
                    at_.capacity() * sizeof(std::vector<EdgeAt>);
  for (const std::vector<EdgeAt>& list : at_) sum += list.capacity() * sizeof(EdgeAt);
  return sum;
}

}  // namespace kinex
