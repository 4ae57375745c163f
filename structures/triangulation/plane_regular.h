// SPDX-License-Identifier: GPL-3.0-or-later
// PlaneRegular: the regular triangulation in the plane, of regular_2, and of the points of regular_3 that are all
// in one plane.
#ifndef KINEX_STRUCTURES_TRIANGULATION_PLANE_REGULAR_H
#define KINEX_STRUCTURES_TRIANGULATION_PLANE_REGULAR_H

#include <algorithm>

#include "structures/triangulation/plane_flips.h"
#include "structures/triangulation/regular_triangulation.h"

namespace kinex {

class PlaneRegular : public PlaneFlips<RegularTriangulation<PlaneComplex>> {
 protected:
  using PlaneFlips::PlaneFlips;

  // A vertex of degree 3 is at an end of the edge.
  bool repair(Facet h) override {
    if (flippable(h)) {
      flip(h);
      return true;
    }
    const ObjectId u = store_.origin(h), v = store_.target(h);
    return hide(std::min(u, v)) || hide(std::max(u, v));
  }
};

}  // namespace kinex

#endif
