// SPDX-License-Identifier: GPL-3.0-or-later
// ConeFrame: cones around a point of the plane, as the cones of Schnyder woods (schnyder_wood.h), and
// the norm that is linear in each of them.
//
// Every wood is made from three of the axes, each from its first point on or from its last; the three
// linear functions, suitably scaled, add up to zero. The cone of a colour is a multiple of 3 plus the
// colour. Of each two opposite cones one at most counts; the others only make a wood whole.
//
// Octants. The axes are x, y, x + y, x - y; the norm is the maximum norm:
//
//   wood    orders f1, f2, f3      cone 1               cone 2                cone 3
//   first   -y, x, y - x           y < x < 0, by -y     0 < y < x, by x       x < 0 < y
//   second  x, y, -(x + y)         0 < -y < x, by x     0 < -x < y, by y      x, y < 0
//
// (Coordinates are relative to the point: "by -y" is first the one with the largest y.) The four
// octants are, up to a half turn, one of each two opposite ones. The quadrants, by y - x and by
// -(x + y), do not count.
//
// Polygons. The unit circle of the norm is a polygon with 12 or 20 corners on the Euclidean unit
// circle: (1, 0), (4, 3)/5, (3, 4)/5 and their images by quarter turns; or (12, 5)/13 and (5, 12)/13,
// too. A wood for each two opposite cones between neighbouring corners b and c:
//
//       \   u   / c         f1 = u, the linear function that is 1 at b and at c
//        \     /  .         f2 = -(b x v), smaller on the left of the ray along b
//         \   /  .          f3 = -(v x c), smaller on the right of the ray along c
//          \ / . . . b      cone 1: both are smaller than at p, the smallest u first. u is the
//           p                       length of v there: |v| <= u.v <= |u| |v|.
//
// So the norm is at least the Euclidean one, and at most sqrt(10)/3 (12 corners) or sqrt(26)/5 (20)
// times it. A minimum spanning tree in it is a (1 + eps)-approximation of the Euclidean one, edge by
// edge in ascending order, with eps below 0.055 or 0.02.
#ifndef KINEX_STRUCTURES_PROXIMITY_CONE_FRAME_H
#define KINEX_STRUCTURES_PROXIMITY_CONE_FRAME_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "structures/proximity/schnyder_wood.h"

namespace kinex {

struct ConeFrame {
  using Vector = std::array<int, 2>;
  // An order of a wood: along an axis, from its first point on or from its last.
  struct Order {
    std::size_t axis;
    bool reversed;
  };
  // The length of a step within a cone: its product with a unit, or minus that.
  struct Side {
    std::uint8_t unit;
    bool negative;
  };

  int corners;               // of the unit circle of the norm
  std::vector<Vector> axes;  // their products with (2, 1) are positive (turned_order.h)
  std::vector<std::array<Order, SchnyderWood::kColours>> woods;
  std::vector<std::optional<Side>> sides;  // by cone; nullopt: it does not count
  std::vector<Vector> units;               // the linear functions, all multiplied by one number
  // The squares of the lengths of a minimum spanning tree in the norm, ascending, are at most this
  // many times those of the Euclidean one: a fraction.
  std::array<int, 2> ratio;

  std::size_t cones() const { return sides.size(); }
  bool counts(std::size_t cone) const { return sides[cone].has_value(); }
  // The number of cones that count.
  std::size_t counted() const;
};

// The axes of octants.
enum OctantAxis : std::size_t { kAlongX, kAlongY, kAlongSum, kAlongDifference };
inline constexpr std::size_t kOctantAxes = 4;
// "x", "y", "x + y", "x - y".
const char* octant_axis_name(OctantAxis axis);
// Their directions.
ConeFrame::Vector octant_axis(OctantAxis axis);

// Each lives as long as the program.
const ConeFrame& octant_frame();
// `corners`: 12 or 20; std::invalid_argument otherwise.
const ConeFrame& polygon_frame(int corners);

}  // namespace kinex

#endif
