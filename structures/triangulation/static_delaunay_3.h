// SPDX-License-Identifier: GPL-3.0-or-later
// The static algorithm for Delaunay triangulations in space, right after now: points are inserted one
// by one (Bowyer 1981, Watson 1981).
#ifndef KINEX_STRUCTURES_TRIANGULATION_STATIC_DELAUNAY_3_H
#define KINEX_STRUCTURES_TRIANGULATION_STATIC_DELAUNAY_3_H

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "structures/triangulation/space_geometry.h"
#include "structures/triangulation/static_result.h"
#include "structures/triangulation/triangulation_3.h"

namespace kinex {

// Where a point is to be inserted. Neither member: the walk did not end, which an exact arithmetic
// excludes.
struct PlaceInSpace {
  Triangulation3::Cell cell = Triangulation3::kNone;  // a cell in conflict with the point, or
  ObjectId equal = kNoObject;                         // the vertex that is identically equal to it
};

// Walks from the cell `hint` towards v, through facets that have v strictly on their other side.
PlaceInSpace locate(const SpaceGeometry& geometry, const Triangulation3& store, ObjectId v,
                    Triangulation3::Cell hint);

// The cells in conflict with v, from one of them; and the cells of v with their outer facets, which
// replace them.
struct Conflicts {
  std::vector<Triangulation3::Cell> cells;
  std::vector<Triangulation3::Quad> star;
  // scratch, kept from one search to the next
  std::vector<std::uint32_t> mark = {};
  std::uint32_t epoch = 0;
};
void find_conflicts(const SpaceGeometry& geometry, const Triangulation3& store, ObjectId v,
                    Triangulation3::Cell first, Conflicts& out);

// Triangulates `points`, distinct ids in the order of insertion. `hidden` receives the points that
// are identically equal to an earlier one, each with that vertex. `quick`: inserts them in an order
// along a curve instead, for many points; equal points are hidden behind the smallest id.
StaticResult build_static(const SpaceGeometry& geometry, std::span<const ObjectId> points,
                          bool quick, Triangulation3& store,
                          std::vector<std::pair<ObjectId, ObjectId>>& hidden);

}  // namespace kinex

#endif
