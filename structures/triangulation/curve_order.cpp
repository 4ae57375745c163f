// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/curve_order.h"

#include <algorithm>
#include <random>

#include "structures/parts/merge_sort.h"

namespace kinex {
namespace {

// Ranks along an axis.
std::vector<std::uint32_t> ranks(Kernel& kernel, PredicateId order,
                                 std::span<const ObjectId> points) {
  std::vector<std::uint32_t> sorted(points.size());
  for (std::uint32_t i = 0; i < sorted.size(); ++i) sorted[i] = i;
  merge_sort(sorted, [&](std::uint32_t a, std::uint32_t b) {
    return kernel.sign_after(order, {points[a], points[b]}) == Sign::kPositive;
  });
  std::vector<std::uint32_t> rank(points.size(), 0);
  std::uint32_t current = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    const ObjectId a = points[sorted[i - 1]], b = points[sorted[i]];
    if (kernel.sign_after(order, {a, b}) != Sign::kZero) ++current;
    rank[sorted[i]] = current;
  }
  return rank;
}

// Bit k of x goes to bit `axes` k.
std::uint64_t spread(std::uint64_t x, unsigned axes) {
  std::uint64_t result = 0;
  for (unsigned k = 0; k < 16; ++k) result |= (x >> k & 1) << (axes * k);
  return result;
}

}  // namespace

template <std::size_t kAxes>
std::vector<RankedPoint<kAxes>> ranked(Kernel& kernel, const std::array<PredicateId, kAxes>& orders,
                                       std::span<const ObjectId> points) {
  std::vector<RankedPoint<kAxes>> all(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) all[i].id = points[i];
  for (std::size_t k = 0; k < kAxes; ++k) {
    const std::vector<std::uint32_t> rank = ranks(kernel, orders[k], points);
    for (std::size_t i = 0; i < all.size(); ++i) all[i].rank[k] = rank[i];
  }
  std::sort(all.begin(), all.end());
  return all;
}

template <std::size_t kAxes>
std::vector<ObjectId> order_along_curve(std::span<const RankedPoint<kAxes>> points) {
  struct Turn {
    ObjectId id;
    std::uint64_t round = 40, place = 0;
  };
  std::array<std::uint64_t, kAxes> most{};
  for (const RankedPoint<kAxes>& point : points) {
    for (std::size_t k = 0; k < kAxes; ++k) {
      most[k] = std::max<std::uint64_t>(most[k], point.rank[k] + std::uint64_t{1});
    }
  }
  std::mt19937_64 engine(20240607);
  std::vector<Turn> turns;
  for (const RankedPoint<kAxes>& point : points) {
    Turn turn{point.id};
    for (std::uint64_t bits = engine(); (bits & 1) != 0 && turn.round != 0; bits >>= 1) {
      --turn.round;
    }
    for (std::size_t k = 0; k < kAxes; ++k) {
      turn.place |= spread(point.rank[k] * std::uint64_t{0xffff} / most[k], kAxes) << k;
    }
    turns.push_back(turn);
  }
  std::sort(turns.begin(), turns.end(), [](const Turn& a, const Turn& b) {
    return std::tie(a.round, a.place, a.id) < std::tie(b.round, b.place, b.id);
  });
  std::vector<ObjectId> order;
  for (const Turn& turn : turns) order.push_back(turn.id);
  return order;
}

template std::vector<RankedPoint<2>> ranked(Kernel&, const std::array<PredicateId, 2>&,
                                            std::span<const ObjectId>);
template std::vector<RankedPoint<3>> ranked(Kernel&, const std::array<PredicateId, 3>&,
                                            std::span<const ObjectId>);
template std::vector<ObjectId> order_along_curve(std::span<const RankedPoint<2>>);
template std::vector<ObjectId> order_along_curve(std::span<const RankedPoint<3>>);

}  // namespace kinex
