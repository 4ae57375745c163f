// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/edge_group.h"

#include <algorithm>

namespace kinex {

std::vector<Item> EdgeGroup::edges() const {
  std::vector<Item> result;
  for (std::size_t v = size(); v < values_.size(); ++v) result.push_back(values_[v].edge);
  return result;
}

void EdgeGroup::put(EdgeExtrema& extrema, std::size_t v, const Value& value) {
  values_[v] = value;
  if (v > 1) extrema.set_operand(values_[v / 2].node, v % 2, value);
}

// The first leaf becomes an inner node above its edge and the new one.
void EdgeGroup::put_in(EdgeExtrema& extrema, Item edge) {
  const std::size_t g = size();
  const Value fresh = Value::of_edge(edge);
  if (g == 0) {
    values_ = {Value{}, fresh};
    return;
  }
  const Value old = values_[g];
  values_.push_back(old);
  values_.push_back(fresh);
  put(extrema, g, Value::of_node(extrema.make(EdgeExtrema::Kind::kShortest, old, fresh)));
}

// The last two leaves leave: one moves up into their parent, the other to the place of the edge.
void EdgeGroup::take_out(EdgeExtrema& extrema, Item edge) {
  const Value gone = Value::of_edge(edge);
  const std::size_t g = size();
  if (g == 1) {
    values_.clear();
    return;
  }
  const std::size_t parent = g - 1;
  const auto hole = static_cast<std::size_t>(
      std::find(values_.begin() + static_cast<std::ptrdiff_t>(g), values_.end(), gone) -
      values_.begin());
  const Value a = values_[2 * parent], b = values_[2 * parent + 1], last = values_[parent];
  const bool among = hole >= 2 * parent;
  put(extrema, parent, hole == 2 * parent ? b : a);
  if (!among) put(extrema, hole, b);
  extrema.drop(last.node);
  values_.resize(2 * parent);
}

void EdgeGroup::clear(EdgeExtrema& extrema) {
  for (std::size_t v = 1; v < size(); ++v) extrema.drop(values_[v].node);
  values_.clear();
}

}  // namespace kinex
