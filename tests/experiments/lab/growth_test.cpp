// SPDX-License-Identifier: GPL-3.0-or-later
// Verdicts on growth, on made-up counts of known laws with noise (seeds fixed): each verdict is
// reached, and no verdict becomes better when data are left out.
#include "experiments/lab/growth.h"
#include "experiments/lab/law_verdict.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <span>

#include "experiments/lab/power_verdict.h"

namespace kinex {
namespace growth_test {

using ::testing::HasSubstr;
using ::testing::Not;

class Noise {
 public:
  explicit Noise(std::uint64_t seed) : engine_(seed) {}
  double uniform() { return (static_cast<double>(engine_() >> 11) + 0.5) * 0x1p-53; }
  double normal() { return std::sqrt(-2 * std::log(uniform())) * std::cos(2 * M_PI * uniform()); }

 private:
  std::mt19937_64 engine_;
};

using Count = std::function<double(double)>;

std::vector<lab::FitPoint> points_of(const Count& law, double error, std::uint64_t seed,
                                     int sizes = 9) {
  Noise noise(seed);
  std::vector<lab::FitPoint> points;
  for (int k = 0; k < sizes; ++k) {
    const double n = 20 * std::pow(2, k), count = law(n);
    points.push_back({n, count * (1 + error * noise.normal()), error * count});
  }
  return points;
}

lab::PowerVerdict judged(const Count& law, double error, double exponent, std::uint64_t seed = 1) {
  return lab::judge_power(points_of(law, error, seed), {exponent, 0.03}, "n");
}

TEST(JudgePower, APowerWithNoiseIsJudgedByItself) {
  const auto law = [](double n) { return 2 * std::pow(n, 1.5); };
  const lab::PowerVerdict right = judged(law, 0.01, 1.5);
  EXPECT_EQ(right.verdict, lab::Verdict::kConfirmed) << right.observed;
  EXPECT_FALSE(right.corrected);
  EXPECT_EQ(judged(law, 0.01, 1.7).verdict, lab::Verdict::kRefuted);
  EXPECT_EQ(judged(law, 0.2, 1.5).verdict, lab::Verdict::kOpen);
  EXPECT_FALSE(lab::is_improbable(*right.fit));
}

// n (n - 1): to a tenth of a per cent no power, but one with a term of order n.
TEST(JudgePower, ATermOfLowerOrderExplainsABadFit) {
  const lab::PowerVerdict found = judged([](double n) { return n * (n - 1) / 4; }, 0.001, 2);
  EXPECT_TRUE(lab::is_improbable(*found.fit));
  ASSERT_TRUE(found.corrected) << found.observed;
  EXPECT_FALSE(lab::is_improbable(*found.corrected)) << found.observed;
  EXPECT_EQ(found.verdict, lab::Verdict::kConfirmed) << found.observed;
  EXPECT_THAT(found.observed, HasSubstr("too large for chance; with a term of order n^(b - 1)"));
  EXPECT_NEAR(found.corrected->b, 2, 0.003);
  EXPECT_NEAR(found.corrected->c, -1, 0.1);
}

// Waves about a power are no power with a term of lower order: what an interval says is not enough.
TEST(JudgePower, WhatNoTermExplainsIsOpen) {
  const auto waves = [](double n) { return n * n * (1 + 0.02 * std::sin(3 * std::log(n))); };
  const lab::PowerVerdict found = judged(waves, 0.001, 2);
  EXPECT_EQ(lab::compare_with_claim(found.fit->lower, found.fit->upper, 2, 0.03, false),
            lab::Verdict::kConfirmed);
  ASSERT_TRUE(found.corrected);
  EXPECT_TRUE(lab::is_improbable(*found.corrected));
  EXPECT_EQ(found.verdict, lab::Verdict::kOpen) << found.observed;
  EXPECT_THAT(found.observed, HasSubstr("too large for chance, too"));
  // Far off is far off, whatever the fit is like.
  EXPECT_EQ(judged(waves, 0.001, 3).verdict, lab::Verdict::kRefuted);
}

// A power of 4/3 with two terms of lower order, as of points in a cube: its facets and its edges. The
// power alone is too steep, with one term too flat: neither refutes it.
TEST(JudgePower, TwoFitsOnBothSidesOfTheClaimRefuteNothing) {
  const auto law = [](double n) {
    const double side = std::cbrt(n);
    return 10.3 * n * side + 17.3 * n - 177 * side * side + 246 * side;
  };
  std::vector<lab::FitPoint> points;
  for (const double n : {25, 35, 50, 70, 100, 200, 400, 800, 1600}) {
    points.push_back({n, law(n), law(n) * (n < 200 ? 0.018 : n < 800 ? 0.01 : 0.004)});
  }
  const lab::PowerVerdict found = lab::judge_power(points, {4.0 / 3, 0.03, false, 1.0 / 3}, "n");
  EXPECT_TRUE(lab::is_improbable(*found.fit));
  EXPECT_GT(found.fit->lower, 4.0 / 3 + 0.03);
  ASSERT_TRUE(found.corrected);
  EXPECT_FALSE(lab::is_improbable(*found.corrected)) << found.observed;
  EXPECT_LT(found.corrected->upper, 4.0 / 3 - 0.03);
  EXPECT_EQ(found.verdict, lab::Verdict::kOpen) << found.observed;
  EXPECT_THAT(found.observed, HasSubstr(", on the other side of the claim"));
  // Both are above 1, so that much is refuted.
  EXPECT_EQ(lab::judge_power(points, {1, 0.03, false, 1.0 / 3}, "n").verdict, lab::Verdict::kRefuted);
}

// Small sizes, where the term of n (n - 2) or n (n + 3) raises or lowers the exponent by more than the tolerance, while
// chance explains what the power leaves: the asymptotic law is not refuted.
TEST(JudgePower, ATermOfLowerOrderSpeaksBeforeARefutation) {
  // Without noise: what is left of the chi squared is the term's.
  const auto counts = [](const Count& law, double error) {
    std::vector<lab::FitPoint> points;
    for (const double n : {8, 12, 16, 24, 32}) points.push_back({n, law(n), error * law(n)});
    return points;
  };
  for (const double shift : {-2.0, 3.0}) {
    const auto law = [shift](double n) { return n * (n + shift); };
    const lab::PowerVerdict found = lab::judge_power(counts(law, 0.02), {2, 0.05}, "n");
    EXPECT_FALSE(lab::is_improbable(*found.fit)) << found.observed;
    EXPECT_EQ(lab::compare_with_claim(found.fit->lower, found.fit->upper, 2, 0.05, false),
              lab::Verdict::kRefuted) << found.observed;
    ASSERT_TRUE(found.corrected);
    EXPECT_EQ(found.verdict, lab::Verdict::kOpen) << found.observed;
    EXPECT_THAT(found.observed, HasSubstr("; with a term of order n^(b - 1): n^"));
    EXPECT_THAT(found.observed, HasSubstr(", not refuted"));
  }
  // Another power stays refuted, whatever the term.
  const lab::PowerVerdict other =
      lab::judge_power(counts([](double n) { return std::pow(n, 2.6); }, 0.002), {2, 0.05}, "n");
  EXPECT_FALSE(lab::is_improbable(*other.fit)) << other.observed;
  ASSERT_TRUE(other.corrected);
  EXPECT_EQ(other.verdict, lab::Verdict::kRefuted) << other.observed;
  EXPECT_THAT(other.observed, HasSubstr("; with that term and n^2.05: chi^2 = "));
}

TEST(JudgePower, TheGivenPowerIsFittedWithItsTerm) {
  const auto term = [](double n) { return 1 / n; };
  std::vector<lab::FitPoint> points;
  for (const double n : {4, 8, 16, 32}) points.push_back({n, 5 * n * n * std::exp(-3 / n), 0.1 * n * n});
  const lab::Fit right = *lab::fit_given_power_with(2, "law", points, term);
  EXPECT_NEAR(right.a, 5, 1e-9);
  EXPECT_NEAR(right.c, -3, 1e-9);
  EXPECT_NEAR(right.chi_square, 0, 1e-12);
  EXPECT_EQ(right.degrees, 2);
  EXPECT_NEAR(right.at(8), points[1].count, 1e-9);
  EXPECT_GT(lab::fit_given_power_with(3, "law", points, term)->chi_square, 100);
  points.resize(2);
  EXPECT_FALSE(lab::fit_given_power_with(2, "law", points, term));
}

// Exact counts have no chi squared: the term is fitted because the power alone would refute.
TEST(JudgePower, ATermOfLowerOrderSpeaksOfExactCounts) {
  std::vector<lab::FitPoint> points;
  for (const double n : {8, 16, 32, 64}) points.push_back({n, n * (n - 1) / 2, 0});
  const lab::PowerVerdict found = lab::judge_power(points, {2, 0.001}, "n");
  EXPECT_GT(found.fit->lower, 2.001);
  EXPECT_EQ(found.verdict, lab::Verdict::kOpen) << found.observed;
  EXPECT_THAT(found.observed, Not(HasSubstr("chi^2")));
  // Nor does it turn a bound that is broken into one that holds.
  for (lab::FitPoint& point : points) point.count = std::pow(point.n, 3);
  EXPECT_EQ(lab::judge_power(points, {2, 0.05, true}, "n").verdict, lab::Verdict::kRefuted);
}

// The interval of the power alone is partly outside; that with the term is within, if there are enough
// sizes to tell.
TEST(JudgePower, ATermOfLowerOrderNarrowsExactCounts) {
  std::vector<lab::FitPoint> points;
  for (const double n : {8, 12, 16, 24, 32}) points.push_back({n, (n - 1) * (n - 1), 0});
  const lab::PowerVerdict found = lab::judge_power(points, {2, 0.15}, "n");
  EXPECT_LT(found.fit->lower, 2.15);
  EXPECT_GT(found.fit->upper, 2.15);
  EXPECT_EQ(found.verdict, lab::Verdict::kConfirmed) << found.observed;
  EXPECT_EQ(lab::judge_power(std::span(points).first(4), {2, 0.15}, "n").verdict, lab::Verdict::kOpen);
  EXPECT_EQ(lab::judge_power(points, {2.3, 0.15}, "n").verdict, lab::Verdict::kOpen);
}

// Four exact counts that lie on no law: with the term one degree of freedom is left, and an interval that
// holds any exponent. It saves no claim that the counts refute.
TEST(JudgePower, FourExactCountsOnNoLawRefute) {
  const std::vector<lab::FitPoint> points{{8, 530, 0}, {16, 4000, 0}, {32, 33500, 0}, {64, 258000, 0}};
  const lab::PowerVerdict found = lab::judge_power(points, {2, 0.05, true}, "n");
  ASSERT_TRUE(found.corrected);
  EXPECT_LT(found.corrected->lower, 2) << found.observed;
  EXPECT_EQ(found.verdict, lab::Verdict::kRefuted) << found.observed;
  EXPECT_THAT(found.observed, HasSubstr("too few sizes"));
}

// A term of order n^(b - 1/3) and one of order n^(b - 1/2) explain the counts, with exponents far apart.
TEST(JudgePower, AnOrderThatIsNotKnownMustNotDecide) {
  static constexpr double kOthers[] = {1.0 / 2, 2.0 / 3, 1};
  const auto judge = [](const Count& law, double order, std::span<const double> others) {
    return lab::judge_power(points_of(law, 0.003, 1), {4.0 / 3, 0.05, false, order, others}, "n");
  };
  const auto bent = [](double n) { return std::pow(n, 4.0 / 3) * std::exp(-3 / std::cbrt(n)); };
  EXPECT_EQ(judge(bent, 1.0 / 3, {}).verdict, lab::Verdict::kConfirmed);
  const lab::PowerVerdict open = judge(bent, 1.0 / 3, kOthers);
  EXPECT_EQ(open.verdict, lab::Verdict::kOpen) << open.observed;
  EXPECT_THAT(open.observed, HasSubstr("not all within the tolerance"));
  const auto nearly = [](double n) { return std::pow(n, 4.0 / 3) * (1 + 1 / n); };
  const lab::PowerVerdict confirmed = judge(nearly, 1.0 / 3, kOthers);
  EXPECT_EQ(confirmed.verdict, lab::Verdict::kConfirmed) << confirmed.observed;
  EXPECT_THAT(confirmed.observed, HasSubstr("the order of the term is not known"));
  // A refutation stays one.
  EXPECT_EQ(judge([](double n) { return std::pow(n, 1.6); }, 1.0 / 3, kOthers).verdict,
            lab::Verdict::kRefuted);
}

TEST(JudgePower, ThreeSizesLeaveNothingForATerm) {
  std::vector<lab::FitPoint> points{{10, 100, 0.1}, {20, 410, 0.4}, {40, 1600, 1.6}};
  const lab::PowerVerdict found = lab::judge_power(points, {2, 1}, "n");
  EXPECT_EQ(found.verdict, lab::Verdict::kOpen);
  EXPECT_THAT(found.observed, HasSubstr("too few sizes"));
}

TEST(JudgePower, ChiSquareIsSaidOnlyOfCountsWithErrors) {
  std::vector<lab::FitPoint> points = points_of([](double n) { return n * (n - 1); }, 0.001, 3);
  EXPECT_THAT(lab::fit_text(*lab::fit_power(points)), HasSubstr("chi^2"));
  for (lab::FitPoint& point : points) point.error = 0;
  const lab::PowerVerdict found = lab::judge_power(points, {2, 0.03}, "n");
  EXPECT_THAT(found.observed, Not(HasSubstr("chi^2")));
  EXPECT_THAT(lab::fit_text(*found.fit), Not(HasSubstr("chi^2")));
  EXPECT_FALSE(lab::is_improbable(*found.fit));
}

// ---- laws with logarithms, and whole families of cells -----------------------------------------

// Cells of 8 and more random scenes, as runs have them: until the mean is known to 2 %, and for `fewest`
// scenes. Fewer are the first ones of more.
std::vector<lab::CellResult> family_of(const Count& law, double spread, std::uint64_t seed,
                                       int sizes = 8, std::size_t fewest = 0) {
  std::vector<lab::CellResult> cells;
  for (int k = 0; k < sizes; ++k) {
    Noise noise(1000 * seed + static_cast<std::uint64_t>(k));
    lab::CellResult cell;
    cell.cell.structure = "sorted_list";
    cell.cell.family = "made up";
    cell.cell.min_seeds = 8;
    cell.cell.precise = {{"processed", 0.02}};
    const double n = 32 * std::pow(2, k);
    while (cell.trials.size() < fewest || !lab::precise_enough(cell.cell, cell.trials)) {
      lab::Trial trial;
      trial.measurement.objects = static_cast<std::size_t>(n);
      const double count = 1000 * law(n) * std::max(0.01, 1 + spread * noise.normal());
      trial.measurement.costs.processed = static_cast<std::uint64_t>(count);
      cell.trials.push_back(trial);
    }
    cells.push_back(cell);
  }
  return cells;
}

lab::GrowthClaim claim_of(double exponent, int logs, std::size_t sizes) {
  lab::GrowthClaim claim{"test", "sorted_list", "made up", "processed", 1, exponent, 0.1, ""};
  claim.logs = logs;
  claim.sizes = sizes;
  return claim;
}

TEST(JudgeGrowth, ALawWithALogarithmMustBeatItsNeighbours) {
  const auto verdict = [](const Count& law, double spread, int logs) {
    return lab::judge_growth(claim_of(0, logs, 8), family_of(law, spread, 5)).check;
  };
  const auto log = [](double n) { return 1 + std::log(n); };
  const auto log_squared = [](double n) { return 1 + std::pow(std::log(n), 2); };
  EXPECT_EQ(verdict(log_squared, 0.02, 2).verdict, lab::Verdict::kConfirmed)
      << verdict(log_squared, 0.02, 2).observed;
  EXPECT_EQ(verdict(log, 0.005, 1).verdict, lab::Verdict::kConfirmed)
      << verdict(log, 0.005, 1).observed;
  EXPECT_EQ(verdict(log_squared, 0.02, 1).verdict, lab::Verdict::kRefuted);
  EXPECT_EQ(verdict([](double n) { return std::sqrt(n); }, 0.02, 1).verdict,
            lab::Verdict::kRefuted);
  // A constant that hides every law: as straight as claimed, but so are the neighbours.
  const lab::Check hidden = verdict([](double n) { return 300 + std::log(n); }, 0.02, 1);
  EXPECT_EQ(hidden.verdict, lab::Verdict::kOpen) << hidden.observed;
  EXPECT_THAT(hidden.observed, HasSubstr("a neighbour fits as well"));
}

// The metamorphic one: of the laws below some are as claimed and some are not, and some have too
// much noise; whatever is left out of the data, nothing that was open or refuted is confirmed.
TEST(JudgeGrowth, LessDataNeverConfirmMore) {
  struct Case {
    Count law;
    double exponent;
    int logs;
    bool at_most = false;
  };
  const std::vector<Case> cases{
      {[](double n) { return std::pow(n, 1.5); }, 1.5, 0},
      {[](double n) { return std::pow(n, 1.5); }, 1.62, 0},
      {[](double n) { return std::pow(n, 1.7); }, 1.5, 0},
      {[](double n) { return n * (n + 50); }, 2, 0},
      {[](double n) { return n * std::log(n); }, 1, 0},
      {[](double n) { return n * n * (1 + 0.3 * std::sin(std::log(n))); }, 2, 0},
      {[](double n) { return 1 + std::log(n); }, 0, 1},
      {[](double n) { return 1 + std::pow(std::log(n), 2); }, 0, 2},
      {[](double n) { return 1 + std::pow(std::log(n), 2); }, 0, 1},
      {[](double n) { return std::pow(n, 0.2); }, 0, 1},
      {[](double n) { return 1 + std::log(n); }, 0, 1, true},
      {[](double n) { return std::pow(n, 0.1); }, 0, 1, true},
      {[](double n) { return std::pow(n, 0.2); }, 0, 1, true},
      {[](double) { return 1.0; }, 0, 1, true},
      {[](double n) { return 1 + std::log(n); }, 0, 2, true}};
  int confirmed = 0, not_confirmed = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      const double spread = seed % 3 == 0 ? 0.3 : seed % 3 == 1 ? 0.1 : 0.02;
      lab::GrowthClaim claim = claim_of(cases[i].exponent, cases[i].logs, 8);
      claim.at_most = cases[i].at_most;
      const std::vector<lab::CellResult> all = family_of(cases[i].law, spread, 100 * i + seed);
      if (lab::judge_growth(claim, all).check.verdict == lab::Verdict::kConfirmed) {
        ++confirmed;
        continue;
      }
      ++not_confirmed;
      Noise choice(seed);
      for (int round = 0; round < 20; ++round) {
        std::vector<lab::CellResult> fewer = all;
        if (round % 2 == 0) {  // sizes
          const auto left_out = 1 + static_cast<std::size_t>(choice.uniform() * 4);
          for (std::size_t k = 0; k < left_out; ++k) {
            const auto at =
                static_cast<std::size_t>(choice.uniform() * static_cast<double>(fewer.size()));
            fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(at));
          }
        } else {  // scenes, the last ones first
          for (lab::CellResult& cell : fewer) {
            const auto kept = static_cast<std::size_t>(choice.uniform() *
                                                       static_cast<double>(cell.trials.size()));
            cell.trials.resize(std::max<std::size_t>(1, kept));
          }
        }
        const lab::Check check = lab::judge_growth(claim, fewer).check;
        EXPECT_NE(check.verdict, lab::Verdict::kConfirmed)
            << "case " << i << ", seed " << seed << ": " << check.observed;
      }
    }
  }
  EXPECT_GT(confirmed, 20);
  EXPECT_GT(not_confirmed, 20);
}

