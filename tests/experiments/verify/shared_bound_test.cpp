// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds that lie on one another in a picture.
#include "experiments/verify/shared_bound.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace kinex::verify {
namespace shared_bound_test {

using ::testing::ElementsAre;

std::vector<lab::FitPoint> bound(double factor, double exponent, const std::vector<double>& sizes) {
  std::vector<lab::FitPoint> points;
  for (const double n : sizes) points.push_back({n, factor * std::pow(n, exponent), 0});
  return points;
}

TEST(SharedBound, OneFunctionOfNAtOtherSizesIsOneBound) {
  const auto shared = shared_bounds({bound(2, 3, {4, 16, 64}),
                                     {},
                                     bound(2, 2, {4, 16, 64}),
                                     bound(2, 3, {10, 16, 100}),
                                     bound(3, 3, {4, 16, 64})});
  ASSERT_EQ(shared.size(), 3u);
  EXPECT_THAT(shared[0].families, ElementsAre(0, 3));
  std::vector<double> sizes;
  for (const lab::FitPoint& point : shared[0].points) sizes.push_back(point.n);
  EXPECT_THAT(sizes, ElementsAre(4, 10, 16, 64, 100));
  EXPECT_THAT(shared[1].families, ElementsAre(2));
  EXPECT_THAT(shared[2].families, ElementsAre(4));
}

// Sizes of one do not tell what the other is elsewhere.
TEST(SharedBound, BoundsWithoutCommonSizesAreTwo) {
  EXPECT_EQ(shared_bounds({bound(1, 2, {4, 8}), bound(1, 2, {16, 32})}).size(), 2u);
  EXPECT_EQ(shared_bounds({bound(1, 2, {4, 8}), bound(0.5, 3, {2})}).size(), 2u);
}

}  // namespace shared_bound_test
}  // namespace kinex::verify
