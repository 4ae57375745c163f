// SPDX-License-Identifier: GPL-3.0-or-later
// PlaneGeometry: the queries that a regular triangulation in the plane makes to the kernel, with ties
// resolved. All answers hold right after now.
//
// Ties. The lifted height of point i, x^2 + y^2 - w, is lowered by eps_i, eps_0 >> eps_1 >> .. > 0. So
// if a point v is identically in the plane of a triangle, all lifted, the four ids decide, ascending:
//   v itself         v is in conflict with the triangle
//   a vertex u of it v is in conflict if the triangle with v in u's place is turned over, and not if
//                    it is upright; if that triangle is identically flat the next id decides
//
//               .      a section; heights over the plane of the four lifted points (the row of f)
//      w    f     v    u is lowered. The plane of the triangle, dotted, turns about f, the edge opposite u.
//       .              v, beyond f, is below it and in conflict: v in u's place turns the triangle over.
//   u                  w is above it and not in conflict: w in u's place leaves the triangle upright.
//
// So a tie is decided by the sign of an orientation, the first one that is not identically zero. It may
// change while the tie lasts: it is a claim like any other.
//
// A ghost is in conflict with v if v is strictly beyond its edge, or identically on the edge's line and
// in conflict with the triangle inside. This defines one triangulation without flat triangles, and the
// points that are hidden, of every set of points that are not all on one line. Of identically equal
// points the one of largest weight, then of smallest id, can be a vertex.
// Source: Devillers, Teillaud, Perturbations for Delaunay and weighted Delaunay 3D triangulations
// (2011), who perturb the heights in another order.
#ifndef KINEX_STRUCTURES_TRIANGULATION_PLANE_GEOMETRY_H
#define KINEX_STRUCTURES_TRIANGULATION_PLANE_GEOMETRY_H

#include <array>

#include "core/engine/kernel.h"
#include "core/motion/scene.h"
#include "structures/triangulation/triangulation_2.h"

namespace kinex {

class PlaneGeometry {
 public:
  using HalfEdge = Triangulation2::HalfEdge;
  using Triangle = Triangulation2::Triangle;
  using Corners = Triangulation2::Corners;

  // `extents`: the weights of points, the radii of discs, whose squares are their weights, or none, in
  // which case all weights are 0. `infinity`: the vertex at infinity of the triangulations asked about.
  PlaneGeometry(Kernel& kernel, Extents extents, ObjectId infinity);

  Kernel& kernel() const { return *kernel_; }
  ObjectId infinity() const { return infinity_; }
  bool reads_radii() const { return radii_; }
  PredicateId order(int axis) const { return order_[static_cast<std::size_t>(axis)]; }
  // Both coordinates are identically equal, or equal at now itself (exact arithmetics).
  bool equal(ObjectId a, ObjectId b, When when) const;

  Sign orientation(const Corners& t) const {
    return kernel_->sign_after(orientation_, {t[0], t[1], t[2]});
  }
  Query orientation_claim(ObjectId a, ObjectId b, ObjectId c) const {
    return Query(orientation_, {a, b, c});
  }
  bool is_ghost(const Corners& t) const {
    return t[0] == infinity_ || t[1] == infinity_ || t[2] == infinity_;
  }
  // A ghost, or positively oriented.
  bool upright(const Corners& t) const { return is_ghost(t) || orientation(t) == Sign::kPositive; }

  // The claim of an edge: of the triangle `t` on one side, whose place i is opposite, and the apex on
  // the other side. All finite: the apex is not below the plane of t. Else the orientation of the
  // three finite points; that of a hull edge fails at touches, too.
  Query claim(const Corners& t, unsigned i, ObjectId apex) const;
  // What has to hold where claim() is identically zero. All finite: the first orientation by which the ties decide that is not identically zero. Of
  // two ghosts: the hull does not turn back. Else the claim itself: t is identically flat.
  Query tie_claim(const Corners& t, unsigned i, ObjectId apex) const;
  // The claim that v is not below the plane of a finite triangle.
  Query power_claim(const Corners& t, ObjectId v) const { return Query(power_, {t[1], t[0], t[2], v}); }
  // The claim is false, or identically zero and decided so by the ties.
  bool is_bad(const Corners& t, unsigned i, ObjectId apex) const;
  // v, which is no vertex of the triangle, is in conflict with it.
  bool conflict(const Triangulation2& store, Triangle t, ObjectId v) const;
  // The same for a finite upright triangle.
  bool below(const Corners& t, ObjectId v) const;

 private:
  // Of two ghosts: that the finite end of their edge is between its neighbours.
  Query between_claim(const Corners& t, unsigned i, ObjectId apex) const;

  Kernel* kernel_;
  ObjectId infinity_;
  bool radii_;
  std::array<PredicateId, 2> order_;
  PredicateId orientation_;
  PredicateId touch_;  // the same, for certificates that fail at touches
  PredicateId power_;
  PredicateId between_;
};

}  // namespace kinex

#endif
