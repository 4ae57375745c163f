// SPDX-License-Identifier: GPL-3.0-or-later
// SpaceComplex: triangulations in space in the terms of algorithms that are the same in every dimension
// (plane_complex.h: those in the plane).
#ifndef KINEX_STRUCTURES_TRIANGULATION_SPACE_COMPLEX_H
#define KINEX_STRUCTURES_TRIANGULATION_SPACE_COMPLEX_H

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

#include "structures/parts/tuple_changes.h"
#include "structures/triangulation/triangulation_3.h"

namespace kinex {

struct SpaceComplex {
  using Store = Triangulation3;
  using Cell = Triangulation3::Cell;
  using Facet = Triangulation3::Facet;
  using Simplex = Triangulation3::Quad;
  using Changes = CellChanges;
  static constexpr unsigned kCorners = 4;
  static constexpr int kAxes = 3;
  static constexpr std::uint32_t kNone = Triangulation3::kNone;

  static Cell cell(Facet f) { return Triangulation3::cell(f); }
  static unsigned place(Facet f) { return f % 4; }
  static Facet facet(Cell c, unsigned place) { return 4 * c + place; }
  static Facet mate(const Store& store, Facet f) { return store.mate(f); }
  static Simplex simplex(const Store& store, Cell c) { return store.quad(c); }
  static std::size_t cells(const Store& store) { return store.cells(); }
  static Cell capacity(const Store& store) { return store.cell_capacity(); }
  static Cell cell_of(const Store& store, ObjectId v) { return store.cell_of(v); }
  // The cells at v; none if it is no vertex.
  static void star(const Store& store, ObjectId v, std::vector<Cell>& out) { store.star(v, out); }
  static void start(Store& store, const Simplex& quad) { store.start(quad); }

  // Finds the facet of a triangulation that a facet of another one coincides with, on the same side.
  class FacetIndex {
   public:
    explicit FacetIndex(const Store& store);
    Facet find(const Store& other, Facet f) const;

   private:
    using Entry = std::tuple<Triangulation3::Triple, int, Facet>;
    std::vector<Entry> entries_;
  };
  // Adds to `more` the cells outside `cells`, which are ascending, that have an edge or a facet of `filling`
  // which is not on the rim: it would be there twice. `rim`: the facets of `cells` towards others.
  static void add_twins(const Store& store, const std::vector<Cell>& cells,
                        const std::vector<Facet>& rim, const std::vector<Simplex>& filling,
                        std::vector<Cell>& more);
};

}  // namespace kinex

#endif
