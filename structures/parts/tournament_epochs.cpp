// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/parts/tournament_epochs.h"

#include <algorithm>
#include <bit>

#include "core/engine/bound.h"

namespace kinex {
namespace {

// v's descendants k levels below it are v 2^k .. (v + 1) 2^k - 1. Counts those on the lowest level,
// in pairs of siblings, and those one level above without children.
std::size_t leaves_below(std::size_t v, std::size_t leaves) {
  int levels = std::bit_width(2 * leaves - 1) - std::bit_width(v);
  if ((v << levels) >= 2 * leaves) --levels;
  if (levels == 0) return 1;
  const std::size_t width = std::size_t{1} << levels;
  const std::size_t lowest = std::min(width, 2 * leaves - width * v);
  return width / 2 + lowest / 2;
}

}  // namespace

// Upwards from the largest node on, so that paths become one where they meet.
void TournamentEpochs::begin(std::span<const Node> nodes, std::size_t leaves) {
  if (nodes_.size() <= leaves) nodes_.resize(leaves + 1, 0);
  paths_.clear();
  for (Node v : nodes) {
    while (v >= leaves && v > 0) v /= 2;
    if (v > 0) paths_.push_back(v);
  }
  std::make_heap(paths_.begin(), paths_.end());
  while (!paths_.empty()) {
    Node v = paths_.front();
    std::pop_heap(paths_.begin(), paths_.end());
    paths_.pop_back();
    const Node other = paths_.empty() ? 0 : paths_.front();
    while (v > other) {
      ++nodes_[leaves_below(v, leaves)];
      v /= 2;
    }
    if (v == other) continue;
    paths_.push_back(v);
    std::push_heap(paths_.begin(), paths_.end());
  }
}

template <class Most>
Integer TournamentEpochs::most_in_epochs(const Most& most) const {
  Integer sum(0);
  const auto add = [&](std::size_t leaves, std::uint64_t epochs) {
    sum += Integer(static_cast<std::int64_t>(epochs)) * most(leaves);
  };
  for (std::size_t leaves = 0; leaves < nodes_.size(); ++leaves) {
    if (nodes_[leaves] != 0) add(leaves, nodes_[leaves]);
  }
  for (const auto& [leaves, trees] : trees_) {
    std::vector<std::size_t> below(2 * std::max<std::size_t>(leaves, 1), 1);
    std::map<std::size_t, std::uint64_t> nodes;
    for (std::size_t v = leaves; v-- > 1;) {
      below[v] = below[2 * v] + below[2 * v + 1];
      ++nodes[below[v]];
    }
    for (const auto& [size, count] : nodes) add(size, trees * count);
  }
  return sum;
}

Integer TournamentEpochs::most_failures(int degree) const {
  return most_in_epochs([degree](std::size_t leaves) {
    return davenport_schinzel_bound(degree, counted(leaves)) - Integer(1);
  });
}

Integer TournamentEpochs::most_failures_of_pairs(int failures) const {
  return most_in_epochs([failures](std::size_t leaves) {
    return Integer(failures) * counted(leaves / 2) * counted(leaves - leaves / 2);
  });
}

}  // namespace kinex
