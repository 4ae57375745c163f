// SPDX-License-Identifier: GPL-3.0-or-later
// The minimum spanning tree in the norm of a polygon at exact positions.
#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "structures/proximity/cone_tree.h"
#include "structures/proximity/static_cones_audit.h"
#include "structures/proximity/static_forest_audit.h"
#include "structures/proximity/static_norm_audit.h"

namespace kinex {
namespace {

using Edge = std::array<ObjectId, 2>;

}  // namespace

std::vector<ObjectId> static_norm_tree(const Snapshot& snapshot, int corners) {
  const std::vector<StaticUnit> units = static_units(corners);
  const auto parts = [&](const Edge& edge) {
    return static_norm_length(snapshot, units, edge[0], edge[1]);
  };
  struct Candidate {
    Rational length;  // the first part
    Edge edge;
  };
  std::vector<Candidate> all;
  for (ObjectId a = 0; a < snapshot.objects(); ++a) {
    for (ObjectId b = a + 1; b < snapshot.objects(); ++b) {
      if (!snapshot.alive(a) || !snapshot.alive(b)) continue;
      all.push_back({static_norm(snapshot, units, a, b), {a, b}});
    }
  }
  std::sort(all.begin(), all.end(), [&parts](const Candidate& one, const Candidate& other) {
    if (const auto order = one.length <=> other.length; order != 0) return order < 0;
    return std::tuple(parts(one.edge), one.edge) < std::tuple(parts(other.edge), other.edge);
  });
  std::vector<Edge> edges, tree;
  for (const Candidate& one : all) edges.push_back(one.edge);
  for (const std::size_t i : static_forest(edges, snapshot.objects())) tree.push_back(edges[i]);
  std::sort(tree.begin(), tree.end());
  std::vector<ObjectId> ids;
  for (const auto& edge : tree) ids.insert(ids.end(), edge.begin(), edge.end());
  return ids;
}

bool within_ratio(const Snapshot& snapshot, const std::vector<ObjectId>& edges,
                  const std::vector<ObjectId>& others, const std::array<int, 2>& ratio) {
  const auto squares = [&snapshot](const std::vector<ObjectId>& ids) {
    std::vector<Rational> result;
    for (std::size_t i = 0; i + 1 < ids.size(); i += 2) {
      Rational square;
      for (int axis = 0; axis < 2; ++axis) {
        const Rational d = snapshot.position(ids[i], axis) - snapshot.position(ids[i + 1], axis);
        square += d * d;
      }
      result.push_back(std::move(square));
    }
    std::sort(result.begin(), result.end());
    return result;
  };
  const std::vector<Rational> one = squares(edges), other = squares(others);
  if (one.size() != other.size()) return false;
  for (std::size_t i = 0; i < one.size(); ++i) {
    if (Rational(ratio[1]) * one[i] > Rational(ratio[0]) * other[i]) return false;
  }
  return true;
}

}  // namespace kinex
