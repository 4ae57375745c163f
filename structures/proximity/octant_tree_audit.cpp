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
  using Edge = std::array<ObjectId, 2>;
  const auto parts = [&snapshot](const Edge& edge) {
    const auto [a, b] = edge;
    const Rational x = snapshot.position(b, 0) - snapshot.position(a, 0);
    const Rational y = snapshot.position(b, 1) - snapshot.position(a, 1);
    const Rational step(static_cast<int>(b - a));
    return std::max(size_of({x, -y, Rational(2) * step}), size_of({y, x, step}));
  };
  struct Candidate {
    Rational length;  // the first part
    Edge edge;
  };
  std::vector<Candidate> all;
  for (ObjectId a = 0; a < snapshot.objects(); ++a) {
    for (ObjectId b = a + 1; b < snapshot.objects(); ++b) {
      if (!snapshot.alive(a) || !snapshot.alive(b)) continue;
      Rational x = snapshot.position(b, 0) - snapshot.position(a, 0);
      Rational y = snapshot.position(b, 1) - snapshot.position(a, 1);
      if (x.sign() < 0) x = -x;
      if (y.sign() < 0) y = -y;
      all.push_back({x < y ? std::move(y) : std::move(x), {a, b}});
    }
  }
  std::sort(all.begin(), all.end(), [&parts](const Candidate& one, const Candidate& other) {
    if (const auto order = one.length <=> other.length; order != 0) return order < 0;
    return std::tuple(parts(one.edge), one.edge) < std::tuple(parts(other.edge), other.edge);
  });
  std::vector<Edge> edges, tree;
  for (const Candidate& one : all) edges.push_back(one.edge);
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