// A wiggle of 1.2 % that the scenes that the claim asks for cannot show, and that thousands of scenes do. Those
// decide nothing: the claim is confirmed by every prefix of them that holds the scenes that it asks for,
// with the same numbers, and by none that does not.
TEST(JudgeGrowth, MoreScenesThanAskedForDecideNothing) {
  const auto wiggle = [](double n) {
    return std::pow(n, 1.5) * (1 + 0.012 * std::sin(3 * std::log(n)));
  };
  const lab::GrowthClaim claim = claim_of(1.5, 0, 8);
  std::vector<lab::CellResult> cells = family_of(wiggle, 0.1, 7);
  std::size_t fewest = 0;
  for (const lab::CellResult& cell : cells) {
    EXPECT_EQ(lab::scenes_asked_for(cell.cell, cell.trials), cell.trials.size());
    fewest = std::max(fewest, cell.trials.size());
  }
  const lab::Check asked = lab::judge_growth(claim, cells).check;
  ASSERT_EQ(asked.verdict, lab::Verdict::kConfirmed) << asked.observed;
  std::vector<lab::CellResult> more = family_of(wiggle, 0.1, 7, 8, 4000);
  const lab::GrowthResult all = lab::judge_growth(claim, more);
  EXPECT_EQ(all.check.verdict, lab::Verdict::kConfirmed);
  EXPECT_THAT(all.check.observed, HasSubstr("All scenes: "));
  EXPECT_THAT(all.check.observed, HasSubstr("too large for chance, too (open)"));
  for (const std::size_t kept :
       {std::size_t{4}, fewest - 1, fewest, fewest + 100, std::size_t{1000}}) {
    std::vector<lab::CellResult> part = more;
    for (lab::CellResult& cell : part) cell.trials.resize(kept);
    const lab::GrowthResult result = lab::judge_growth(claim, part);
    const bool enough = std::all_of(part.begin(), part.end(), [](const lab::CellResult& cell) {
      return lab::scenes_asked_for(cell.cell, cell.trials) > 0;
    });
    EXPECT_EQ(result.check.verdict == lab::Verdict::kConfirmed, enough) << kept;
    if (!enough) continue;
    EXPECT_EQ(result.fit->b, all.fit->b);
    EXPECT_EQ(result.fit->chi_square, all.fit->chi_square);
  }
}

