// SPDX-License-Identifier: GPL-3.0-or-later
// The number of balls that cover the relative motion of two bodies, each small relative to the
// separation at its centre. It bounds the events of a proof that withstands a constant fraction of
// the separation (structures/collision/separation_hysteresis.h), however jagged the motion.
#ifndef KINEX_EXPERIMENTS_FAMILIES_COLLISION_BALL_COVER_H
#define KINEX_EXPERIMENTS_FAMILIES_COLLISION_BALL_COVER_H

#include <cstdint>

#include "core/motion/scene.h"

namespace kinex::families {

// A ball's radius over the separation at its centre. A proof made anywhere in a ball that
// withstands c times the separation there holds in all of the ball if the radius is at most c / (2
// + c): for c = 0.23 a little more than this.
inline constexpr double kBallRadius = 0.103;

// The number of consecutive pieces into which the motion of the second body against the first is
// cut, each inside a ball; at least as many as the fewest possible. With theta the angle between
// the bodies, t the second body's origin in the first one's frame, t' the same in the second one's
// frame, and rho the farthest vertex from a body's origin, the metric is
//   max(|dt| + rho_2 |d theta|, |dt'| + rho_1 |d theta|).
// The separation changes by no more than that.
//
// Computed in doubles, at samples at most 1/64 of the separation apart. A ball must hold its
// samples with that margin, so that it holds the path between them. Greedy: each piece extends as
// far as a ball can be found. Cost: O(n_a n_b) per sample, vertices against edges. Requires two
// polygons that exist from the start of the scene to its end and keep a distance well above the
// rounding errors.
std::uint64_t ball_cover(const Scene& scene);

}  // namespace kinex::families

#endif
