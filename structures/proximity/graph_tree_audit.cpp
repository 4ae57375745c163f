// SPDX-License-Identifier: GPL-3.0-or-later
// The minimum spanning forest of a graph at exact weights: edges by weight, equal ones by object.
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "structures/proximity/graph_tree.h"
#include "structures/proximity/static_forest_audit.h"

namespace kinex {

void GraphTree::audit(const Snapshot& snapshot, AuditReport& report) const {
  std::vector<ObjectId> order;
  for (ObjectId object = 0; object < snapshot.objects(); ++object) {
    if (snapshot.alive(object)) order.push_back(object);
  }
  std::stable_sort(order.begin(), order.end(), [&](ObjectId a, ObjectId b) {
    return snapshot.position(a, 0) < snapshot.position(b, 0);
  });
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (const ObjectId object : order) {
    const auto [u, v] = weights_.ends(object);
    edges.push_back({u, v});
  }
  std::vector<ObjectId> ids;
  for (const std::size_t place : static_forest(edges, weights_.vertices())) {
    ids.push_back(order[place]);
  }
  std::sort(ids.begin(), ids.end());
  report.check(ids == attribute().ids, [] { return "another forest is the lightest"; });
}

}  // namespace kinex
