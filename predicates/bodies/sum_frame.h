// SPDX-License-Identifier: GPL-3.0-or-later
// SumFrame: the Minkowski sum of two bodies that do not turn against each other, as a polygon with a
// frame of its own.
#ifndef KINEX_PREDICATES_BODIES_SUM_FRAME_H
#define KINEX_PREDICATES_BODIES_SUM_FRAME_H

#include <memory>

#include "core/engine/kernel.h"
#include "predicates/bodies/body_frames.h"
#include "predicates/bodies/minkowski_sum.h"

namespace kinex {

struct SumFrame {
  MinkowskiSum sum;
  BodyFrame frame;
};

// The sum of A and R B' under the motions in force; `a` and `b`: the frames of A and of B'. nullptr
// if the bodies turn against each other. Exact. O(n depth) for n vertices.
std::unique_ptr<SumFrame> make_sum_frame(const Kernel& kernel, ObjectId pose, BodyFrame& a,
                                         const BodyFrame& b, CutPolicy policy);

}  // namespace kinex

#endif