// Some of the sizes of the full experiments, as --quick has them, agree at best.
TEST(JudgeGrowth, APartOfTheSizesAgrees) {
  const auto judged = [](const Count& law, std::size_t full_sizes, std::size_t cells = 8) {
    lab::GrowthClaim claim = claim_of(1.5, 0, 8);
    claim.full_sizes = full_sizes;
    std::vector<lab::CellResult> family = family_of(law, 0.02, 3);
    family.resize(cells);
    return lab::judge_growth(claim, family).check;
  };
  const auto law = [](double n) { return std::pow(n, 1.5); };
  EXPECT_EQ(judged(law, 8).verdict, lab::Verdict::kConfirmed);
  EXPECT_EQ(judged(law, 11).verdict, lab::Verdict::kAgrees);
  EXPECT_THAT(judged(law, 11).observed, HasSubstr(", 8 of the 11 cells of the full experiments"));
  EXPECT_EQ(judged(law, 11, 7).verdict, lab::Verdict::kOpen);
  const auto other = [](double n) { return std::pow(n, 1.8); };
  EXPECT_EQ(judged(other, 11).verdict, lab::Verdict::kRefuted);
}

TEST(JudgeGrowth, SaysWhichCellsAreMissing) {
  const auto law = [](double n) { return std::pow(n, 1.5); };
  std::vector<lab::CellResult> cells = family_of(law, 0.02, 1);
  const lab::GrowthClaim claim = claim_of(1.5, 0, 8);
  EXPECT_EQ(lab::judge_growth(claim, cells).check.verdict, lab::Verdict::kConfirmed);
  cells.pop_back();
  const lab::Check check = lab::judge_growth(claim, cells).check;
  EXPECT_EQ(check.verdict, lab::Verdict::kOpen);
  EXPECT_THAT(check.observed, HasSubstr("7 of 8 cells"));
}

TEST(Bend, IsZeroForTheLawItself) {
  std::vector<lab::FitPoint> points;
  for (const double n : {8, 16, 32, 64, 128}) points.push_back({n, 3 + 2 * std::log(n), 0});
  EXPECT_NEAR(lab::bend_of(points, {0, 1})->value, 0, 1e-12);
  // Over the logarithm of n from -1 to 1, of a parabola 3 + x^2 with the mean 3.5.
  for (lab::FitPoint& point : points) {
    const double x = std::log(point.n / 32) / std::log(4.0);
    point.count = 3 + x * x;
  }
  const lab::Bend bend = *lab::bend_of(points, {0, 1});
  EXPECT_NEAR(bend.value, 1 / 3.5, 1e-12);
  EXPECT_FALSE(lab::bend_of({}, {0, 1}));
  points.resize(3);
  EXPECT_FALSE(lab::bend_of(points, {0, 1}));
}

}  // namespace growth_test
}  // namespace kinex
