// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/parts/tournament_epochs.h"

#include <algorithm>
#include <functional>

#include "core/engine/bound.h"

namespace kinex {
namespace {

// v's descendants k levels below it are v 2^k .. (v + 1) 2^k - 1. Counts those on the lowest level,
// in pairs of siblings, and those one level above without children.
std::size_t leaves_below(std::size_t v, std::size_t leaves) {
  std::size_t width = 1;
  while (2 * width * v < 2 * leaves) width *= 2;
  if (width == 1) return 1;
  const std::size_t lowest = std::min(width, 2 * leaves - width * v);
  return width / 2 + lowest / 2;
}

}  // namespace

void TournamentEpochs::begin(std::vector<Node>& nodes, std::size_t leaves) {
  const std::size_t given = nodes.size();
  for (std::size_t i = 0; i < given; ++i) {
    for (Node v = nodes[i] / 2; v >= 1; v /= 2) nodes.push_back(v);
  }
  std::erase_if(nodes, [leaves](Node v) { return v == 0 || v >= leaves; });
  std::sort(nodes.begin(), nodes.end(), std::greater<>());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  for (const Node v : nodes) ++nodes_[leaves_below(v, leaves)];
}

template <class Most>
Integer TournamentEpochs::most_in_epochs(const Most& most) const {
  Integer sum(0);
  const auto add = [&](std::size_t leaves, std::uint64_t epochs) {
    sum += Integer(static_cast<std::int64_t>(epochs)) * most(leaves);
  };
  for (const auto& [leaves, epochs] : nodes_) add(leaves, epochs);
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
