// SPDX-License-Identifier: GPL-3.0-or-later
// SpaceGeometry: the queries that a Delaunay triangulation in space makes to the kernel, with ties
// resolved. All answers hold right after now.
//
// Ties. The lifted height of point i is lowered by eps_i, eps_0 >> eps_1 >> .. > 0. So if a point v
// is identically on the sphere of a cell, the five ids decide, ascending:
//   v itself         v is in conflict with the cell
//   a vertex u of it v is in conflict if the cell with v in u's place is turned over, and not if it
//                    is upright; if that cell is identically flat the next id decides
//
//               .      a section; heights over the plane of the five lifted points (the row of f)
//      w    f     v    u is lowered. The plane of the cell, dotted, turns about f, the facet opposite u.
//       .              v, beyond f, is below it and in conflict: v in u's place turns the cell over.
//   u                  w is above it and not in conflict: w in u's place leaves the cell upright.
//
// A ghost is in conflict with v if v is strictly beyond its facet, or identically in the facet's plane
// and in conflict with the cell inside. This defines one triangulation without flat cells of every
// set of distinct points that are not all in one plane.
// Source: Devillers, Teillaud, Perturbations for Delaunay and weighted Delaunay 3D triangulations
// (2011), who perturb the heights in another order.
#ifndef KINEX_STRUCTURES_TRIANGULATION_SPACE_GEOMETRY_H
#define KINEX_STRUCTURES_TRIANGULATION_SPACE_GEOMETRY_H

#include <array>
#include <span>

#include "core/engine/kernel.h"
#include "structures/triangulation/triangulation_3.h"

namespace kinex {

class SpaceGeometry {
 public:
  using Cell = Triangulation3::Cell;
  using Facet = Triangulation3::Facet;
  using Quad = Triangulation3::Quad;

  // `infinity`: the vertex at infinity of the triangulations asked about.
  SpaceGeometry(Kernel& kernel, ObjectId infinity);

  Kernel& kernel() const { return *kernel_; }
  ObjectId infinity() const { return infinity_; }
  PredicateId order(int axis) const { return order_[static_cast<std::size_t>(axis)]; }

  // All coordinates are identically equal, or equal at now itself (exact arithmetics).
  bool identical(ObjectId a, ObjectId b) const { return equal(a, b, When::kRightAfter); }
  bool equal(ObjectId a, ObjectId b, When when) const;
  bool on_line(ObjectId a, ObjectId b, ObjectId c) const;

  Sign orientation(const Quad& q) const {
    return kernel_->sign_after(orientation_, {q[0], q[1], q[2], q[3]});
  }
  bool is_ghost(const Quad& q) const {
    return q[0] == infinity_ || q[1] == infinity_ || q[2] == infinity_ || q[3] == infinity_;
  }
  // A ghost, or positively oriented.
  bool upright(const Quad& q) const { return is_ghost(q) || orientation(q) == Sign::kPositive; }

  // The claim of a facet: of the cell `q`, whose place i is opposite, and the apex on the other side.
  // All finite: the apex is not inside the sphere of the cell. Else the orientation of the four
  // finite points.
  Query claim(const Quad& q, ObjectId apex) const;
  // The claim is false, or identically zero and decided so by the ties. Between two ghosts zero is
  // bad only if their facets overlap in the plane: the hull is folded. Which of several facets in one
  // plane are on the hull follows from the cells inside.
  bool is_bad(const Quad& q, unsigned i, ObjectId apex) const;
  // v, which is no vertex of the cell, is in conflict with it.
  bool conflict(const Triangulation3& store, Cell c, ObjectId v) const;
  // The same for a finite upright cell.
  bool inside(const Quad& q, ObjectId v) const;

 private:
  bool folded(const Quad& q, unsigned i, ObjectId apex) const;

  Kernel* kernel_;
  ObjectId infinity_;
  std::array<PredicateId, 3> order_;
  std::array<PredicateId, 3> projected_;
  PredicateId orientation_;
  PredicateId in_sphere_;
};

}  // namespace kinex

#endif
