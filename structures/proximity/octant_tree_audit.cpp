// SPDX-License-Identifier: GPL-3.0-or-later
// The minimum spanning tree in the maximum norm at exact positions. Lengths have three parts, of
// which the first that differs decides: as they are, what an infinitesimal turn adds, and what a step
// by the ids along (2, 1) adds.
#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "structures/proximity/octant_tree.h"
#include "structures/proximity/spanning_tree.h"

namespace kinex {
namespace {

using Parts = std::array<Rational, 3>;

// Without its sign: that of the first part that is not zero.
Parts size_of(Parts parts) {
  for (const Rational& part : parts) {
    if (part.is_zero()) continue;
    if (part.sign() > 0) return parts;
    for (Rational& each : parts) each = -each;
    return parts;
  }
  return parts;
}

}  // namespace

std::vector<ObjectId> static_maximum_norm_tree(const Snapshot& snapshot) {
  using Candidate = std::tuple<Parts, std::array<ObjectId, 2>>;
  std::vector<Candidate> all;
  for (ObjectId a = 0; a < snapshot.objects(); ++a) {
    for (ObjectId b = a + 1; b < snapshot.objects(); ++b) {
      if (!snapshot.alive(a) || !snapshot.alive(b)) continue;
      const Rational x = snapshot.position(b, 0) - snapshot.position(a, 0);
      const Rational y = snapshot.position(b, 1) - snapshot.position(a, 1);
      const Rational step(static_cast<int>(b - a));
      all.emplace_back(std::max(size_of({x, -y, Rational(2) * step}), size_of({y, x, step})),
                       std::array{a, b});
    }
  }
  std::sort(all.begin(), all.end());
  std::vector<std::array<ObjectId, 2>> edges, tree;
  for (const auto& [length, edge] : all) edges.push_back(edge);
  const std::vector<bool> chosen = kruskal(edges, snapshot.objects());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (chosen[i]) tree.push_back(edges[i]);
  }
  std::sort(tree.begin(), tree.end());
  std::vector<ObjectId> ids;
  for (const auto& edge : tree) ids.insert(ids.end(), edge.begin(), edge.end());
  return ids;
}

}  // namespace kinex
