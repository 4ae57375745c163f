// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/space_complex.h"

#include <algorithm>
#include <initializer_list>
#include <set>
#include <utility>

namespace kinex {

SpaceComplex::FacetIndex::FacetIndex(const Store& store) {
  for (Cell c = 0; c < store.cell_capacity(); ++c) {
    if (!store.live(c)) continue;
    const Simplex quad = store.quad(c);
    for (unsigned i = 0; i < 4; ++i) {
      entries_.push_back({store.triple(4 * c + i), Store::side(quad, i), 4 * c + i});
    }
  }
  std::sort(entries_.begin(), entries_.end());
}

SpaceComplex::Facet SpaceComplex::FacetIndex::find(const Store& other, Facet f) const {
  const Entry wanted{other.triple(f), Store::side(other.quad(Store::cell(f)), f % 4), 0};
  const auto at = std::lower_bound(entries_.begin(), entries_.end(), wanted);
  const bool found = at != entries_.end() && std::get<0>(*at) == std::get<0>(wanted) &&
                     std::get<1>(*at) == std::get<1>(wanted);
  return found ? std::get<2>(*at) : kNone;
}

void SpaceComplex::add_twins(const Store& store, const std::vector<Cell>& cells,
                             const std::vector<Facet>& rim, const std::vector<Simplex>& filling,
                             std::vector<Cell>& more) {
  std::set<Triangulation3::Triple> on_rim;
  std::set<std::pair<ObjectId, ObjectId>> edges;
  for (const Facet f : rim) {
    const Triangulation3::Triple t = store.triple(f);
    on_rim.insert(t);
    edges.insert({t[0], t[1]});
    edges.insert({t[0], t[2]});
    edges.insert({t[1], t[2]});
  }
  std::vector<Cell> star;
  const auto look_for = [&](std::initializer_list<ObjectId> face) {
    // From a finite vertex: infinity, the largest id, is in many cells.
    store.star(*face.begin(), star);
    for (const Cell c : star) {
      if (std::binary_search(cells.begin(), cells.end(), c)) continue;
      const bool all = std::all_of(face.begin(), face.end(),
                                   [&](ObjectId v) { return store.place_of(c, v) != kNone; });
      if (all) more.push_back(c);
    }
  };
  std::set<Triangulation3::Triple> seen;
  for (Simplex quad : filling) {
    std::sort(quad.begin(), quad.end());
    for (std::size_t out = 0; out < 4; ++out) {
      Triangulation3::Triple t{};
      std::size_t count = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        if (k != out) t[count++] = quad[k];
      }
      if (on_rim.count(t) != 0 || !seen.insert(t).second) continue;
      look_for({t[0], t[1], t[2]});
    }
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) {
        if (edges.insert({quad[i], quad[j]}).second) look_for({quad[i], quad[j]});
      }
    }
  }
}

}  // namespace kinex
