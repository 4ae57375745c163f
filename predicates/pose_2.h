// SPDX-License-Identifier: GPL-3.0-or-later
// Poses: one convex polygon as seen from another, and what separates them as linear forms in it.
//
// Body X carries the point x of its frame to c_X + R_X x, where the rotation R_X is given by a
// rotor w_X = p + iq: R_X = W_X / N_X, N_X = p^2 + q^2, W_X the multiplication by w_X^2. In A's
// frame, with R = R_A^T R_B (rotor w = conj(w_A) w_B, W its multiplication by w^2, N = N_A N_B), t
// = R_A^T (c_B - c_A) and B' = -B, the bodies meet iff t lies in the Minkowski sum of A and R B'.
//
// The pose of (A, B) is a derived object of seven axes, all polynomials:
//   0, 1: N_B W_A^T (c_B - c_A)    = N t
//   2, 3: N_A W_B^T (c_B - c_A)    = N R^T t
//   4:    N                         > 0
//   5, 6: W = [[c, -s], [s, c]] by c and s,
// all times the same positive number, which makes all coefficients whole.
// Degree: that of the positions plus twice that of both rotors.
//
// Constants, in the frame of A or of B' (a multiple by a positive number is the same constant):
//   a line of three axes (m_x, m_y, h): the points x with m.x = h; m is its outward normal;
//   a point of three axes (x, y, w), w > 0: (x / w, y / w).
//
// Source: configuration space and rational motion as in the separation-sensitive collision
// detection of Erickson, Guibas, Stolfi and Zhang (1999); the forms are worked out here.
#ifndef KINEX_PREDICATES_POSE_2_H
#define KINEX_PREDICATES_POSE_2_H

#include <memory>

#include "core/derived_objects.h"
#include "core/predicate.h"

namespace kinex {

inline constexpr int kPoseAxes = 7;

// The pose of the second base as seen from the first.
std::shared_ptr<const Construction> make_pose_2();
// The same rationals without the short way through machine integers, for tests.
std::shared_ptr<const Construction> make_long_pose_2();

// Whose frame a line belongs to.
enum class Frame { kA, kB };

// side_a(pose, line of A, point of B') and side_b(pose, line of B', point of A): where t is with
// respect to the line translated by the point, on the side of the outward normal: m.(t - R b) - h,
// for B' the same with everything turned into its frame. `inward`: the negated value (named
// inside_a, inside_b). The degree of the pose.
std::shared_ptr<const Predicate> make_pose_side(Frame frame, bool inward);

// The same as make_pose_side(frame, inward), but fails at a touch too (core/touch.h).
std::shared_ptr<const Predicate> make_pose_touch(Frame frame, bool inward);

// along_a(pose, line of A, point of A, point of B'), along_b(pose, line of B', point of A, point of
// B'): positive iff t lies beyond the sum of the two points in the line's direction, its normal
// turned by a quarter counter-clockwise. The degree of the pose.
std::shared_ptr<const Predicate> make_pose_along(Frame frame);

// The same, or its negated value (`reversed`; named against_a, against_b), failing at a touch too.
std::shared_ptr<const Predicate> make_pose_along_touch(Frame frame, bool reversed);

// normal_order(pose, line of A, line of B') = (R g) x m: positive iff the normal m of A is
// counter-clockwise, by less than half a turn, from the turned normal g of B'. `reversed`: the
// negated value (named normal_order_reversed). Degree: twice that of both rotors.
std::shared_ptr<const Predicate> make_pose_normal_order(bool reversed);

// The same, but fails at a touch too: where normals become parallel and turn back.
std::shared_ptr<const Predicate> make_pose_order_touch(bool reversed);

// left_of_ray(pose, a0, b0, a, b), all points, of A and of B' in turns: where t is as seen from c =
// a0 + R b0, positive iff it is to the left of the ray from c through a + R b. `right`: the negated
// value (named right_of_ray). The degree of the pose.
std::shared_ptr<const Predicate> make_pose_ray(bool right);

}  // namespace kinex

#endif
