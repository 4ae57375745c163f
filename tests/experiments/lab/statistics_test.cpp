// SPDX-License-Identifier: GPL-3.0-or-later
// Statistics of the experiments, on constructed data with known answers.
#include "experiments/lab/statistics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "experiments/families/points/uniform_lines.h"
#include "experiments/lab/fit.h"
#include "experiments/lab/judge.h"

namespace kinex {
namespace statistics_test {

using ::testing::DoubleNear;
using ::testing::Each;

TEST(RunningMean, IsThatOfTheTextbook) {
  lab::RunningMean mean;
  for (const double value : {2, 4, 4, 4, 5, 5, 7, 9}) mean.add(value);
  EXPECT_EQ(mean.count(), 8u);
  EXPECT_DOUBLE_EQ(mean.mean(), 5);
  EXPECT_DOUBLE_EQ(mean.deviation(), std::sqrt(32.0 / 7));
  EXPECT_DOUBLE_EQ(mean.standard_error(), std::sqrt(32.0 / 7 / 8));
  EXPECT_EQ(mean.smallest(), 2);
  EXPECT_EQ(mean.largest(), 9);
}

TEST(RunningMean, KeepsSmallSpreadsOfLargeValues) {
  lab::RunningMean mean;
  for (const double value : {1e15 + 1, 1e15 + 2, 1e15 + 3}) mean.add(value);
  EXPECT_DOUBLE_EQ(mean.deviation(), 1);
}

TEST(RunningMean, HasNoErrorForOneValue) {
  lab::RunningMean mean;
  mean.add(3);
  EXPECT_EQ(mean.standard_error(), 0);
}

TEST(Distance, IsInErrorsOfTheDifferenceBeyondTheTolerance) {
  EXPECT_DOUBLE_EQ(lab::distance_in_errors(15, 3, 5, 4, 0), 2);
  EXPECT_DOUBLE_EQ(lab::distance_in_errors(5, 3, 15, 4, 5), 1);
  EXPECT_EQ(lab::distance_in_errors(5, 0, 5.5, 0, 0.5), 0);
  EXPECT_EQ(lab::distance_in_errors(5, 0, 6, 0, 0.5), std::numeric_limits<double>::infinity());
}

TEST(AllowedErrors, IsTwoForOneAndGrowsSlowly) {
  EXPECT_DOUBLE_EQ(lab::allowed_errors(1), 2);
  // All of k agree as often as one alone: erf(z / sqrt 2)^k = erf(2 / sqrt 2).
  for (const int k : {2, 6, 20}) {
    const double z = lab::allowed_errors(k);
    EXPECT_NEAR(std::pow(std::erf(z / std::sqrt(2)), k), std::erf(std::sqrt(2)), 1e-12) << k;
  }
  EXPECT_NEAR(lab::allowed_errors(6), 2.66, 0.01);
}

TEST(FitPower, FindsAnExactPower) {
  std::vector<lab::FitPoint> points;
  for (const double n : {10, 20, 40, 80}) points.push_back({n, 3 * std::pow(n, 1.5), 0});
  const std::optional<lab::Fit> fit = lab::fit_power(points);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->b, 1.5, 1e-12);
  EXPECT_NEAR(fit->a, 3, 1e-11);
  EXPECT_NEAR(fit->lower, 1.5, 1e-6);
  EXPECT_NEAR(fit->upper, 1.5, 1e-6);
  EXPECT_EQ(fit->degrees, 2);
  EXPECT_THAT(fit->residuals, Each(DoubleNear(0, 1e-12)));
}

// By hand: x = -1, 0, 1 and y = -1, 0.3, 1 with equal weights 1 / s^2: slope 1, offset 0.1.
TEST(FitPower, AgreesWithAFitByHand) {
  const double s = 0.5;
  std::vector<lab::FitPoint> points;
  for (const auto& [x, y] : {std::pair(-1.0, -1.0), {0.0, 0.3}, {1.0, 1.0}}) {
    points.push_back({std::exp(x), std::exp(y), s * std::exp(y)});
  }
  const std::optional<lab::Fit> fit = lab::fit_power(points);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->b, 1, 1e-12);
  EXPECT_NEAR(std::log(fit->a), 0.1, 1e-12);
  EXPECT_NEAR(fit->chi_square, (0.01 + 0.04 + 0.01) / (s * s), 1e-12);
  EXPECT_NEAR(fit->b_error, s / std::sqrt(2), 1e-12);
  const double quantile = 12.7062047364;  // Student's t, 97.5 %, one degree
  EXPECT_NEAR(fit->upper - fit->b, quantile * s / std::sqrt(2), 1e-8);
  EXPECT_NEAR(fit->b - fit->lower, quantile * s / std::sqrt(2), 1e-8);
}

TEST(FitPower, GivesPrecisePointsMoreWeight) {
  const std::vector<lab::FitPoint> points{{1, 1, 0.01}, {10, 10, 0.1}, {100, 500, 500}};
  const std::optional<lab::Fit> fit = lab::fit_power(points);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->b, 1, 0.01);
}

