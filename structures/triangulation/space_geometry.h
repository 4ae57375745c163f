// SPDX-License-Identifier: GPL-3.0-or-later
// SpaceGeometry: the claims that the certificates of a Delaunay triangulation in space state. All answers
// hold right after now. Points are lifted by their squares: a point below the plane of a cell is inside its
// sphere. Ties: lifted_geometry.h.
#ifndef KINEX_STRUCTURES_TRIANGULATION_SPACE_GEOMETRY_H
#define KINEX_STRUCTURES_TRIANGULATION_SPACE_GEOMETRY_H

#include "core/engine/kernel.h"
#include "structures/triangulation/lifted_geometry.h"

namespace kinex {

class SpaceGeometry : public LiftedGeometry<SpaceComplex> {
 public:
  SpaceGeometry(Kernel& kernel, ObjectId infinity);

  // The claim of a facet: of the cell `q`, whose place i is opposite, and the apex on the other side.
  // All finite: the apex is not inside the sphere of the cell. Else the orientation of the four
  // finite points.
  Query claim(const Simplex& q, unsigned i, ObjectId apex) const;
  // The claim is false, or identically zero and decided so by the ties. Between two ghosts zero is
  // bad only if their facets overlap in the plane: the hull is folded. Which of several facets in one
  // plane are on the hull follows from the cells inside.
  bool is_bad(const Simplex& q, unsigned i, ObjectId apex) const;

 private:
  bool folded(const Simplex& q, unsigned i, ObjectId apex) const;
};

}  // namespace kinex

#endif
