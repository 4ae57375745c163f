// SPDX-License-Identifier: GPL-3.0-or-later
// Predicates on discs and boxes, whose motions have their extents as further axes (Scene::extents).
// The terms are those of predicates/predicates.h. h is the half extent of an object along an axis:
// of a box the one of that axis, of a disc its radius. Positions enter as differences, extents by
// value.
#ifndef KINEX_PREDICATES_POINTS_EXTENT_PREDICATES_H
#define KINEX_PREDICATES_POINTS_EXTENT_PREDICATES_H

#include <cstdint>
#include <memory>

#include "core/arithmetic/predicate.h"

namespace kinex {

// The axes that a claim about ends reads.
struct EndAxes {
  int axis;        // of the position
  int extent;      // of the half extent, among all axes of the motion
  int dimension;   // axes of a position: those behind them are extents
};

// See make_end_order.
enum class EndClaim : std::uint8_t { kLowerEnds, kUpperEnds, kMeeting, kApart };
// The order of two ends of the intervals that two objects cover on an axis (named after it, as in
// lower_ends_x). Degree 1 in the coordinates.
//   kLowerEnds  (x_b - h_b) - (x_a - h_a): the lower end of a is in front of that of b
//   kUpperEnds  (x_b + h_b) - (x_a + h_a): the upper end of a is in front of that of b
//   kMeeting    (x_b + h_b) - (x_a - h_a): the lower end of a is in front of the upper end of b
//   kApart      (x_a - h_a) - (x_b + h_b): the upper end of b is in front of the lower end of a
//   (1) kLowerEnds and kUpperEnds alternate
//   (2) kApart(a, b) = -kMeeting(a, b)
//   (3) the intervals of a and b meet iff kMeeting(a, b) >= 0 and kMeeting(b, a) >= 0
std::shared_ptr<const Predicate> make_end_order(EndClaim claim, const EndAxes& axes);

// half_width(a) = h_a on an axis (named half_width_x, half_width_y, half_width_z): the lower end of
// a is in front of its upper end. no_width(a) is its negation. Degree 1 in the coordinates. They take
// the place of end orders that would name one object twice.
//   (1) no_width(a) = -half_width(a)
//   (2) the value does not depend on the position of a
//   (3) with the claims of make_end_order: kMeeting(a, a) = 2 half_width(a), kApart(a, a) =
//       2 no_width(a), and kLowerEnds(a, a) = kUpperEnds(a, a) = 0
std::shared_ptr<const Predicate> make_half_width(const EndAxes& axes);
// See make_half_width.
std::shared_ptr<const Predicate> make_no_width(const EndAxes& axes);

// disc_overlap(a, b) = (r_a + r_b)^2 - |b - a|^2 in `dimension` axes, 1 to 3, and disc_apart(a, b),
// its negation. For radii that are not negative, disc_overlap is >= 0 iff the closed discs meet.
// Degree 2 in the coordinates.
//   (1) value(b, a) = value(a, b)
//   (2) disc_overlap(a, a) >= 0
//   (3) with f(p) = |p|^2 - r^2 of a disc of centre p: disc_overlap >= 0 iff no point of the segment
//       from (a, f(a)) to (b, f(b)) is strictly above the paraboloid z = |p|^2
std::shared_ptr<const Predicate> make_disc_overlap(int dimension);
// See make_disc_overlap.
std::shared_ptr<const Predicate> make_disc_apart(int dimension);

}  // namespace kinex

#endif
