// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences about growth say what the intervals say, and fewer sizes say no more.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "experiments/lab/growth_words.h"

namespace kinex {
namespace growth_words_test {

using lab::FitPoint;
using lab::GrowthOrder;

// a n^b with errors of a hundredth, and a wobble of half of that.
std::vector<FitPoint> power_of(double b, std::size_t sizes) {
  std::vector<FitPoint> points;
  double n = 10;
  for (std::size_t i = 0; i < sizes; ++i, n *= 2) {
    const double count = 3 * std::pow(n, b) * (i % 2 == 0 ? 1.005 : 0.995);
    points.push_back({n, count, count / 100});
  }
  return points;
}

TEST(GrowthWords, TheWholeIntervalDecides) {
  const auto fit = lab::fit_power(power_of(0.7, 6));
  EXPECT_EQ(lab::growth_order(fit, 0.5), GrowthOrder::kFaster);
  EXPECT_EQ(lab::growth_order(fit, 0.7), GrowthOrder::kUntold);
  EXPECT_EQ(lab::growth_order(fit, 1), GrowthOrder::kSlower);
  EXPECT_EQ(lab::growth_words(fit, 0.5, "n^(1/2)"), "faster than n^(1/2)");
  EXPECT_EQ(lab::growth_words(fit, 1, "n"), "more slowly than n");
  EXPECT_EQ(lab::growth_words(fit, 0.7, "n^0.7"),
            "at a rate that these sizes do not tell from that of n^0.7");
}

TEST(GrowthWords, CarefulWordsLeaveAMargin) {
  const auto fit = lab::fit_power(power_of(0.7, 6));
  EXPECT_EQ(lab::growth_words(fit, 0.68, "n^0.68"), "faster than n^0.68");
  EXPECT_EQ(lab::growth_words(fit, 0.72, "n^0.72"), "more slowly than n^0.72");
  const std::string untold = "at a rate that these sizes do not tell from that of ";
  EXPECT_EQ(lab::careful_growth_words(fit, 0.68, "n^0.68"), untold + "n^0.68");
  EXPECT_EQ(lab::careful_growth_words(fit, 0.72, "n^0.72"), untold + "n^0.72");
  EXPECT_EQ(lab::careful_growth_words(fit, 0.6, "n^0.6"), "faster than n^0.6");
  EXPECT_EQ(lab::careful_growth_words(fit, 0.8, "n^0.8"), "more slowly than n^0.8");
  EXPECT_EQ(lab::careful_growth_words(std::nullopt, 0.6, "n^0.6"), untold + "n^0.6");
}

TEST(GrowthWords, FewSizesTellNothing) {
  EXPECT_EQ(lab::growth_order(std::nullopt, 0), GrowthOrder::kUntold);
  EXPECT_EQ(lab::growth_order(lab::fit_power(power_of(2, 3)), 0.5), GrowthOrder::kUntold);
  EXPECT_EQ(lab::growth_order(lab::fit_power(power_of(2, 4)), 0.5), GrowthOrder::kFaster);
}

TEST(GrowthWords, RatiosAreThoseOfCommonSizes) {
  const std::vector<FitPoint> under{{8, 2, 0.1}, {16, 4, 0}, {32, 0, 0}},
      over{{16, 12, 3}, {8, 4, 0.2}};
  const std::vector<FitPoint> ratio = lab::ratios(under, over);
  ASSERT_EQ(ratio.size(), 2u);
  EXPECT_DOUBLE_EQ(ratio[0].n, 8);
  EXPECT_DOUBLE_EQ(ratio[0].count, 2);
  EXPECT_NEAR(ratio[0].error, 2 * std::sqrt(0.05 * 0.05 + 0.05 * 0.05), 1e-12);
  EXPECT_DOUBLE_EQ(ratio[1].count, 3);
  EXPECT_NEAR(ratio[1].error, 0.75, 1e-12);
}

TEST(GrowthWords, OneCountIsBelowAnotherByTwoErrors) {
  const std::vector<FitPoint> low{{1, 10, 3}, {2, 10, 3}, {3, 10, 0}, {4, 10, 0}},
      high{{1, 20, 3.9}, {2, 20, 4.1}, {3, 10, 0}};
  EXPECT_EQ(lab::times_below(low, high), 1u);  // 2 * 5 > 10 but for the first
  EXPECT_EQ(lab::times_below(high, low), 0u);
}

TEST(GrowthWords, ExponentsBetweenNeighbours) {
  const std::vector<FitPoint> points{{4, 2, 0}, {8, 4, 0}, {16, 5, 0}, {32, 5, 0}};
  EXPECT_EQ(
      lab::local_exponents(points),
      "the exponent between neighbouring sizes goes from 1.00 (n = 4 to 8) to 0.00 (16 to 32)");
  EXPECT_EQ(lab::local_exponents(std::vector<FitPoint>(points.begin(), points.begin() + 2)), "");
  EXPECT_EQ(lab::local_exponents(std::vector<FitPoint>{{1, 1, 0}, {2, 0, 0}, {3, 1, 0}}), "");
}

TEST(GrowthWords, ABadFitIsSaidToBeBad) {
  std::vector<FitPoint> points = power_of(1, 6);
  EXPECT_EQ(lab::fit_text(*lab::fit_power(points)).find("too large for chance"), std::string::npos);
  EXPECT_EQ(lab::growth_order(lab::fit_power(points), 0.5), GrowthOrder::kFaster);
  points[3].count *= 1.3;
  EXPECT_EQ(lab::growth_order(lab::fit_power(points), 0), GrowthOrder::kUntold);
  EXPECT_NE(lab::fit_text(*lab::fit_power(points)).find("too large for chance"), std::string::npos);
}

}  // namespace growth_words_test
}  // namespace kinex
