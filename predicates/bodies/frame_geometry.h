// SPDX-License-Identifier: GPL-3.0-or-later
// Exact points and lines in the frame of one polygon, in homogeneous integer coordinates: the
// constants of pose forms (predicates/bodies/pose_form.h).
#ifndef KINEX_PREDICATES_BODIES_FRAME_GEOMETRY_H
#define KINEX_PREDICATES_BODIES_FRAME_GEOMETRY_H

#include <compare>
#include <string>
#include <vector>

#include "core/motion/scene.h"
#include "core/numbers/integer.h"
#include "core/numbers/rational.h"
#include "core/numbers/sign.h"

namespace kinex {

// (x / w, y / w), w > 0, gcd 1: equal points are equal members.
struct FramePoint {
  Integer x, y, w;
  friend bool operator==(const FramePoint&, const FramePoint&) = default;
  friend std::strong_ordering operator<=>(const FramePoint& a, const FramePoint& b) = default;
  std::string to_string() const;              // "(1/2, 3)"
  std::vector<Rational> coordinates() const;  // three: x, y, w, times a positive number
};

// The points with nx x + ny y = h; (nx, ny) is its normal, outward where the line bounds a polygon.
// gcd 1: equal lines with equal sides are equal members.
struct FrameLine {
  Integer nx, ny, h;
  friend bool operator==(const FrameLine&, const FrameLine&) = default;
  friend std::strong_ordering operator<=>(const FrameLine& a, const FrameLine& b) = default;
  std::string to_string() const;              // "[3, 4 | 5]"
  std::vector<Rational> coordinates() const;  // three: nx, ny, h, times a positive number
};

FramePoint frame_point(const Rational& x, const Rational& y);  // the point (x, y)
// The line of this normal, not zero, through a point.
FrameLine frame_line(const Rational& nx, const Rational& ny, const FramePoint& through);
// The points p with n.p = h.
FrameLine frame_line(const Rational& nx, const Rational& ny, const Rational& h);
// The common point of two lines: (1) side is zero there for both. Requires turn(first, second) positive.
FramePoint meeting(const FrameLine& first, const FrameLine& second);
// The sign of n.p - h: positive beyond the line, zero on it. (1) reversing the line negates it
Sign side(const FrameLine& line, const FramePoint& p);
// Positive iff the normals turn counter-clockwise, by less than half a turn, from first to second;
// zero iff they are parallel. (1) turn(b, a) = -turn(a, b)   (2) reversing one line negates it
Sign turn(const FrameLine& first, const FrameLine& second);
// The quadrant of the normal's angle: 0 for [0, 90) degrees, 1 for [90, 180), and so on.
int quadrant(const FrameLine& line);

// A convex polygon in its frame.
struct FramePolygon {
  std::vector<FramePoint> vertices;  // counter-clockwise
  std::vector<FrameLine> edges;  // edges[i] from vertices[i] to the next; by angle of the normal
  std::size_t size() const { return vertices.size(); }
};
// A body's polygon, `negated` (turned by half a turn about its origin) or unchanged. The first edge
// is the one with the smallest normal angle in [0, 360) degrees, so every rotation of the vertex
// list gives the same result.
FramePolygon frame_polygon(const std::vector<Vertex2>& polygon, bool negated);

// A rational in [sqrt(q), 1.01 sqrt(q)], q >= 0, of few bits beyond those of q; 0 for 0.
Rational root_above(const Rational& q);

}  // namespace kinex

#endif
