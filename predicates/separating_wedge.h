// SPDX-License-Identifier: GPL-3.0-or-later
// Wedges: long-lived proofs that two convex polygons are disjoint.
//
// A wedge is a line of one body and two tangent lines of the other that meet at a point v; its role
// says whose the line is. With the line's normal m fixed in A's frame, and the tangents' normals
// g1, g2 in that of B', it proves disjointness while
//   m.t - h_A(m) - m.(R v) > 0,   (R g1) x m >= 0,   m x (R g2) >= 0:
// m is then a combination of R g1 and R g2 with non-negative factors, so that m.(R v) bounds B'
// from above in direction m. The first is side_a, the others are normal_order and its reverse
// (predicates/pose_2.h). The other role is the same seen from B': m in its frame, R^T for R, t' =
// R^T t for t; side_b, normal_order_reversed and normal_order.
//
// Where to put a wedge is found in doubles; the wedge itself is exact, and so are its certificates.
// With s the separation: m is within s / (16 D_M) of the direction from the nearest point of M; the
// half-angle of the wedge starts at 0.47 s / D and is doubled while that costs at most s / 4, D the
// diameter of the body whose tangents they are. Beyond two of its diameters a disc takes its place:
// the half-angle is then infinite. So a wedge holds until the motion in the frame of its line has
// gone 0.23 s: in the metric |dt| + rho_B |d theta| where the line is A's, in |dt'| + rho_A |d
// theta| where it is that of B' (rho: the farthest point of the other body from its origin). Either
// role holds until the larger of the two has.
//
// Which role: the one of the larger half-angle, or at equal ones of the smaller loss; a corner gets
// the wedge, a long edge the line. Both are told apart by a thousandth of the angle and of the
// separation, so that rounding does not decide. Then the larger body gets the wedge; where all is
// equal the line is A's. So the choice does not depend on which body is called A unless they are
// alike.
//
// Source: the hysteresis property is that of Erickson, Guibas, Stolfi, Zhang (1999); certificate,
// rule and constants are worked out here.
#ifndef KINEX_PREDICATES_SEPARATING_WEDGE_H
#define KINEX_PREDICATES_SEPARATING_WEDGE_H

#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "core/motion.h"
#include "predicates/frame_geometry.h"
#include "predicates/pose_2.h"

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

// A pose at one instant, roughly: the second body as seen from the first, or in the frame of B' the
// first as seen from the second.
struct RoughPose {
  RoughPose(const Trajectory& pose, double now, Frame frame);
  // From exact values: only the time is rounded. For motions of high degree, or long after t = 0,
  // whose terms cancel.
  static RoughPose precise(const Trajectory& pose, double now, Frame frame);
  std::array<double, 2> t{};
  double c = 1, s = 0;  // the rotation
  // Bounds on what rounding does to t, and to a vector of length 1 that is turned; +infinity where
  // the pose is beyond what doubles hold, or the time is: then no wedge can be put.
  double error_t = 0, error_turn = 0;

  bool is_known() const { return error_t < std::numeric_limits<double>::infinity(); }

 private:
  template <class Value>
  RoughPose(Frame frame, const Value& at);
  void forget();
};

struct WedgeBody {
  const FramePolygon& polygon;
  const RoughPolygon& rough;
};

// The errors of the pose would keep a wedge from being put where doubles could still tell the
// bodies apart.
bool is_too_rough(const RoughPose& pose, const RoughPolygon& a, const RoughPolygon& b);

// How the bodies lie, and what a wedge of either role withstands; all in doubles.
struct WedgePlan {
  struct Role {
    double half_angle = 0;  // +infinity: a disc, no tangents
    double loss = 0;        // what the wedge reaches beyond the body
  };
  double separation = 0;
  std::array<double, 2> direction{};  // in A's frame, from the nearest point of M; a unit vector
  Role line_of_a, line_of_b;
  double diameter_a = 0, diameter_b = 0;
  // Whose line withstands more.
  Frame longer() const;
};

// `pose` in A's frame; nullopt if the bodies seem to meet, or are so close that doubles tell
// nothing.
std::optional<WedgePlan> plan_wedge(const RoughPolygon& a, const RoughPolygon& b,
                                    const RoughPose& pose);

struct SeparatingWedge {
  bool turns = false;  // false: g1 and g2 are not needed
  FrameLine line;      // normal m, a little outside its body
  FrameLine g1, g2;    // of the other body, touching it
  FramePoint v;        // where they meet
};

// The wedge of one role of the plan: `a` and `b` (B') and `pose` as for the plan. nullopt if the
// lines, rounded, do not meet as they should.
std::optional<SeparatingWedge> separating_wedge(const WedgePlan& plan, Frame line_of,
                                                const WedgeBody& a, const WedgeBody& b,
                                                const RoughPose& pose);

}  // namespace kinex

#endif
