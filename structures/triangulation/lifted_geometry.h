// SPDX-License-Identifier: GPL-3.0-or-later
// LiftedGeometry: the queries that a triangulation which is a lower hull makes to the kernel, with ties
// resolved: points lifted by the sum of the squares of their coordinates, less their weights if they have
// any. In the plane and in space (plane_complex.h, space_complex.h). All answers hold right after now.
//
// Ties. The lifted height of point i is lowered by eps_i, eps_0 >> eps_1 >> .. > 0. So if a point v is
// identically in the plane of a cell, all lifted, their ids decide, ascending:
//   v itself         v is in conflict with the cell
//   a vertex u of it v is in conflict if the cell with v in u's place is turned over, and not if it is
//                    upright; if that cell is identically flat the next id decides
//
//               .      a section; heights over the plane of the lifted points (the row of f)
//      w    f     v    u is lowered. The plane of the cell, dotted, turns about f, the facet opposite u.
//       .              v, beyond f, is below it and in conflict: v in u's place turns the cell over.
//   u                  w is above it and not in conflict: w in u's place leaves the cell upright.
//
// So a tie is decided by the sign of an orientation, the first one that is not identically zero. It may
// change while the tie lasts: it is a claim like any other.
//
// A ghost is in conflict with v if v is strictly beyond its facet, or identically in the facet's plane
// and in conflict with the cell inside. This defines one triangulation without flat cells of every set of
// points that are not all in one plane (on one line), and those that are hidden. Of identically equal
// points the one of largest weight, then of smallest id, can be a vertex.
// Source: Devillers, Teillaud, Perturbations for Delaunay and weighted Delaunay 3D triangulations
// (2011), who perturb the heights in another order.
#ifndef KINEX_STRUCTURES_TRIANGULATION_LIFTED_GEOMETRY_H
#define KINEX_STRUCTURES_TRIANGULATION_LIFTED_GEOMETRY_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>

#include "core/engine/kernel.h"
#include "structures/triangulation/axis_pair.h"
#include "structures/triangulation/plane_complex.h"
#include "structures/triangulation/space_complex.h"

namespace kinex {

template <class C>
class LiftedGeometry {
 public:
  using Complex = C;
  using Store = typename Complex::Store;
  using Cell = typename Complex::Cell;
  using Simplex = typename Complex::Simplex;

  // `infinity`: the vertex at infinity of the triangulations asked about. `power`: of kCorners + 1 points,
  // positive iff the last one is below the plane of the others, which are upright, all lifted.
  LiftedGeometry(Kernel& kernel, ObjectId infinity, std::shared_ptr<const Predicate> power);
  // The triangulation of points of space that are all in one plane, in projection on two axes on which the
  // plane is not identically vertical. `power`: of four points, with the heights of space, of the sign of the
  // projection. The two axes decide whether points are equal: not so at an instant at which the plane is
  // vertical. For a complex of the plane.
  LiftedGeometry(Kernel& kernel, ObjectId infinity, AxisPair axes,
                 std::shared_ptr<const Predicate> power);

  Kernel& kernel() const { return *kernel_; }
  ObjectId infinity() const { return infinity_; }
  PredicateId order(int axis) const { return order_[static_cast<std::size_t>(axis)]; }
  const std::array<PredicateId, static_cast<std::size_t>(Complex::kAxes)>& orders() const {
    return order_;
  }

  // All coordinates are identically equal, or equal at now itself (exact arithmetics).
  bool equal(ObjectId a, ObjectId b, When when) const;
  // The points are on one line. Distinct objects; in the plane that is an orientation.
  bool on_line(ObjectId a, ObjectId b, ObjectId c, When when) const;

  Query orientation_claim(const Simplex& s) const { return query(orientation_, s); }
  Sign orientation(const Simplex& s) const { return kernel_->sign_after(orientation_claim(s)); }
  bool is_ghost(const Simplex& s) const {
    return std::find(s.begin(), s.end(), infinity_) != s.end();
  }
  // A ghost, or positively oriented.
  bool upright(const Simplex& s) const { return is_ghost(s) || orientation(s) == Sign::kPositive; }

  // The claim that v is not below the plane of a finite upright cell.
  Query power_claim(const Simplex& s, ObjectId v) const { return query(power_, turned(s), v); }
  // What has to hold where that is identically zero: the orientation by which the ties decide.
  Query tie_claim(const Simplex& s, ObjectId v) const;
  // v, no vertex of a finite upright cell, is below its plane, or in it and decided so by the ties.
  bool below(const Simplex& s, ObjectId v) const;
  // v, which is no vertex of the cell, is in conflict with it.
  bool conflict(const Store& store, Cell c, ObjectId v) const;

  static Simplex replaced(Simplex s, ObjectId old, ObjectId fresh) {
    for (ObjectId& v : s) {
      if (v == old) v = fresh;
    }
    return s;
  }
  // The same corners, of the other orientation.
  static Simplex turned(Simplex s) {
    std::swap(s[0], s[1]);
    return s;
  }

 protected:
  const auto& projections() const { return projected_; }
  static Query query(PredicateId predicate, const Simplex& s) {
    Query result;
    result.predicate = predicate;
    for (const ObjectId v : s) result.ids[result.arity++] = v;
    return result;
  }
  static Query query(PredicateId predicate, const Simplex& s, ObjectId v) {
    Query result = query(predicate, s);
    result.ids[result.arity++] = v;
    return result;
  }

 private:
  Kernel* kernel_;
  ObjectId infinity_;
  std::array<PredicateId, static_cast<std::size_t>(Complex::kAxes)> order_;
  // On two axes each; in the plane the orientation.
  std::array<PredicateId, Complex::kAxes == 2 ? 1 : 3> projected_;
  PredicateId orientation_;
  PredicateId power_;
};

}  // namespace kinex

#endif
