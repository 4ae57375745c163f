// SPDX-License-Identifier: GPL-3.0-or-later
// PlaneComplex: triangulations in the plane in the terms of algorithms that are the same in every dimension
// (space_complex.h: those in space). A cell is a triangle; a facet of it is a half-edge, opposite the corner
// at one of the cell's places 0, 1, 2.
#ifndef KINEX_STRUCTURES_TRIANGULATION_PLANE_COMPLEX_H
#define KINEX_STRUCTURES_TRIANGULATION_PLANE_COMPLEX_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "structures/parts/tuple_changes.h"
#include "structures/triangulation/triangulation_2.h"

namespace kinex {

struct PlaneComplex {
  using Store = Triangulation2;
  using Cell = Triangulation2::Triangle;
  using Facet = Triangulation2::HalfEdge;
  using Simplex = Triangulation2::Corners;
  using Changes = TriangleChanges;
  static constexpr unsigned kCorners = 3;
  static constexpr int kAxes = 2;
  static constexpr std::uint32_t kNone = Triangulation2::kNone;

  static Cell cell(Facet f) { return Triangulation2::triangle(f); }
  static unsigned place(Facet f) { return (f + 2) % 3; }
  static Facet facet(Cell c, unsigned place) { return 3 * c + (place + 1) % 3; }
  static Facet mate(const Store& store, Facet f) { return store.twin(f); }
  static Simplex simplex(const Store& store, Cell c) { return store.corners(c); }
  static std::size_t cells(const Store& store) { return store.triangles(); }
  static Cell capacity(const Store& store) { return store.triangle_capacity(); }
  static Cell cell_of(const Store& store, ObjectId v) {
    return Triangulation2::triangle(store.out(v));
  }
  // The cells at v; none if it is no vertex.
  static void star(const Store& store, ObjectId v, std::vector<Cell>& out);
  static void start(Store& store, const Simplex& t) { store.start(t[0], t[1], t[2]); }

  // Finds the facet of a triangulation that a facet of another one coincides with, on the same side.
  class FacetIndex {
   public:
    explicit FacetIndex(const Store& store) : store_(&store) {}
    Facet find(const Store& other, Facet f) const {
      return store_->between(other.origin(f), other.target(f));
    }

   private:
    const Store* store_;
  };
  // Adds to `more` the cells outside `cells`, which are ascending, that have a face of `filling` which is
  // not on the rim: it would be there twice. `rim`: the facets of `cells` towards others.
  static void add_twins(const Store& store, const std::vector<Cell>& cells,
                        const std::vector<Facet>& rim, const std::vector<Simplex>& filling,
                        std::vector<Cell>& more);
};

}  // namespace kinex

#endif
