// SPDX-License-Identifier: GPL-3.0-or-later
// Wedges: long-lived proofs that two convex polygons are disjoint.
//
// A wedge is a direction m fixed in A's frame, and two tangent lines of B' with normals g1, g2
// fixed in its frame that meet at v. It proves disjointness while
//   m.t - h_A(m) - m.(R v) > 0,   (R g1) x m >= 0,   m x (R g2) >= 0:
// m is then a combination of R g1 and R g2 with non-negative factors, so that m.(R v) bounds B'
// from above in direction m. The first is side_a, the others are normal_order and its reverse
// (predicates/pose_2.h).
//
// Where to put a wedge is found in doubles; the wedge itself is exact, and so are its certificates.
// With s the separation: m is within s / (16 D_M) of the direction from the nearest point of M; the
// half-angle of the wedge starts at atan(s / (2 D_B)) and is doubled while that costs at most s
// / 4. Then the wedge holds until B' has moved by 0.23 s in the metric |dt| + rho_B |d theta|
// (rho_B: the farthest point of B'). Source: the hysteresis property is that of Erickson, Guibas,
// Stolfi, Zhang (1999); certificate, rule and constants are worked out here.
#ifndef KINEX_PREDICATES_SEPARATING_WEDGE_H
#define KINEX_PREDICATES_SEPARATING_WEDGE_H

#include <array>
#include <optional>
#include <vector>

#include "core/motion.h"
#include "predicates/frame_geometry.h"

namespace kinex {

// A polygon in doubles, for searching.
struct RoughPolygon {
  explicit RoughPolygon(const FramePolygon& polygon);
  std::vector<std::array<double, 2>> vertices;
  double diameter = 0;
  double reach = 0;   // the farthest vertex from the origin
  FramePoint middle;  // of a disc that holds it, and its radius
  double radius = 0;
};

// A pose at one instant, roughly.
struct RoughPose {
  RoughPose(const Trajectory& pose, double now);
  std::array<double, 2> t{};
  double c = 1, s = 0;  // the rotation
};

struct SeparatingWedge {
  bool turns = false;     // false: g1 and g2 are not needed
  FrameLine line;         // of A: normal m, a little outside A
  FrameLine g1, g2;       // of B', touching it
  FramePoint v;           // where they meet
  double separation = 0;  // roughly
};

// nullopt if the bodies seem to meet, or are so close that doubles tell nothing.
std::optional<SeparatingWedge> separating_wedge(const FramePolygon& a, const RoughPolygon& rough_a,
                                                const FramePolygon& b, const RoughPolygon& rough_b,
                                                const RoughPose& pose);

}  // namespace kinex

#endif
