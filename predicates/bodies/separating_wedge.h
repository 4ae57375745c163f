// SPDX-License-Identifier: GPL-3.0-or-later
// Wedges: long-lived proofs that two convex polygons are disjoint.
//
// A wedge is a line of one body and two tangent lines of the other that meet at a point v. Its role
// says which body the line belongs to. The line is fixed in that body's frame, the tangents in the
// other's, so that the other body may turn within the wedge:
//
//            \     B     /
//             \         /         two tangents, fixed in B's frame
//              \       /
//               \     /
//                \   /
//                  v              their common point
//      ------------------------   line, fixed in A's frame; its normal m points up
//           .-----------.
//           |     A     |
//
// With the tangents' normals g1, g2 in the frame of B', it proves disjointness while
//   m.t - h_A(m) - m.(R v) > 0     side_a
//   (R g1) x m >= 0                normal_order           (predicates/bodies/pose_2.h)
//   m x (R g2) >= 0                normal_order_reversed
// By the last two m is a combination of R g1 and R g2 with non-negative factors, so that m.(R v)
// bounds R B' from above in direction m. The other role is the same seen from B': m in its frame,
// R^T for R, t' = R^T t for t; side_b, normal_order_reversed and normal_order.
//
// A wedge is placed in doubles; the wedge itself is exact, and so are its certificates. With s the
// separation, M the Minkowski sum of A and R B', D the diameter of the body with the tangents:
//   (1) m is within s / (16 D_M) of the direction from the nearest point of M;
//   (2) the half-angle of the wedge starts at 0.47 s / D and is doubled while that costs at most
//       s / 4;
//   (3) for s > 2 D a disc replaces the wedge: the half-angle is infinite.
// So a wedge holds until the motion in the frame of its line has gone 0.23 s: in the metric
// |dt| + rho_B |d theta| for a line of A, |dt'| + rho_A |d theta| for one of B' (rho: the farthest
// point of the other body from its origin). Either role holds until the larger of the two has gone
// that far.
//
// Choice of the role, by the first of these that decides:
//   (1) the larger half-angle, if they differ by a thousandth of it;
//   (2) the smaller loss, if they differ by a thousandth of s;
//   (3) the larger body gets the wedge;
//   (4) the line is A's.
// The thousandths keep rounding from deciding. A corner thus gets the wedge, a long edge the line.
// The choice does not depend on which body is called A unless they are alike.
//
// Source: the hysteresis property is that of Erickson, Guibas, Stolfi, Zhang (1999); certificate,
// rule and constants are worked out here.
#ifndef KINEX_PREDICATES_BODIES_SEPARATING_WEDGE_H
#define KINEX_PREDICATES_BODIES_SEPARATING_WEDGE_H

#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "core/motion/motion.h"
#include "predicates/bodies/frame_geometry.h"
#include "predicates/bodies/pose_2.h"

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

// An approximate pose at one instant: the second body as seen from the first, or in the frame of B'
// the first as seen from the second.
struct RoughPose {
  RoughPose(const Trajectory& pose, double now, Frame frame);
  // From exact values: only the time is rounded. For motions of high degree, or long after t = 0,
  // whose terms cancel.
  static RoughPose precise(const Trajectory& pose, double now, Frame frame);
  std::array<double, 2> t{};
  double c = 1, s = 0;  // the rotation
  // Bounds on the rounding error of t, and of a turned unit vector; +infinity where the pose
  // or the time is beyond the range of doubles: then no wedge can be placed.
  double error_t = 0, error_turn = 0;

  bool is_known() const { return error_t < std::numeric_limits<double>::infinity(); }

 private:
  template <class Value>
  RoughPose(Frame frame, const Value& at);
  void forget();
};

struct WedgeBody {  // a body for a wedge, exactly and in doubles
  const FramePolygon& polygon;
  const RoughPolygon& rough;
};

// True if the pose is too inaccurate for a wedge where doubles could still separate the bodies.
bool is_too_rough(const RoughPose& pose, const RoughPolygon& a, const RoughPolygon& b);

// The separation of the bodies, and what a wedge of either role withstands; all in doubles.
struct WedgePlan {
  struct Role {  // what a wedge with this line withstands
    double half_angle = 0;  // +infinity: a disc, no tangents
    double loss = 0;        // by how much the wedge reaches beyond the body
  };
  double separation = 0;
  std::array<double, 2> direction{};  // in A's frame, from the nearest point of M; a unit vector
  Role line_of_a, line_of_b;
  double diameter_a = 0, diameter_b = 0;
  // The body whose line withstands more.
  Frame longer() const;
};

// `pose` in A's frame; nullopt if the bodies seem to meet, or are too close for doubles.
std::optional<WedgePlan> plan_wedge(const RoughPolygon& a, const RoughPolygon& b,
                                    const RoughPose& pose);

struct SeparatingWedge {  // a line of one body, a cone around the other
  bool turns = false;  // false: g1 and g2 are not needed
  FrameLine line;      // normal m, slightly outside its body
  FrameLine g1, g2;    // of the other body, touching it
  FramePoint v;        // their common point
};

// The wedge of one role of the plan: `a` and `b` (B') and `pose` as for the plan. nullopt if the
// rounded lines do not form a wedge with enough room.
std::optional<SeparatingWedge> separating_wedge(const WedgePlan& plan, Frame line_of,
                                                const WedgeBody& a, const WedgeBody& b,
                                                const RoughPose& pose);

}  // namespace kinex

#endif
