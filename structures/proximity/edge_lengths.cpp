// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/edge_lengths.h"

namespace kinex {

Item EdgeLengths::add(const Edge& edge) {
  Item item;
  if (free_.empty()) {
    item = static_cast<Item>(edges_.size());
    edges_.push_back(edge);
  } else {
    item = free_.back();
    free_.pop_back();
    edges_[item] = edge;
  }
  item_of_.emplace(edge, item);
  return item;
}

void EdgeLengths::remove(Item item) {
  item_of_.erase(edges_[item]);
  free_.push_back(item);
}

}  // namespace kinex
