// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/spanning_tree.h"

#include <boost/pending/disjoint_sets.hpp>

namespace kinex {

std::vector<bool> kruskal(std::span<const EdgeLengths::Edge> edges, std::size_t vertices) {
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

BoundCheck spanning_tree_bound(const std::string& structure, const BoundContext& context) {
  const Integer n = counted(context.objects());
  return at_most(structure + ".external",
                 "each two pairs of points change their order by distance at most 2d times",
                 Integer(2 * context.degree) * pairs(pairs(n)), counted(context.ledger->external));
}

}  // namespace kinex
