// SPDX-License-Identifier: GPL-3.0-or-later
// Poses: one convex polygon as seen from another, and what separates them as linear forms in it.
//
// Body X carries the point x of its frame to c_X + R_X x. The rotation R_X is given by a rotor
// w_X = p + iq: R_X = W_X / N_X, N_X = p^2 + q^2, W_X the multiplication by w_X^2. In A's frame:
//
//   w = conj(w_A) w_B, W the multiplication by w^2, N = N_A N_B
//   R = R_A^T R_B = W / N           t = R_A^T (c_B - c_A)           B' = -B
//
// The bodies meet iff t lies in the Minkowski sum of A and R B'.
//
// The pose of (A, B) is a derived object of seven axes, all polynomials:
//   0, 1: N_B W_A^T (c_B - c_A)    = N t
//   2, 3: N_A W_B^T (c_B - c_A)    = N R^T t
//   4:    N                         > 0
//   5, 6: W = [[c, -s], [s, c]] by c and s,
// all times the same positive number, which makes all coefficients integers.
// Degree in t: that of the positions plus twice that of both rotors.
//
// Constants, in the frame of A or of B' (a positive multiple is the same constant):
//   line   (m_x, m_y, h)     the points x with m.x = h; m is its outward normal
//   point  (x, y, w), w > 0  (x / w, y / w)
//
// Every predicate has degree 1 in the pose and in each constant: positive multiples keep the sign.
// No arguments may be permuted unless a list says so.
//
// Source: configuration space and rational motion as in the separation-sensitive collision
// detection of Erickson, Guibas, Stolfi and Zhang (1999); the forms are worked out here.
#ifndef KINEX_PREDICATES_BODIES_POSE_2_H
#define KINEX_PREDICATES_BODIES_POSE_2_H

#include <memory>

#include "core/arithmetic/number_needs.h"
#include "core/arithmetic/predicate.h"
#include "core/motion/derived_objects.h"

namespace kinex {

inline constexpr int kPoseAxes = 7;

// The pose of the second base as seen from the first.
std::shared_ptr<const Construction> make_pose_2();
// What the poses of a scene of bodies need: their largest degree is that of the positions plus twice
// that of the rotors of two bodies. O(coefficients).
DerivedKind pose_2_kind(const Scene& scene);
// The same rationals without the short way through machine integers, for tests.
std::shared_ptr<const Construction> make_long_pose_2();

// Whose frame a line belongs to.
enum class Frame { kA, kB };

// side_a(pose, line of A, point of B') and side_b(pose, line of B', point of A): the side of the
// line, translated by the point, on which t lies: m.(t - R b) - h; for B' the same in its frame.
//   (1) positive iff t is strictly on the side of the outward normal
//   (2) degree in t: that of the pose
//   (3) `inward`: the negated value (named inside_a, inside_b)
std::shared_ptr<const Predicate> make_pose_side(Frame frame, bool inward);

// As make_pose_side(frame, inward), but fails at a touch too (core/arithmetic/touch.h).
std::shared_ptr<const Predicate> make_pose_touch(Frame frame, bool inward);

// along_a(pose, line of A, point of A, point of B') and along_b(pose, line of B', point of A, point
// of B'): the position of t relative to the sum of the two points, along the line. The line's
// direction is its normal turned by +90 degrees.
//   (1) positive iff t is strictly beyond the sum in that direction
//   (2) degree in t: that of the pose
std::shared_ptr<const Predicate> make_pose_along(Frame frame);

// As make_pose_along(frame), or its negated value (`reversed`; named against_a, against_b), but
// fails at a touch too.
std::shared_ptr<const Predicate> make_pose_along_touch(Frame frame, bool reversed);

// normal_order(pose, line of A, line of B') = (R g) x m.
//   (1) positive iff the normal m of A is counter-clockwise, by less than half a turn, of the
//       turned normal g of B'
//   (2) degree in t: twice that of both rotors
//   (3) `reversed`: the negated value (named normal_order_reversed)
std::shared_ptr<const Predicate> make_pose_normal_order(bool reversed);

// As make_pose_normal_order(reversed), but fails at a touch too (normals become parallel and turn
// back).
std::shared_ptr<const Predicate> make_pose_order_touch(bool reversed);

// left_of_ray(pose, a0, b0, a, b), points a0 and a of A, b0 and b of B': the side of the ray from
// a0 + R b0 through a + R b on which t lies.
//   (1) positive iff t is strictly to the left of the line that carries the ray
//   (2) degree in t: that of the pose
//   (3) exchanging (a0, b0) and (a, b) changes the sign; `right`: the negated value (right_of_ray)
std::shared_ptr<const Predicate> make_pose_ray(bool right);

}  // namespace kinex

#endif
