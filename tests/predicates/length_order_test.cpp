// SPDX-License-Identifier: GPL-3.0-or-later
// Orders of lengths are |u|^2 - |v|^2 for the differences that they name (LengthOrder).
#include "core/arithmetic/length_order.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <numeric>
#include <random>
#include <vector>

#include "predicates/predicates.h"
#include "tests/predicates/ring_motions.h"

namespace kinex {
namespace length_order_test {

// |to - from|^2.
std::vector<Rational> squared_length(const Rational* to, const Rational* from, int axes,
                                     int degree) {
  const auto powers = static_cast<std::size_t>(degree) + 1;
  std::vector<Rational> square(2 * powers - 1);
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(axes); ++axis) {
    const std::size_t first = axis * powers;
    for (std::size_t i = 0; i < powers; ++i) {
      for (std::size_t j = 0; j < powers; ++j) {
        square[i + j] += (to[first + i] - from[first + i]) * (to[first + j] - from[first + j]);
      }
    }
  }
  return square;
}

TEST(LengthOrder, NamesTheEndsOfBothLengths) {
  std::mt19937_64 random(1);
  for (int axes = 1; axes <= 3; ++axes) {
    for (const auto& predicate :
         {make_squared_distance_order(axes), make_pair_distance_order(axes)}) {
      const auto* const order = dynamic_cast<const LengthOrder*>(predicate.get());
      ASSERT_NE(order, nullptr) << predicate->name();
      const LengthEnds ends = order->length_ends();
      EXPECT_EQ(ends.share_an_end(), predicate->arity() == 3);
      for (int degree = 1; degree <= 3; ++degree) {
        const test::Motions motions(random, predicate->arity(), axes, degree, 1000);
        std::vector<std::size_t> as_given(static_cast<std::size_t>(predicate->arity()));
        std::iota(as_given.begin(), as_given.end(), std::size_t{0});
        const auto views = motions.views(motions.rational, as_given);
        const auto longer =
            squared_length(views[ends.longer_to], views[ends.longer_from], axes, degree);
        const auto shorter =
            squared_length(views[ends.shorter_to], views[ends.shorter_from], axes, degree);
        const std::vector<Rational> value = predicate->rational(degree, views.data());
        ASSERT_EQ(value.size(), longer.size());
        for (std::size_t k = 0; k < value.size(); ++k) EXPECT_EQ(value[k], longer[k] - shorter[k]);
      }
    }
  }
}

}  // namespace length_order_test
}  // namespace kinex
