// SPDX-License-Identifier: GPL-3.0-or-later
// Where a point is to be inserted in a triangulation in the plane or in space, right after now: the walk to
// its cell, and the cells in conflict with it (Bowyer 1981, Watson 1981).
#ifndef KINEX_STRUCTURES_TRIANGULATION_POINT_LOCATION_H
#define KINEX_STRUCTURES_TRIANGULATION_POINT_LOCATION_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "structures/triangulation/lifted_geometry.h"

namespace kinex {

// Where a point is.
template <class Complex>
struct PointPlace {
  // Contains the point, or is a ghost that it is strictly beyond; kNone: the walk did not end, which an
  // exact arithmetic excludes.
  typename Complex::Cell cell = Complex::kNone;
  ObjectId equal = kNoObject;  // the vertex that is identically equal to the point
};

// Walks from the cell `hint`, if there is one, towards v, through facets that have v strictly on their
// other side. v may be a vertex.
template <class Complex>
PointPlace<Complex> locate(const LiftedGeometry<Complex>& geometry,
                           const typename Complex::Store& store, ObjectId v,
                           typename Complex::Cell hint) {
  using Facet = typename Complex::Facet;
  using Simplex = typename Complex::Simplex;
  if (hint == Complex::kNone) return {};
  typename Complex::Cell c = hint;
  const Simplex start = Complex::simplex(store, hint);
  const auto beyond = std::find(start.begin(), start.end(), store.infinity());
  if (beyond != start.end()) {
    const auto place = static_cast<unsigned>(beyond - start.begin());
    c = Complex::cell(Complex::mate(store, Complex::facet(hint, place)));
  }
  Facet entered = Complex::kNone;
  for (std::size_t steps = 2 * Complex::cells(store) + 4; steps != 0; --steps) {
    Facet onwards = Complex::kNone;
    const Simplex s = Complex::simplex(store, c);
    unsigned zeros = 0, corner = entered == Complex::kNone ? 0 : Complex::place(entered);
    for (unsigned n = 0; n < Complex::kCorners; ++n) {
      const unsigned i = (static_cast<unsigned>(steps) + n) % Complex::kCorners;
      const Facet f = Complex::facet(c, i);
      if (f == entered) continue;
      Simplex with = s;
      with[i] = v;
      const bool own = std::count(with.begin(), with.end(), v) > 1;
      const Sign sign = own ? Sign::kZero : geometry.orientation(with);
      if (sign == Sign::kNegative) {
        onwards = Complex::mate(store, f);
        break;
      }
      if (sign == Sign::kZero) {
        ++zeros;
      } else {
        corner = i;
      }
    }
    if (onwards == Complex::kNone) {
      // In the planes of all facets but one: at the vertex opposite that.
      return {c, zeros == Complex::kCorners - 1 ? s[corner] : kNoObject};
    }
    c = Complex::cell(onwards);
    entered = onwards;
    if (store.ghost(c)) return {c, kNoObject};
  }
  return {};
}

// The cells in conflict with v, from one of them; and the cells of v with their outer facets, which
// replace them.
template <class Complex>
struct Conflicts {
  std::vector<typename Complex::Cell> cells;
  std::vector<typename Complex::Simplex> star;
  // scratch, kept from one search to the next
  std::vector<std::uint32_t> mark = {};
  std::uint32_t epoch = 0;

  std::size_t bytes() const {
    return (cells.capacity() + mark.capacity()) * sizeof(std::uint32_t) +
           star.capacity() * sizeof(typename Complex::Simplex);
  }
};

// Finds them, from one of them. Requires that `first` is in conflict with v. O(cells in conflict).
template <class Complex>
void find_conflicts(const LiftedGeometry<Complex>& geometry, const typename Complex::Store& store,
                    ObjectId v, typename Complex::Cell first, Conflicts<Complex>& out) {
  using Cell = typename Complex::Cell;
  out.cells.assign(1, first);
  out.star.clear();
  if (out.mark.size() < Complex::capacity(store)) out.mark.resize(Complex::capacity(store), 0);
  const std::uint32_t in = out.epoch += 2, beyond = in + 1;
  out.mark[first] = in;
  for (std::size_t i = 0; i < out.cells.size(); ++i) {
    for (unsigned k = 0; k < Complex::kCorners; ++k) {
      const Cell other = Complex::cell(Complex::mate(store, Complex::facet(out.cells[i], k)));
      if (out.mark[other] >= in) continue;
      out.mark[other] = geometry.conflict(store, other, v) ? in : beyond;
      if (out.mark[other] == in) out.cells.push_back(other);
    }
  }
  for (const Cell c : out.cells) {
    for (unsigned k = 0; k < Complex::kCorners; ++k) {
      if (out.mark[Complex::cell(Complex::mate(store, Complex::facet(c, k)))] == in) continue;
      typename Complex::Simplex s = Complex::simplex(store, c);
      s[k] = v;
      out.star.push_back(s);
    }
  }
}

// The first points that are not all in one plane (on one line), upright; false if all are.
template <class Complex>
bool first_simplex(const LiftedGeometry<Complex>& geometry, std::span<const ObjectId> points,
                   typename Complex::Simplex& out) {
  std::size_t next = 0;
  unsigned found = 0;
  for (; next < points.size() && found < Complex::kCorners; ++next) {
    const ObjectId v = points[next];
    if (found == 1 && geometry.equal(out[0], v, When::kRightAfter)) continue;
    if (Complex::kCorners == 4 && found == 2 &&
        geometry.on_line(out[0], out[1], v, When::kRightAfter)) {
      continue;
    }
    out[found] = v;
    if (found + 1 == Complex::kCorners) {
      const Sign sign = geometry.orientation(out);
      if (sign == Sign::kZero) continue;
      if (sign == Sign::kNegative) std::swap(out[0], out[1]);
    }
    ++found;
  }
  return found == Complex::kCorners;
}

}  // namespace kinex

#endif
