// SPDX-License-Identifier: GPL-3.0-or-later
// The Minkowski sum of two convex polygons, one of them turned by a constant rotation. Exact.
#ifndef KINEX_PREDICATES_BODIES_MINKOWSKI_SUM_H
#define KINEX_PREDICATES_BODIES_MINKOWSKI_SUM_H

#include <cstdint>
#include <optional>
#include <vector>

#include "core/motion/motion.h"
#include "predicates/bodies/frame_geometry.h"

namespace kinex {

struct MinkowskiSum {  // the sum, and where its edges come from
  FramePolygon polygon;  // in A's frame
  // Edge i of the sum is edge `edge` of polygon z (0: A, 1: B') translated by vertex `vertex` of
  // the other; vertex i is the sum of vertices a[i] and b[i]. Parallel edges are merged into A's.
  struct Origin {
    std::uint8_t z;
    std::uint32_t edge, vertex;
  };
  std::vector<Origin> edges;
  std::vector<std::uint32_t> a, b;
};

// The sum of A and R B', with R from the pose (predicates/bodies/pose_2.h); nullopt if R is not
// constant in t.
std::optional<MinkowskiSum> minkowski_sum(const FramePolygon& a, const FramePolygon& b,
                                          const Trajectory& pose);

}  // namespace kinex

#endif
