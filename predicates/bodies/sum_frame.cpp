// SPDX-License-Identifier: GPL-3.0-or-later
#include "predicates/bodies/sum_frame.h"

#include <utility>

namespace kinex {

std::unique_ptr<SumFrame> make_sum_frame(const Kernel& kernel, ObjectId pose, BodyFrame& a,
                                         const BodyFrame& b, CutPolicy policy) {
  auto sum = minkowski_sum(a.hierarchy().polygon(), b.hierarchy().polygon(),
                           kernel.derived().trajectory(pose));
  if (!sum) return nullptr;
  BodyFrame frame(OuterHierarchy(sum->polygon, policy), a.constants());
  return std::make_unique<SumFrame>(SumFrame{std::move(*sum), std::move(frame)});
}

}  // namespace kinex
