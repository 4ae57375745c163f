// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/range/dual_points.h"

#include <algorithm>
#include <array>

#include "predicates/predicates.h"

namespace kinex {
namespace {

Key coordinate(int axis) {
  Key key;
  key.kind = Key::Kind::kCoordinate;
  key.axis = axis;
  return key;
}

}  // namespace

DualPoints::DualPoints(Kernel& kernel, int axis, int dimension)
    : kernel_(&kernel),
      axis_(axis),
      slope_order_(kernel.bind(make_line_slope_order(coordinate(axis), dimension))),
      turn_(kernel.bind(make_line_turn(coordinate(axis), dimension))),
      order_(kernel.bind(make_coordinate_order(axis))) {}

Sign DualPoints::turn(ObjectId a, ObjectId b, ObjectId c) const {
  return kernel_->sign_after(turn_, {a, b, c});
}

bool DualPoints::same(ObjectId a, ObjectId b) const {
  return kernel_->sign_after(order_, {a, b}) == Sign::kZero;
}

bool DualPoints::precedes(ObjectId a, ObjectId b) const {
  Sign sign = kernel_->sign_after(slope_order_, {a, b});
  // Of parallel lines the order is that of their heights, at any time.
  if (sign == Sign::kZero) sign = kernel_->sign_after(order_, {a, b});
  return sign == Sign::kZero ? a < b : sign == Sign::kPositive;
}

// Three points p, q, r on a line, in their order: a move of p or of r upwards makes them turn to the
// left, one of q to the right. The largest move decides. Of two points that coincide, and a third
// one elsewhere, the move of the third counts less: it is multiplied by the distance of the two.
bool DualPoints::is_left(ObjectId a, ObjectId b, ObjectId c) const {
  const Sign sign = turn(a, b, c);
  if (sign != Sign::kZero) return sign == Sign::kPositive;
  std::array<ObjectId, 3> p{a, b, c};
  bool is_odd = false;
  const auto order = [&](std::size_t i, std::size_t j) {
    if (!precedes(p[j], p[i])) return;
    std::swap(p[i], p[j]);
    is_odd = !is_odd;
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  const bool first = same(p[0], p[1]), second = same(p[1], p[2]);
  bool left = p[1] > std::min(p[0], p[2]);
  if (first != second) left = first ? p[0] < p[1] : p[2] < p[1];
  return left != is_odd;
}

}  // namespace kinex