// Small errors must not hide that the points lie on a curve.
TEST(FitPower, WidensTheIntervalWherePointsScatterMoreThanTheirErrors) {
  std::vector<lab::FitPoint> straight, curved;
  for (const double n : {16, 64, 256, 1024, 4096}) {
    straight.push_back({n, n * n, n * n * 1e-3});
    const double count = n * n * (1 + 2 / std::sqrt(n));
    curved.push_back({n, count, count * 1e-3});
  }
  const auto width = [](const std::vector<lab::FitPoint>& points) {
    const std::optional<lab::Fit> fit = lab::fit_power(points);
    return fit->upper - fit->lower;
  };
  EXPECT_GT(width(curved), 10 * width(straight));
}

TEST(FitPower, CoversTheTrueExponentAsOftenAsItSays) {
  std::mt19937_64 engine(42);
  const auto uniform = [&] { return (static_cast<double>(engine() >> 11) + 0.5) * 0x1p-53; };
  const auto normal = [&] {
    return std::sqrt(-2 * std::log(uniform())) * std::cos(2 * M_PI * uniform());
  };
  int covered = 0;
  constexpr int kRounds = 2000;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<lab::FitPoint> points;
    for (const double n : {50, 100, 200, 400, 800, 1600}) {
      const double count = 1.8 * std::pow(n, 1.5);
      points.push_back({n, count * (1 + 0.02 * normal()), 0.02 * count});
    }
    const std::optional<lab::Fit> fit = lab::fit_power(points);
    if (fit->lower <= 1.5 && 1.5 <= fit->upper) ++covered;
  }
  EXPECT_GE(covered, kRounds * 0.95);
  EXPECT_LE(covered, kRounds * 0.999);
}

TEST(CompareWithClaim, AllSomeOrNoneOfTheInterval) {
  const auto says = [](double lower, double upper, bool at_most) {
    return lab::compare_with_claim(lower, upper, 2, 0.1, at_most);
  };
  for (const bool at_most : {false, true}) {
    EXPECT_EQ(says(1.95, 2.05, at_most), lab::Verdict::kConfirmed);
    EXPECT_EQ(says(1.9, 2.1, at_most), lab::Verdict::kConfirmed);
    EXPECT_EQ(says(1.95, 2.2, at_most), lab::Verdict::kOpen);
    EXPECT_EQ(says(0, 9, at_most), lab::Verdict::kOpen);
    EXPECT_EQ(says(2.2, 2.3, at_most), lab::Verdict::kRefuted);
    EXPECT_EQ(says(std::nan(""), std::nan(""), at_most), lab::Verdict::kOpen);
  }
  EXPECT_EQ(says(1.5, 1.6, false), lab::Verdict::kRefuted);
  EXPECT_EQ(says(1.5, 1.6, true), lab::Verdict::kConfirmed);
  EXPECT_EQ(says(1.5, 2, false), lab::Verdict::kOpen);
  // A wider interval never says more.
  for (double middle = 1.7; middle < 2.3; middle += 0.01) {
    for (double half = 0.01; half < 0.5; half *= 1.5) {
      const lab::Verdict narrow = says(middle - half, middle + half, false);
      const lab::Verdict wide = says(middle - 1.5 * half, middle + 1.5 * half, false);
      EXPECT_TRUE(wide == narrow || wide == lab::Verdict::kOpen) << middle << " " << half;
    }
  }
}

TEST(FitPower, RefusesWhatCannotBeFitted) {
  const std::vector<lab::FitPoint> two{{1, 1, 0}, {2, 2, 0}};
  EXPECT_FALSE(lab::fit_power(two));
  const std::vector<lab::FitPoint> zero{{1, 1, 0}, {2, 0, 0}, {3, 3, 0}};
  EXPECT_FALSE(lab::fit_power(zero));
  const std::vector<lab::FitPoint> same{{5, 1, 0}, {5, 2, 0}, {5, 3, 0}};
  EXPECT_FALSE(lab::fit_power(same));
}

TEST(UniformLines, ExpectedChangesAreThoseFoundOtherwise) {
  EXPECT_EQ(families::expected_envelope_changes(1), 0);
  EXPECT_NEAR(families::expected_envelope_changes(2), 0.5, 1e-10);  // two orders, independent
  EXPECT_NEAR(families::expected_envelope_changes(3), 0.75, 1e-10);
  // Two million random sets of 4 and of 16 lines: standard errors 0.0005 and 0.0007.
  EXPECT_NEAR(families::expected_envelope_changes(4), 0.9245, 0.0015);
  EXPECT_NEAR(families::expected_envelope_changes(16), 1.7915, 0.0021);
}

TEST(UniformLines, TournamentOfTwoIsOnePair) {
  EXPECT_NEAR(families::expected_tournament_failures(2), 0.5, 1e-10);
  // Four lines: the two pairs, and two thirds of the changes of all four.
  EXPECT_NEAR(families::expected_tournament_failures(4), 1 + families::expected_envelope_changes(4) * 2 / 3, 1e-10);
  EXPECT_THROW(families::expected_tournament_failures(6), std::invalid_argument);
}

TEST(Texts, GiveErrorsTwoDigits) {
  EXPECT_EQ(lab::mean_text(586.4, 6.04), "586.4 +-6.0");
  EXPECT_EQ(lab::mean_text(116962, 832), "116962 +-832");
  EXPECT_EQ(lab::mean_text(5.4679, 0.031), "5.468 +-0.031");
  EXPECT_EQ(lab::mean_text(17, 0), "17");
  EXPECT_EQ(lab::number_text(1.79172, 4), "1.792");
}

}  // namespace statistics_test
}  // namespace kinex
