// SPDX-License-Identifier: GPL-3.0-or-later
// The features of two polygons behind the constants of a proof: the vertex or edge that a line
// touches, the vertex that a point is, or the vertices below an outer corner. Exact.
#ifndef KINEX_EXPERIMENTS_VIEW_FRAME_FEATURE_H
#define KINEX_EXPERIMENTS_VIEW_FRAME_FEATURE_H

#include <array>
#include <cstdint>
#include <vector>

#include "core/motion/scene.h"
#include "core/numbers/rational.h"

namespace kinex::view {

struct FrameFeature {
  enum class Kind : std::uint8_t {
    kNone,    // unrelated to the polygon
    kVertex,  // vertex `first`: the point itself, or the only one that the line touches
    kEdge,    // the line of edge `first`, which goes from vertex `first` to the next
    kAcross,  // the line across edge `first` at vertex `last`
    kCorner,  // a point outside: its tangents touch vertices `first` and `last`, going
              // counter-clockwise
    kSupport  // no tangent of this polygon: vertex `first`, or the edge from `first` to `last`, is
              // the farthest in the direction of the line's normal
  };
  Kind kind = Kind::kNone;
  std::uint32_t first = 0, last = 0;
  friend bool operator==(const FrameFeature&, const FrameFeature&) = default;
};

// `polygon`: as in the scene, whose numbering the features use; `negated`: the constants belong to
// the polygon turned by half a turn about its origin. A line is (nx, ny, h), n its outward
// normal; a point is (x, y, w), w > 0. O(size) operations.
FrameFeature line_feature(const std::vector<Vertex2>& polygon, bool negated,
                          const std::vector<Rational>& line);
FrameFeature point_feature(const std::vector<Vertex2>& polygon, bool negated,
                           const std::vector<Rational>& point);
// The farthest in this direction, kSupport.
FrameFeature support_feature(const std::vector<Vertex2>& polygon, bool negated,
                             const std::array<Rational, 2>& direction);

}  // namespace kinex::view

#endif
