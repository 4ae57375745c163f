// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/spanning_tree.h"

#include <boost/pending/disjoint_sets.hpp>

namespace kinex {

std::vector<bool> kruskal(std::span<const std::array<std::uint32_t, 2>> edges,
                          std::size_t vertices) {
  boost::disjoint_sets_with_storage<> sets(vertices);
  std::vector<bool> chosen(edges.size(), false);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto a = sets.find_set(edges[i][0]), b = sets.find_set(edges[i][1]);
    if (a == b) continue;
    sets.link(a, b);
    chosen[i] = true;
  }
  return chosen;
}

BoundCheck spanning_tree_bound(const std::string& structure, const Integer& edges, int k,
                               const BoundContext& context) {
  return at_most(structure + ".external",
                 "each two edges change their order at most as often as its degree",
                 Integer(k * context.degree) * pairs(edges), counted(context.ledger->external));
}

}  // namespace kinex
