// SPDX-License-Identifier: GPL-3.0-or-later
// Trajectory kernels: a few of many points that move linearly in the plane, whose diameter is at
// least 1 - error times that of all, at all times and proven in exact arithmetic.
//
// Along a direction u a point is at slope t + height: the point (slope, height) of the dual plane.
// The extent of all at t is that of the dual points in direction (t, 1), so a subset that has at
// least 1 - error/2 of every such extent is enough for this direction:
//
//   height |     a . b            all t: the upper and the lower chain of the dual hull; chosen are
//          |   .        .         its ends, and then, where the extent of those chosen is smallest
//          |  c          d        in proportion, both extreme points, until it is large enough
//          |    .  e  .           everywhere. It is smallest at the slope of an edge.
//          +----------------- slope
//
// The union over the 2k directions of predicates/points/unit_directions.h, for the least k with
// (1 - error/2) k / sqrt(k^2 + 1) >= 1 - error, is the kernel.
//
// Cost for n points: O(k n log n) and, for each chosen point, O(h log h) for h vertices of a dual
// hull.
// Source: Agarwal, Har-Peled, Varadarajan, "Approximating extent measures of points" (2004); the
// choice of the points is a sandwich algorithm, see Rote, "The convergence rate of the sandwich
// algorithm for approximating convex functions" (1992).
#ifndef KINEX_EXPERIMENTS_FAMILIES_EXTENT_TRAJECTORY_KERNEL_H
#define KINEX_EXPERIMENTS_FAMILIES_EXTENT_TRAJECTORY_KERNEL_H

#include <string>
#include <vector>

#include "core/motion/scene.h"
#include "core/numbers/rational.h"
#include "experiments/lab/thinning.h"

namespace kinex::families {

// The errors that kernels are offered for.
Rational least_kernel_error();  // and less than 1

struct TrajectoryKernel {
  std::vector<ObjectId> objects;  // ascending
  int k = 1;                      // 2k directions
};

// Why the scene has no kernel, in words; empty if it has one.
std::string kernel_refusal(const Scene& scene);
// Requires kernel_refusal(scene) to be empty and least_kernel_error() <= error < 1.
TrajectoryKernel trajectory_kernel(const Scene& scene, const Rational& error);

// The scene with these objects only, ascending, and those that its keys refer to.
Scene only_objects(const Scene& scene, std::vector<ObjectId> objects);

// All of this for `kinex thin`.
extern const lab::Thinning kKernelThinning;

}  // namespace kinex::families

#endif
