// SPDX-License-Identifier: GPL-3.0-or-later
// Tests whether a polygon intersects itself.
#ifndef KINEX_EXPERIMENTS_FORMATS_SIMPLE_POLYGON_H
#define KINEX_EXPERIMENTS_FORMATS_SIMPLE_POLYGON_H

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/motion/scene.h"

namespace kinex {

// Two edges, e < f, that have a point in common and do not follow each other; edge k goes from
// vertex k to the next. nullopt: there are none, or none was found among the first million pairs
// whose boxes had to be compared. Exact; a sweep over the edges' boxes.
std::optional<std::array<std::size_t, 2>> edges_that_meet(const std::vector<Vertex2>& polygon);

}  // namespace kinex

#endif
