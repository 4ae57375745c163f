// SPDX-License-Identifier: GPL-3.0-or-later
// The static algorithm for regular triangulations in the plane, right after now: points are inserted
// one by one (Bowyer 1981, Watson 1981), and those that come to lie above the lower hull are hidden.
#ifndef KINEX_STRUCTURES_TRIANGULATION_STATIC_REGULAR_2_H
#define KINEX_STRUCTURES_TRIANGULATION_STATIC_REGULAR_2_H

#include <cstdint>
#include <span>
#include <vector>

#include "structures/triangulation/plane_geometry.h"
#include "structures/triangulation/static_result.h"
#include "structures/triangulation/triangulation_2.h"

namespace kinex {

// The triangle that contains v, or a ghost that v is strictly beyond, by a walk from the triangle
// `hint` through edges that have v strictly on their other side. kNone: the walk did not end, which an
// exact arithmetic excludes. v may be a vertex, or equal to one.
Triangulation2::Triangle locate(const PlaneGeometry& geometry, const Triangulation2& store,
                                ObjectId v, Triangulation2::Triangle hint);

// The triangles in conflict with v, from one of them; and those of v with their outer edges, which
// replace them.
struct PlaneConflicts {
  std::vector<Triangulation2::Triangle> cells;
  std::vector<Triangulation2::Corners> star;
  // scratch, kept from one search to the next
  std::vector<std::uint32_t> mark = {};
  std::uint32_t epoch = 0;
};
void find_conflicts(const PlaneGeometry& geometry, const Triangulation2& store, ObjectId v,
                    Triangulation2::Triangle first, PlaneConflicts& out);

// Triangulates `points`, distinct ids in the order of insertion; those that are no vertices of `store`
// afterwards are hidden. `quick`: inserts them in an order along a curve instead, for many points.
// kFlat: they are identically on one line.
StaticResult build_static(const PlaneGeometry& geometry, std::span<const ObjectId> points,
                          bool quick, Triangulation2& store);

}  // namespace kinex

#endif
