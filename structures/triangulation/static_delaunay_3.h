// SPDX-License-Identifier: GPL-3.0-or-later
// The static algorithm for Delaunay triangulations in space, right after now: points are inserted one
// by one (point_location.h).
#ifndef KINEX_STRUCTURES_TRIANGULATION_STATIC_DELAUNAY_3_H
#define KINEX_STRUCTURES_TRIANGULATION_STATIC_DELAUNAY_3_H

#include <span>
#include <utility>
#include <vector>

#include "structures/triangulation/regular_geometry.h"
#include "structures/triangulation/static_result.h"
#include "structures/triangulation/triangulation_3.h"

namespace kinex {

// Triangulates `points`, distinct ids in the order of insertion. `hidden` receives the points that
// are identically equal to an earlier one, each with that vertex. `quick`: inserts them in an order
// along a curve instead, for many points; equal points are hidden behind the smallest id.
StaticResult build_static(const RegularGeometry<SpaceComplex>& geometry,
                          std::span<const ObjectId> points, bool quick, Triangulation3& store,
                          std::vector<std::pair<ObjectId, ObjectId>>& hidden);

}  // namespace kinex

#endif
