// SPDX-License-Identifier: GPL-3.0-or-later
// Tests whether a polygon intersects itself.
#ifndef KINEX_EXPERIMENTS_FORMATS_SIMPLE_POLYGON_H
#define KINEX_EXPERIMENTS_FORMATS_SIMPLE_POLYGON_H

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/motion/scene.h"

namespace kinex::formats {

// Two edges, e < f, that have a common point and are not consecutive; edge k goes from vertex k to
// the next. nullopt if there are none, or if none was found among the first million pairs whose
// boxes had to be compared. Exact; a sweep over the edges' boxes.
std::optional<std::array<std::size_t, 2>> edges_that_meet(const std::vector<Vertex2>& polygon);

}  // namespace kinex::formats

#endif
