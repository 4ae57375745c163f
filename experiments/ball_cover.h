// SPDX-License-Identifier: GPL-3.0-or-later
// How many balls cover the relative motion of two bodies, each small against the separation at its
// centre: a bound on what a proof costs that withstands a constant fraction of the separation
// (structures/separation_hysteresis.h), however jagged the motion is.
#ifndef KINEX_EXPERIMENTS_BALL_COVER_H
#define KINEX_EXPERIMENTS_BALL_COVER_H

#include <cstdint>

#include "core/scene.h"

namespace kinex {

// A ball's radius, of the separation at its centre. What is made anywhere in a ball and withstands
// c times the separation there holds in all of it if the radius is at most c / (2 + c): for c =
// 0.23 a little more than this.
inline constexpr double kBallRadius = 0.103;

// The number of consecutive pieces into which the motion of the second body against the first is
// cut, each inside a ball; at least as many as the fewest possible. With theta the angle between
// the bodies, t the second body's origin in the first one's frame, t' the same in the second one's
// frame, and rho the farthest vertex from a body's origin, the metric is
//   max(|dt| + rho_2 |d theta|, |dt'| + rho_1 |d theta|).
// The separation changes by no more than that.
//
// In doubles, at samples that are no farther apart than 1/64 of the separation; a ball must hold
// its samples with that much to spare, so that it holds what is between them. Greedy: each piece
// goes on as far as a ball can be found. Vertices against edges: O(n_a n_b) a sample. Requires two
// bodies, polygons, that live from the start of the scene to its end and keep a distance well above
// the rounding of doubles.
std::uint64_t ball_cover(const Scene& scene);

}  // namespace kinex

#endif
