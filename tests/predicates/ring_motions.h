// SPDX-License-Identifier: GPL-3.0-or-later
// Motions: random motions with the same integers in every ring that predicates are computed in.
#ifndef KINEX_TESTS_PREDICATES_RING_MOTIONS_H
#define KINEX_TESTS_PREDICATES_RING_MOTIONS_H

#include <cstddef>
#include <cstdint>
#include <random>
#include <type_traits>
#include <vector>

#include "predicates/predicates.h"

namespace kinex::test {

// The unit of predicates that have one, in every ring.
template <class R>
const R& unit_of() {
  static const R one = [] {
    if constexpr (std::is_same_v<R, MpFloat>) {
      return MpFloat(300L, Rational(1));
    } else if constexpr (std::is_same_v<R, Ball>) {
      return Ball{1, 0};
    } else {
      return R(1);
    }
  }();
  return one;
}

// Motions of `arity` objects in `axes` axes, in every ring, from the same integers.
struct Motions {
  int degree;
  std::size_t stride;
  std::vector<std::int64_t> narrow;
  std::vector<double> plain;
  std::vector<Ball> ball;
  std::vector<Integer> exact;
  std::vector<Rational> rational;
  std::vector<MpFloat> mp;

  Motions(std::mt19937_64& random, int objects, int axes, int d, std::int64_t bound)
      : degree(d), stride(static_cast<std::size_t>(axes * (d + 1))) {
    for (std::size_t i = 0; i < stride * static_cast<std::size_t>(objects); ++i) {
      const std::int64_t v =
          static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * bound + 1)) - bound;
      narrow.push_back(v);
      plain.push_back(static_cast<double>(v));
      ball.push_back({static_cast<double>(v), 0});
      exact.emplace_back(v);
      rational.emplace_back(v);
      mp.emplace_back(300L, Rational(v));
    }
  }
  template <class R>
  std::vector<MotionView<R>> views(const std::vector<R>& all, const std::vector<std::size_t>& order) const {
    std::vector<MotionView<R>> out;
    for (std::size_t i : order) out.push_back(&all[i * stride]);
    out.push_back(&unit_of<R>());
    return out;
  }
};

}  // namespace kinex::test

#endif
