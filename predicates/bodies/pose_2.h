// SPDX-License-Identifier: GPL-3.0-or-later
// Poses: the position of one convex polygon in the frame of another, and the predicates that are
// linear in it.
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
// There is no identity under permutations of the arguments except those that are listed.
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

inline constexpr int kPoseAxes = 7;  // the axes of a pose

// The pose of the second base as seen from the first.
std::shared_ptr<const Construction> make_pose_2();
// The needs of the poses of a scene of bodies. Their largest degree is that of the positions plus
// twice that of the rotors of two bodies. O(coefficients).
DerivedKind pose_2_kind(const Scene& scene);
// For tests: the same rationals, computed without machine integers.
std::shared_ptr<const Construction> make_long_pose_2();

// Whose frame a line belongs to.
enum class Frame { kA, kB };

// side_a(pose, (m, h) of A, b of B')  = N (m.(t - R b) - h) times the weight of b,
// side_b(pose, (g, h) of B', a of A)  = N ((R g).(t - a) - h) times the weight of a:
// the side of the line, translated by the point, on which t lies. Positive iff t is strictly on the
// side of the outward normal. Degree in t: that of the pose. `inward`: the negated value, named
// inside_a, inside_b.
//   (1) inside_a = -side_a, inside_b = -side_b
//   (2) reversing the line, to (-m, -h), changes the sign
//   (3) a positive multiple of a line or of a point keeps the sign
std::shared_ptr<const Predicate> make_pose_side(Frame frame, bool inward);

// As make_pose_side(frame, inward), but fails at a touch too (core/arithmetic/touch.h).
std::shared_ptr<const Predicate> make_pose_touch(Frame frame, bool inward);

// along_a(pose, (m, h) of A, a, b)  = N e.(t - a - R b),      e = m turned by +90 degrees,
// along_b(pose, (g, h) of B', a, b) = N (R e).(t - a - R b),  e = g turned by +90 degrees,
// both times the weights of a and b: the position of t relative to the sum of the two points, along
// the line's direction e. Positive iff t is strictly beyond the sum in that direction. Degree in t:
// that of the pose.
//   (1) against_a = -along_a, against_b = -along_b (make_pose_along_touch)
//   (2) reversing the normal changes the sign
//   (3) h does not enter
std::shared_ptr<const Predicate> make_pose_along(Frame frame);

// As make_pose_along(frame), or its negated value (`reversed`; named against_a, against_b), but
// fails at a touch too.
std::shared_ptr<const Predicate> make_pose_along_touch(Frame frame, bool reversed);

// normal_order(pose, (m, .) of A, (g, .) of B') = (W g) x m, a positive multiple of (R g) x m.
// Positive iff the normal m of A is counter-clockwise, by less than half a turn, of the turned
// normal R g of B'. Degree in t: twice that of both rotors. `reversed`: the negated value, named
// normal_order_reversed.
//   (1) normal_order_reversed = -normal_order
//   (2) reversing one of m, g changes the sign; reversing both keeps it
//   (3) zero iff m and R g are parallel
std::shared_ptr<const Predicate> make_pose_normal_order(bool reversed);

// As make_pose_normal_order(reversed), but fails at a touch too (normals become parallel and turn
// back).
std::shared_ptr<const Predicate> make_pose_order_touch(bool reversed);

// left_of_ray(pose, a0, b0, a, b) = N (v - c) x (t - c) times the weights of the four points, with
// c = a0 + R b0 and v = a + R b; a0 and a are points of A, b0 and b of B'. The side of the ray from
// c through v on which t lies: positive iff t is strictly to the left of the line that carries the
// ray. Degree in t: that of the pose. `right`: the negated value, named right_of_ray.
//   (1) right_of_ray = -left_of_ray
//   (2) exchanging (a0, b0) and (a, b) changes the sign
//   (3) zero if (a0, b0) = (a, b)
std::shared_ptr<const Predicate> make_pose_ray(bool right);

}  // namespace kinex

#endif
