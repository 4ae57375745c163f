// SPDX-License-Identifier: GPL-3.0-or-later
// The minimum spanning tree in the norm of a polygon at exact positions. Lengths have three parts, of
// which the first that differs decides: as they are, what an infinitesimal turn adds, and what a step
// by the ids along (2, 1) adds.
#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "structures/proximity/cone_tree.h"
#include "structures/proximity/static_cones_audit.h"
#include "structures/proximity/static_forest_audit.h"

namespace kinex {
namespace {

using Edge = std::array<ObjectId, 2>;
using Vector = std::array<Rational, 2>;
using Parts = std::array<Rational, 3>;

Vector step(const Snapshot& snapshot, const Edge& edge) {
  const auto [a, b] = edge;
  return {snapshot.position(b, 0) - snapshot.position(a, 0),
          snapshot.position(b, 1) - snapshot.position(a, 1)};
}

Rational product(const Vector& u, const Vector& v) { return u[0] * v[0] + u[1] * v[1]; }

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

Rational length_of(const std::vector<Vector>& units, const Vector& v) {
  Rational length;
  for (const Vector& u : units) {
    Rational one = product(u, v);
    if (one.sign() < 0) one = -one;
    if (length < one) length = std::move(one);
  }
  return length;
}

}  // namespace

std::vector<ObjectId> static_norm_tree(const Snapshot& snapshot, int corners) {
  const std::vector<Vector> units = static_units(corners);
  const auto parts = [&](const Edge& edge) {
    const Vector v = step(snapshot, edge);
    const Rational ids(static_cast<int>(edge[1] - edge[0]));
    Parts largest;
    for (const Vector& u : units) {
      largest = std::max(largest, size_of({product(u, v), product(u, {-v[1], v[0]}),
                                           product(u, {ids + ids, ids})}));
    }
    return largest;
  };
  struct Candidate {
    Rational length;  // the first part
    Edge edge;
  };
  std::vector<Candidate> all;
  for (ObjectId a = 0; a < snapshot.objects(); ++a) {
    for (ObjectId b = a + 1; b < snapshot.objects(); ++b) {
      if (!snapshot.alive(a) || !snapshot.alive(b)) continue;
      all.push_back({length_of(units, step(snapshot, {a, b})), {a, b}});
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
      const Vector v = step(snapshot, {ids[i], ids[i + 1]});
      result.push_back(product(v, v));
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
