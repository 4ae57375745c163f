// SPDX-License-Identifier: GPL-3.0-or-later
// Orders of insertion for static triangulations: along a curve over ranks, in rounds of doubling size
// (Amenta, Choi, Rote 2003). Only comparisons of coordinates are needed, and no order of the input is a
// bad one.
#ifndef KINEX_STRUCTURES_TRIANGULATION_CURVE_ORDER_H
#define KINEX_STRUCTURES_TRIANGULATION_CURVE_ORDER_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "core/engine/kernel.h"

namespace kinex {

// A point with its places in the orders along the axes.
template <std::size_t kAxes>
struct RankedPoint {
  std::array<std::uint32_t, kAxes> rank{};  // right after now; equal iff identically equal
  ObjectId id = kNoObject;
  friend bool operator<(const RankedPoint& a, const RankedPoint& b) {
    return std::tie(a.rank, a.id) < std::tie(b.rank, b.id);
  }
};

// The points with their ranks along the axes of these orders, ascending. O(n log n) signs.
template <std::size_t kAxes>
std::vector<RankedPoint<kAxes>> ranked(Kernel& kernel, const std::array<PredicateId, kAxes>& orders,
                                       std::span<const ObjectId> points);

// Their ids in the order of insertion: a point is in the last round with probability 1/2, in the one
// before with 1/4, and so on; each round follows the curve. The same points give the same order.
template <std::size_t kAxes>
std::vector<ObjectId> order_along_curve(std::span<const RankedPoint<kAxes>> points);

}  // namespace kinex

#endif
