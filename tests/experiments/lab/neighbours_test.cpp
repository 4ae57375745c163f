// SPDX-License-Identifier: GPL-3.0-or-later
// Laws against their neighbours, on made-up counts of known laws (seeds fixed).
#include "experiments/lab/neighbours.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "experiments/lab/law_verdict.h"
#include "experiments/lab/least_squares.h"

namespace kinex {
namespace neighbours_test {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

std::vector<lab::FitPoint> points_of(const std::function<double(double)>& law, double noise,
                                     double error) {
  std::mt19937_64 engine(7);
  const auto uniform = [&] { return (static_cast<double>(engine() >> 11) + 0.5) * 0x1p-53; };
  std::vector<lab::FitPoint> points;
  for (int k = 0; k < 10; ++k) {
    const double n = 16 * std::pow(2, k), count = law(n);
    const double off = std::sqrt(-2 * std::log(uniform())) * std::cos(2 * M_PI * uniform());
    points.push_back({n, count * (1 + noise * off), error * count});
  }
  return points;
}

TEST(Law, IsWrittenAsOneWritesIt) {
  EXPECT_EQ((lab::Law{1, 0}.text("n")), "n");
  EXPECT_EQ((lab::Law{1.5, 0}.text("n")), "n^1.5");
  EXPECT_EQ((lab::Law{1, 1}.text("n")), "n log n");
  EXPECT_EQ((lab::Law{0, 2}.text("n")), "log^2 n");
  EXPECT_DOUBLE_EQ((lab::Law{1.5, 2}.at(100)), 1000 * std::pow(std::log(100.0), 2));
}

// Of a bound O(log n): what grows like log n or slower is confirmed, log^2 n and powers are not; and fewer
// sizes never confirm more.
TEST(LawVerdict, TellsABoundFromWhatExceedsIt) {
  const lab::ClaimedLaw claim{{0, 1}, 0.1, true};
  const auto verdict = [&](const std::function<double(double)>& law, std::size_t sizes) {
    std::vector<lab::FitPoint> points = points_of(law, 0.002, 0);
    points.resize(sizes);
    return lab::judge_law(points, claim, "n");
  };
  const auto log = [](double n) { return 5 + 3 * std::log(n); };
  EXPECT_EQ(verdict(log, 10).verdict, lab::Verdict::kConfirmed);
  EXPECT_THAT(lab::neighbours_text(*verdict(log, 10).neighbours), HasSubstr("which has"));
  EXPECT_EQ(verdict(log, 5).verdict, lab::Verdict::kOpen);
  EXPECT_THAT(verdict(log, 5).observed, HasSubstr("too few sizes"));
  for (const auto& law : {std::function<double(double)>([](double n) { return std::pow(std::log(n), 3); }),
                          std::function<double(double)>([](double n) { return std::sqrt(n); })}) {
    lab::Verdict last = lab::Verdict::kRefuted;
    for (const std::size_t sizes : {std::size_t{10}, std::size_t{7}, std::size_t{6}, std::size_t{5}}) {
      const lab::Verdict one = verdict(law, sizes).verdict;
      EXPECT_NE(one, lab::Verdict::kConfirmed) << sizes;
      EXPECT_LE(one, last) << sizes;
      last = one;
    }
  }
}

// A power so small that a logarithm is within the tolerance of its bend: no bound O(log n) is confirmed by it, at no
// number of sizes and with no noise; and a logarithm is not where noise hides what it is.
TEST(LawVerdict, ABoundMustBeatWhatGrowsFaster) {
  const lab::ClaimedLaw claim{{0, 1}, 0.1, true};
  const auto judged = [&](const std::function<double(double)>& law, double noise, double error, std::size_t sizes) {
    std::vector<lab::FitPoint> points = points_of(law, noise, error);
    points.resize(sizes);
    return lab::judge_law(points, claim, "n");
  };
  const auto power = [](double n) { return 40 * std::pow(n, 0.15); };
  for (const double noise : {0.0, 0.002, 0.02}) {
    for (const double error : {0.0, 0.02}) {
      for (std::size_t sizes = 6; sizes <= 10; ++sizes) {
        EXPECT_NE(judged(power, noise, error, sizes).verdict, lab::Verdict::kConfirmed)
            << noise << " " << error << " " << sizes;
      }
    }
  }
  const lab::LawVerdict few = judged(power, 0.02, 0.02, 6);
  std::vector<lab::FitPoint> first_six = points_of(power, 0.02, 0.02);
  first_six.resize(6);
  const std::optional<lab::Bend> bend = lab::bend_of(first_six, claim.law);
  EXPECT_LT(bend->upper, claim.tolerance) << "the bend alone would confirm it";
  EXPECT_EQ(few.verdict, lab::Verdict::kOpen);
  EXPECT_THAT(few.observed, HasSubstr(", and a law that grows faster cannot be excluded"));

  const auto log = [](double n) { return 40 + 3 * std::log(n); };
  EXPECT_EQ(judged(log, 0.002, 0.002, 10).verdict, lab::Verdict::kConfirmed);
  EXPECT_EQ(judged(log, 0.02, 0.02, 10).verdict, lab::Verdict::kOpen);
  // What hardly grows is bounded by every law; what may grow is not.
  const auto constant = [](double) { return 40.0; };
  const lab::LawVerdict flat = judged(constant, 0.002, 0.002, 10);
  EXPECT_EQ(flat.verdict, lab::Verdict::kConfirmed);
  EXPECT_THAT(flat.observed, HasSubstr(", like n^0.00"));
  EXPECT_EQ(judged(constant, 0.1, 0.1, 10).verdict, lab::Verdict::kOpen);
}

// A bound is not in doubt where a slower law fits best: log n under O(log^2 n).
TEST(LawVerdict, ABoundMayBeFarAbove) {
  const auto points = points_of([](double n) { return 5 + 3 * std::log(n); }, 0.001, 0.001);
  const lab::LawVerdict bound = lab::judge_law(points, {{0, 2}, 0.1, true}, "n");
  EXPECT_EQ(bound.verdict, lab::Verdict::kConfirmed) << bound.observed;
  EXPECT_TRUE(bound.neighbours->is_beaten());
  EXPECT_TRUE(bound.neighbours->beats_faster());
  EXPECT_EQ(lab::judge_law(points, {{0, 2}, 0.1}, "n").verdict, lab::Verdict::kOpen);  // of the law itself
}

TEST(Neighbours, EachLawBeatsAllOthersOnItsOwnCounts) {
  for (const double power : {0.0, 1.0, 1.5}) {
    for (int logs = power == 0 ? 1 : 0; logs <= 3; ++logs) {
      const lab::Law law{power, logs};
      const auto points = points_of([&](double n) { return 5 + 3 * law.at(n); }, 0.002, 0.002);
      const auto found = lab::neighbours_of(points, law, "n");
      ASSERT_TRUE(found);
      EXPECT_TRUE(found->weighted);
      EXPECT_TRUE(found->beats_all()) << lab::neighbours_text(*found);
      EXPECT_FALSE(found->is_beaten());
      EXPECT_EQ(found->rivals.size(), (power == 0 ? 2u : 3u) + (logs > 0 ? 1u : 0u));
      EXPECT_THAT(lab::neighbours_text(*found), StartsWith("consistent with " + law.text("n")));
      EXPECT_THAT(lab::neighbours_text(*found), HasSubstr(" chi squared"));
      // Another law is beaten by it.
      const lab::Law wrong{power, logs == 3 ? 2 : logs + 1};
      const auto beaten = lab::neighbours_of(points, wrong, "n");
      EXPECT_TRUE(beaten->is_beaten()) << lab::neighbours_text(*beaten);
      EXPECT_THAT(lab::neighbours_text(*beaten), HasSubstr("is not the best of its neighbours"));
    }
  }
}

TEST(Neighbours, OfNoiseNothingCanBeTold) {
  const auto points = points_of([](double n) { return 5 + std::log(n); }, 0.3, 0.3);
  const auto found = lab::neighbours_of(points, {0, 1}, "n");
  EXPECT_FALSE(found->beats_all());
  EXPECT_FALSE(found->is_beaten());
  EXPECT_THAT(lab::neighbours_text(*found), HasSubstr("cannot be told from log^2 n"));
}

// By how much, in chi squared where there are errors, else in scatter.
TEST(Neighbours, TheLeadIsThatOfTheTwoFits) {
  auto points = points_of([](double n) { return 5 + 2 * std::pow(std::log(n), 2); }, 0.01, 0.01);
  const auto with_errors = lab::neighbours_of(points, {0, 2}, "n");
  for (const auto& rival : with_errors->rivals) {
    EXPECT_DOUBLE_EQ(rival.lead, rival.fit.chi_square - with_errors->claimed.chi_square);
  }
  EXPECT_EQ(with_errors->rivals.back().law, "a power of n");
  EXPECT_DOUBLE_EQ(with_errors->rivals.back().fit.chi_square, lab::fit_power(points)->chi_square);
  for (lab::FitPoint& point : points) point.error = 0;
  const auto without = lab::neighbours_of(points, {0, 2}, "n");
  EXPECT_FALSE(without->weighted);
  for (const auto& rival : without->rivals) {
    EXPECT_DOUBLE_EQ(rival.lead, rival.scatter / without->scatter);
  }
  EXPECT_THAT(lab::neighbours_text(*without), HasSubstr("times the scatter"));
  EXPECT_THAT(lab::neighbours_text(*without), Not(HasSubstr("chi squared")));
}

// Without errors: twice the scatter is worse, half of it better, and what is between is undecided.
TEST(Neighbours, WithoutErrorsTheScatterDecides) {
  const auto log_squared = [](double n) { return 5 + 2 * std::pow(std::log(n), 2); };
  const auto exact = points_of(log_squared, 0, 0);
  EXPECT_TRUE(lab::neighbours_of(exact, {0, 2}, "n")->beats_all());
  const auto wrong = lab::neighbours_of(exact, {0, 1}, "n");
  EXPECT_TRUE(wrong->is_beaten());
  EXPECT_THAT(lab::neighbours_text(*wrong), HasSubstr("is beaten by log^2 n, which has"));
  const auto noise = lab::neighbours_of(points_of(log_squared, 0.3, 0), {0, 2}, "n");
  EXPECT_FALSE(noise->is_beaten());
  EXPECT_FALSE(noise->beats_all());
  for (const auto& rival : noise->rivals) {
    EXPECT_EQ(rival.better, rival.lead >= 2 ? lab::BetterFit::kFirst : lab::BetterFit::kNeither)
        << rival.law << " " << rival.lead;
  }
}

TEST(Neighbours, CountsThatLieOnTheLawHaveAFiniteLead) {
  const auto points = points_of([](double n) { return n * n; }, 0, 0);
  const auto found = lab::neighbours_of(points, {2, 0}, "n");
  EXPECT_TRUE(found->beats_all());
  for (const auto& rival : found->rivals) EXPECT_TRUE(std::isfinite(rival.lead)) << rival.law;
}

TEST(Neighbours, ThreePointsSayNothing) {
  auto points = points_of([](double n) { return n; }, 0, 0);
  points.resize(3);
  EXPECT_FALSE(lab::neighbours_of(points, {1, 0}, "n"));
}

TEST(LeastSquares, FindsExactCoefficients) {
  const std::vector<double> x{1, 2, 3, 4, 5}, ones(5, 1);
  std::vector<double> squares, y;
  for (const double value : x) {
    squares.push_back(value * value);
    y.push_back(2 - 3 * value + 0.5 * value * value);
  }
  const auto found = lab::least_squares({ones, x, squares}, y, std::vector<double>(5, 0));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->coefficients[0], 2, 1e-10);
  EXPECT_NEAR(found->coefficients[1], -3, 1e-10);
  EXPECT_NEAR(found->coefficients[2], 0.5, 1e-10);
  EXPECT_EQ(found->degrees, 2);
  EXPECT_FALSE(lab::least_squares({ones, x, x}, y, std::vector<double>(5, 0)));
  EXPECT_FALSE(lab::least_squares({ones}, {1}, {0}));
}

// Two columns are the straight line of fit_law.
TEST(LeastSquares, AgreesWithTheStraightLine) {
  for (const double error : {0.0, 0.05}) {
    const auto points = points_of([](double n) { return 3 + 2 * n; }, 0.05, error);
    std::vector<double> n, count, errors;
    for (const lab::FitPoint& point : points) {
      n.push_back(point.n);
      count.push_back(point.count);
      errors.push_back(point.error);
    }
    const auto found = lab::least_squares({std::vector<double>(n.size(), 1), n}, count, errors);
    const auto line = lab::fit_law("a + b n", points, [](double x) { return x; });
    EXPECT_NEAR(found->coefficients[1], line->b, 1e-9 * line->b);
    EXPECT_NEAR(found->lower[1], line->lower, 1e-6 * line->b);
    EXPECT_NEAR(found->upper[1], line->upper, 1e-6 * line->b);
    EXPECT_NEAR(found->chi_square, line->chi_square, 1e-6 * line->chi_square);
  }
}

}  // namespace neighbours_test
}  // namespace kinex
