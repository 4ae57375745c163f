// SPDX-License-Identifier: GPL-3.0-or-later
// RegularGeometry: the claims that the certificates of a regular triangulation state, in the plane and in
// space. All answers hold right after now.
#ifndef KINEX_STRUCTURES_TRIANGULATION_REGULAR_GEOMETRY_H
#define KINEX_STRUCTURES_TRIANGULATION_REGULAR_GEOMETRY_H

#include <memory>

#include "core/motion/scene.h"
#include "structures/triangulation/lifted_geometry.h"

namespace kinex {

// The power of the points, and the same for certificates that fail at touches.
struct PowerPair {
  std::shared_ptr<const Predicate> plain, touch;
};

template <class C>
class RegularGeometry : public LiftedGeometry<C> {
 public:
  using Complex = C;
  using Base = LiftedGeometry<Complex>;
  using Simplex = typename Complex::Simplex;

  // `extents`: the weights of points, the radii of discs, whose squares are their weights, or none, in
  // which case all weights are 0.
  RegularGeometry(Kernel& kernel, Extents extents, ObjectId infinity);
  // Without weights: the Delaunay triangulation.
  RegularGeometry(Kernel& kernel, ObjectId infinity) requires(Complex::kAxes == 3);
  // With these or without weights, of points of space that are all in one plane, in projection on two axes:
  // lifted_geometry.h.
  RegularGeometry(Kernel& kernel, AxisPair axes, Extents extents, ObjectId infinity);

  bool reads_radii() const { return radii_; }

  // The claim of a facet: of the cell `s` on one side, whose place i is opposite, and the apex on the other
  // side. All finite: the apex is not below the plane of s. Else the orientation of the finite points. That
  // of the hull's edges (in the plane, vertices) fails at failures only, all others at touches, too.
  Query claim(const Simplex& s, unsigned i, ObjectId apex) const;
  // What has to hold where claim() is identically zero. All finite: the orientation by which the ties
  // decide. Of two ghosts: the hull does not turn back. Else the claim itself: s is identically flat.
  Query claim_of_tie(const Simplex& s, unsigned i, ObjectId apex) const;
  // The claim is false, or identically zero and decided so by the ties.
  bool is_bad(const Simplex& s, unsigned i, ObjectId apex) const;

 private:
  RegularGeometry(Kernel& kernel, PowerPair powers, bool radii, ObjectId infinity);
  RegularGeometry(Kernel& kernel, AxisPair axes, PowerPair powers, bool radii, ObjectId infinity);
  // Of two ghosts whose facets are identically in one plane: that these are on different sides of the face
  // which they share.
  Query unfolded_claim(const Simplex& s, unsigned i, ObjectId apex) const;

  bool radii_;
  PredicateId power_touch_,
      touch_;             // the power and the orientation, for certificates: they fail at touches
  PredicateId unfolded_;  // a corner, the face of two, the other corner
};

}  // namespace kinex

#endif
