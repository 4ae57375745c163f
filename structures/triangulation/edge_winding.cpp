// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/edge_winding.h"

#include <algorithm>
#include <set>
#include <utility>

#include "structures/parts/sort_unique.h"

namespace kinex {
namespace {

// The cells around the edge between places i and j of the cell c, in order, from c on.
std::vector<Triangulation3::Cell> cells_around_edge(const Triangulation3& store,
                                                    Triangulation3::Cell c, unsigned i,
                                                    unsigned j) {
  const Triangulation3::Quad quad = store.quad(c);
  const ObjectId u = quad[i], v = quad[j];
  std::vector<Triangulation3::Cell> cells{c};
  unsigned k = 0;
  while (k == i || k == j) ++k;
  Triangulation3::Facet out = 4 * c + k;
  for (std::size_t left = store.cells(); left != 0; --left) {
    const Triangulation3::Facet in = store.mate(out);
    const Triangulation3::Cell next = Triangulation3::cell(in);
    if (next == c) break;
    cells.push_back(next);
    // On through the other facet at the edge.
    for (Triangulation3::Facet f = 4 * next; f < 4 * next + 4; ++f) {
      if (f != in && store.apex(f) != u && store.apex(f) != v) out = f;
    }
  }
  return cells;
}

// True if the finite ones among these cells, which are upright, go round the edge u v once at most.
bool goes_round_once(const LiftedGeometry<SpaceComplex>& geometry, const Triangulation3& store,
                     const std::vector<Triangulation3::Cell>& cells, ObjectId u, ObjectId v) {
  std::vector<std::pair<ObjectId, ObjectId>> wedges;
  for (const Triangulation3::Cell c : cells) {
    Triangulation3::Quad q = store.quad(c);
    if (geometry.is_ghost(q)) continue;
    // Even permutations to u v x y.
    const auto exchange = [&q](std::size_t a, std::size_t b) {
      if (a != b) std::swap(q[a], q[b]);
      return a != b;
    };
    const auto place = [&q](ObjectId w) {
      return static_cast<std::size_t>(std::find(q.begin(), q.end(), w) - q.begin());
    };
    bool odd = exchange(0, place(u));
    odd = exchange(1, place(v)) != odd;
    if (odd) std::swap(q[2], q[3]);
    wedges.emplace_back(q[2], q[3]);
  }
  if (wedges.empty()) return true;
  // A direction where a wedge begins: at the hull the first one.
  ObjectId a = wedges.front().first;
  for (const auto& [x, y] : wedges) {
    const ObjectId begin = x;
    const bool follows = std::any_of(wedges.begin(), wedges.end(),
                                     [begin](const auto& other) { return other.second == begin; });
    if (!follows) a = begin;
  }
  int times = 0;
  for (const auto& [x, y] : wedges) {
    if (y == a) continue;
    const bool begun = x == a || geometry.orientation({u, v, x, a}) != Sign::kNegative;
    if (begun && geometry.orientation({u, v, a, y}) == Sign::kPositive) ++times;
  }
  return times == 1;
}

}  // namespace

void add_windings(const LiftedGeometry<SpaceComplex>& geometry, const Triangulation3& store,
                  const std::vector<Triangulation3::Cell>& near,
                  std::vector<Triangulation3::Cell>& wrong) {
  const std::vector<Triangulation3::Cell> known = wrong;
  std::set<std::pair<ObjectId, ObjectId>> seen;
  for (const Triangulation3::Cell c : near) {
    const Triangulation3::Quad quad = store.quad(c);
    for (unsigned i = 0; i < 4; ++i) {
      for (unsigned j = i + 1; j < 4; ++j) {
        const auto [u, v] = std::minmax(quad[i], quad[j]);
        if (v == store.infinity() || !seen.emplace(u, v).second) continue;
        const auto around = cells_around_edge(store, c, i, j);
        const bool wrong_anyway = std::any_of(around.begin(), around.end(), [&](auto other) {
          return std::binary_search(known.begin(), known.end(), other);
        });
        if (wrong_anyway || goes_round_once(geometry, store, around, u, v)) continue;
        wrong.insert(wrong.end(), around.begin(), around.end());
      }
    }
  }
  sort_unique(wrong);
}

}  // namespace kinex
