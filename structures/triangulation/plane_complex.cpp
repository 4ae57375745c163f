// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/plane_complex.h"

#include <algorithm>
#include <set>
#include <utility>

namespace kinex {

void PlaneComplex::star(const Store& store, ObjectId v, std::vector<Cell>& out) {
  out.clear();
  if (!store.has(v)) return;
  const Facet first = store.out(v);
  Facet h = first;
  do {
    out.push_back(cell(h));
    h = store.around(h);
  } while (h != first);
}

void PlaneComplex::add_twins(const Store& store, const std::vector<Cell>& cells,
                             const std::vector<Facet>& rim, const std::vector<Simplex>& filling,
                             std::vector<Cell>& more) {
  std::set<std::pair<ObjectId, ObjectId>> known;
  for (const Facet h : rim) known.insert(std::minmax(store.origin(h), store.target(h)));
  for (const Simplex& t : filling) {
    for (std::size_t i = 0; i < 3; ++i) {
      const ObjectId a = std::min(t[i], t[(i + 1) % 3]), b = std::max(t[i], t[(i + 1) % 3]);
      if (!known.insert({a, b}).second) continue;
      const Facet h = store.between(a, b);  // a is finite
      if (h == kNone) continue;
      for (const Facet side : {h, store.twin(h)}) {
        if (!std::binary_search(cells.begin(), cells.end(), cell(side))) more.push_back(cell(side));
      }
    }
  }
}

}  // namespace kinex
