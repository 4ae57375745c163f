// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <tuple>
#include <utility>

#include "structures/proximity/spanning_tree.h"
#include "structures/proximity/static_forest_audit.h"

namespace kinex {
namespace {

using Edge = std::array<ObjectId, 2>;

}  // namespace

std::vector<ObjectId> static_spanning_tree(const Snapshot& snapshot) {
  struct Candidate {
    Rational squared;
    Edge edge;
  };
  std::vector<Candidate> all;
  for (ObjectId a = 0; a < snapshot.objects(); ++a) {
    for (ObjectId b = a + 1; b < snapshot.objects(); ++b) {
      if (!snapshot.alive(a) || !snapshot.alive(b)) continue;
      Rational squared;
      for (int axis = 0; axis < snapshot.dimension(); ++axis) {
        const Rational gap = snapshot.position(b, axis) - snapshot.position(a, axis);
        squared += gap * gap;
      }
      all.push_back({std::move(squared), {a, b}});
    }
  }
  std::sort(all.begin(), all.end(), [](const Candidate& x, const Candidate& y) {
    if (const auto order = x.squared <=> y.squared; order != 0) return order < 0;
    return x.edge < y.edge;
  });
  std::vector<Edge> edges;
  edges.reserve(all.size());
  for (const Candidate& one : all) edges.push_back(one.edge);
  std::vector<Edge> tree;
  for (const std::size_t i : static_forest(edges, snapshot.objects())) tree.push_back(edges[i]);
  std::sort(tree.begin(), tree.end());
  std::vector<ObjectId> ids;
  for (const auto& edge : tree) ids.insert(ids.end(), edge.begin(), edge.end());
  return ids;
}

}  // namespace kinex
