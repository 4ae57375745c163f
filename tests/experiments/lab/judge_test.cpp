// SPDX-License-Identifier: GPL-3.0-or-later
// Verdicts: a false expectation, a broken bound and a failed audit must all be seen, and what the
// runs do not decide is left open.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "experiments/lab/growth.h"
#include "tests/experiments/verify/cells.h"

namespace kinex {
namespace judge_test {

using test::constructed_family;
using test::expects;
using test::random_cell;
using test::run;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(Judge, MeansAreComparedInStandardErrors) {
  lab::Cell cell = random_cell(16, 30);
  cell.expectations = {expects(lab::ExpectationKind::kMean, "processed")};
  lab::Expectation& expectation = cell.expectations.front();
  const std::vector<lab::Trial> trials = run(cell).trials;
  const lab::RunningMean mean = lab::mean_of(trials, "processed");
  const auto verdict = [&](double errors) {
    expectation.reference = mean.mean() + errors * mean.standard_error();
    return lab::judge(cell, trials).front().verdict;
  };
  EXPECT_EQ(verdict(1.99), lab::Verdict::kConfirmed);
  EXPECT_EQ(verdict(-2.01), lab::Verdict::kRefuted);
  expectation.comparisons = 6;
  EXPECT_EQ(verdict(-2.01), lab::Verdict::kConfirmed);
  EXPECT_EQ(verdict(2.7), lab::Verdict::kRefuted);
  cell.precise = {{"processed", 1e-6}};
  EXPECT_EQ(verdict(1), lab::Verdict::kOpen);
  EXPECT_EQ(verdict(3), lab::Verdict::kRefuted);
}

// Of one scene there is no spread: neither a PASS nor a FAIL, however far off it is.
TEST(Judge, FewerScenesThanItTakesSayNothing) {
  lab::Cell cell = random_cell(16, 8);
  cell.max_seeds = 400;
  cell.precise = {{"processed", 0.05}};
  cell.expectations = {expects(lab::ExpectationKind::kMean, "processed")};
  const lab::CellResult all = run(cell);
  for (const double reference : {lab::mean_of(all.trials, "processed").mean(), 1e6}) {
    cell.expectations.front().reference = reference;
    for (const std::size_t seeds : {1, 2, 3, 5, 7}) {
      const std::vector<lab::Trial> few(all.trials.begin(),
                                   all.trials.begin() + static_cast<std::ptrdiff_t>(seeds));
      const lab::Check check = lab::judge(cell, few).front();
      EXPECT_EQ(check.verdict, lab::Verdict::kOpen) << seeds;
      EXPECT_GE(check.seeds_needed, 8) << seeds;
      EXPECT_THAT(check.observed, Not(HasSubstr("inf")));
      EXPECT_THAT(check.observed, HasSubstr("about " + std::to_string(check.seeds_needed)));
    }
  }
  EXPECT_EQ(lab::judge(cell, all.trials).front().verdict, lab::Verdict::kRefuted);
  EXPECT_EQ(lab::judge(cell, all.trials).front().seeds_needed, 0);
}

TEST(Judge, SeesABrokenBoundInAnyTrial) {
  lab::Cell cell = random_cell(8, 3);
  std::vector<lab::Trial> trials = run(cell).trials;
  ASSERT_FALSE(trials[1].measurement.bounds.empty());
  BoundCheck& bound = trials[1].measurement.bounds.front();
  bound.observed = bound.bound + Integer(1);
  bound.holds = false;
  bool seen = false;
  for (const lab::Check& check : lab::judge(cell, trials)) {
    if (check.verdict == lab::Verdict::kConfirmed) continue;
    seen = true;
    EXPECT_EQ(check.claim, bound.id);
    EXPECT_EQ(check.kind, "bound");
    EXPECT_EQ(check.trial, 1u);
  }
  EXPECT_TRUE(seen);
}

TEST(Judge, MissesABoundThatIsNotChecked) {
  lab::Cell cell = random_cell(8, 2);
  std::vector<lab::Trial> trials = run(cell).trials;
  const auto verdict = [&] {
    lab::Verdict worst = lab::Verdict::kConfirmed;
    for (const lab::Check& check : lab::judge(cell, trials)) worst = std::max(worst, check.verdict);
    return worst;
  };
  cell.bounded = true;
  EXPECT_EQ(verdict(), lab::Verdict::kConfirmed);
  trials[1].measurement.bounds.clear();
  EXPECT_EQ(verdict(), lab::Verdict::kRefuted);
  cell.bounded = false;
  EXPECT_EQ(verdict(), lab::Verdict::kConfirmed);
}

TEST(Judge, SeesAFailedAudit) {
  lab::Cell cell = random_cell(8, 2);
  std::vector<lab::Trial> trials = run(cell).trials;
  trials[1].measurement.costs.audit_violations = 1;
  trials[1].measurement.violations = {"a is not before b"};
  const std::vector<lab::Check> checks = lab::judge(cell, trials);
  EXPECT_EQ(checks.back().claim, "audit");
  EXPECT_EQ(checks.back().verdict, lab::Verdict::kRefuted);
  EXPECT_EQ(checks.back().source, "a is not before b");
}

template <class Count>
lab::Check judge_as_logarithm(const Count& count, int sizes = 10, double scale = 10) {
  std::vector<lab::CellResult> cells;
  for (int k = 0; k < sizes; ++k) {
    const double x = std::floor(3 * std::pow(2, 0.7 * k));
    lab::CellResult cell;
    cell.cell.structure = "sorted_list";
    cell.cell.family = "constructed";
    cell.cell.min_seeds = cell.cell.max_seeds = 3;
    for (const int departure : {-1, 0, 1}) {
      lab::Trial trial;
      trial.measurement.objects = static_cast<std::size_t>(x);
      trial.measurement.costs.processed =
          static_cast<std::uint64_t>(std::llround(scale * count(x)) + 3 * departure);
      cell.trials.push_back(trial);
    }
    cells.push_back(cell);
  }
  lab::GrowthClaim claim{"test.log", "sorted_list", "constructed", "processed", 1, 0, 0.1, ""};
  claim.at_most = true;
  claim.logs = 1;
  return lab::judge_growth(claim, cells).check;
}

// A line, a root, and a line that a large offset hides from the power are no logarithms.
TEST(JudgeGrowth, TellsALogarithmFromALine) {
  const auto verdict = [](const auto& count) { return judge_as_logarithm(count).verdict; };
  EXPECT_EQ(verdict([](double x) { return 4 + 2 * std::log2(x); }), lab::Verdict::kConfirmed);
  // A large offset hides what grows: other laws fit as well, unless the counts are known well.
  const auto offset = [](double x) { return 30 + std::log2(x); };
  EXPECT_EQ(verdict(offset), lab::Verdict::kOpen);
  EXPECT_EQ(judge_as_logarithm(offset, 10, 1000).verdict, lab::Verdict::kConfirmed);
  EXPECT_EQ(verdict([](double) { return 12.0; }), lab::Verdict::kConfirmed);
  EXPECT_EQ(verdict([](double x) { return x; }), lab::Verdict::kRefuted);
  EXPECT_EQ(verdict([](double x) { return 20 + 0.1 * x; }), lab::Verdict::kRefuted);
  EXPECT_EQ(verdict([](double x) { return 100 + 0.3 * x; }), lab::Verdict::kRefuted);
  EXPECT_EQ(verdict([](double x) { return 3 * std::sqrt(x); }), lab::Verdict::kRefuted);
  EXPECT_EQ(verdict([](double x) { return 10 + 2 * std::sqrt(x); }), lab::Verdict::kRefuted);
  EXPECT_EQ(judge_as_logarithm([](double x) { return std::log2(x); }, 5).verdict, lab::Verdict::kOpen);
}

TEST(JudgeGrowth, AcceptsTheExponentWithinTheTolerance) {
  lab::GrowthClaim claim{"test.growth", "sorted_list", "constructed", "processed", 1, 1.5, 0.03, ""};
  EXPECT_EQ(lab::judge_growth(claim, constructed_family(1.5)).check.verdict, lab::Verdict::kConfirmed);
  EXPECT_EQ(lab::judge_growth(claim, constructed_family(1.52)).check.verdict, lab::Verdict::kConfirmed);
  EXPECT_EQ(lab::judge_growth(claim, constructed_family(1.54)).check.verdict, lab::Verdict::kRefuted);
  EXPECT_EQ(lab::judge_growth(claim, constructed_family(1.46)).check.verdict, lab::Verdict::kRefuted);
  claim.smallest = 300;
  EXPECT_EQ(lab::judge_growth(claim, constructed_family(1.5)).check.verdict, lab::Verdict::kOpen);
  claim.smallest = 1;
  claim.tolerance = 1e-5;
  claim.exponent = lab::judge_growth(claim, constructed_family(1.5)).fit->b;
  EXPECT_EQ(lab::judge_growth(claim, constructed_family(1.5)).check.verdict, lab::Verdict::kOpen);
}

// The interval decides, not the exponent: fewer data widen it, and never confirm more.
TEST(JudgeGrowth, AWideIntervalConfirmsNothing) {
  const auto family = [](double scatter, double exponent) {
    std::vector<lab::CellResult> cells = constructed_family(exponent);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const double factor = 1 + (i % 2 == 0 ? scatter : -scatter);
      for (lab::Trial& trial : cells[i].trials) {
        std::uint64_t& count = trial.measurement.costs.processed;
        count = static_cast<std::uint64_t>(static_cast<double>(count) * factor);
      }
    }
    return cells;
  };
  lab::GrowthClaim claim{"test.growth", "sorted_list", "constructed", "processed", 1, 1.5, 0.03, ""};
  for (const bool at_most : {false, true}) {
    claim.at_most = at_most;
    const auto verdict = [&](double scatter, double exponent) {
      return lab::judge_growth(claim, family(scatter, exponent)).check.verdict;
    };
    EXPECT_EQ(verdict(0.001, 1.5), lab::Verdict::kConfirmed);
    EXPECT_EQ(verdict(0.1, 1.5), lab::Verdict::kOpen);
    EXPECT_EQ(verdict(0.1, 1.6), lab::Verdict::kOpen);  // off, but it may be chance
    EXPECT_EQ(verdict(0.1, 3), lab::Verdict::kOpen);    // no fit explains such scatter
    EXPECT_EQ(verdict(0.001, 3), lab::Verdict::kRefuted);
    EXPECT_EQ(verdict(0.001, 1), at_most ? lab::Verdict::kConfirmed : lab::Verdict::kRefuted);
  }
}

TEST(JudgeGrowth, WantsTheScenesThatACellNeeds) {
  lab::GrowthClaim claim{"test.growth", "sorted_list", "constructed", "processed", 1, 1.5, 0.03, ""};
  for (const double exponent : {1.5, 3.0}) {
    std::vector<lab::CellResult> cells = constructed_family(exponent);
    cells[2].cell.min_seeds = 8;
    const lab::Check check = lab::judge_growth(claim, cells).check;
    EXPECT_EQ(check.verdict, lab::Verdict::kOpen);
    EXPECT_EQ(check.seeds_needed, 8);
    for (lab::CellResult& cell : cells) {
      cell.trials.resize(1);
      cell.cell.min_seeds = cell.cell.max_seeds = 1;
    }
    // Exact counts: three sizes may lie on a power by chance.
    cells.resize(3);
    EXPECT_EQ(lab::judge_growth(claim, cells).check.verdict,
              exponent == 1.5 ? lab::Verdict::kOpen : lab::Verdict::kRefuted);
  }
}

}  // namespace judge_test
}  // namespace kinex
