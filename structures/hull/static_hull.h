// SPDX-License-Identifier: GPL-3.0-or-later
// The convex hull of points in the plane just after now, by a static algorithm.
#ifndef KINEX_STRUCTURES_HULL_STATIC_HULL_H
#define KINEX_STRUCTURES_HULL_STATIC_HULL_H

#include <span>
#include <vector>

#include "structures/hull/convex_hull_2_signs.h"

namespace kinex {

// The strict vertices counter-clockwise from the smallest id; of identically equal points the
// smallest id. Andrew's monotone chain: O(n log n) signs.
std::vector<ObjectId> static_hull(const HullSigns& signs, std::span<const ObjectId> objects);

}  // namespace kinex

#endif
