// SPDX-License-Identifier: GPL-3.0-or-later
// What `kinex reproduce` is made of: runs as cells of a plan, fits, claims, files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "experiments/families/collision/separation_paper.h"
#include "experiments/families/hull/experiments.h"
#include "experiments/families/hull/polynomial_weights.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_document.h"
#include "experiments/lab/fit.h"
#include "experiments/lab/series.h"
#include "experiments/reproduce/paper_files.h"
#include "experiments/reproduce/papers.h"
#include "experiments/reproduce/planned.h"
#include "experiments/reproduce/runner.h"
#include "experiments/sweep/plan.h"

namespace kinex {
namespace reproduce_test {

using ::testing::HasSubstr;
using ::testing::Not;

lab::RunKey small_run(const std::string& structure, int n = 20) {
  lab::RunKey key;
  key.structure = structure;
  key.workload = "uniform-square";
  key.parameters.n = n;
  return key;
}

const auto kGoOn = [] { return true; };

TEST(RunRecord, SurvivesItsText) {
  lab::RunKey key = small_run("convex_hull_2_delaunay");
  key.forever = true;
  const lab::RunRecord record = lab::run_record(key, kGoOn).value();
  EXPECT_EQ(record.key, "convex_hull_2_delaunay uniform-square n=20 d=2 seed=1 forever");
  EXPECT_TRUE(record.clean) << record.trouble;
  EXPECT_GT(record.external, 0u);
  EXPECT_GT(record.processed, record.external);  // the flips of the triangulation are counted
  ASSERT_EQ(record.solved.size(), 5u);
  EXPECT_GT(record.solved[4], record.solved[2]);
  const lab::Fields text = lab::runs_fields({record});
  const std::vector<lab::RunRecord> again = lab::runs_of(text).value();
  ASSERT_EQ(again.size(), 1u);
  EXPECT_EQ(lab::runs_fields(again).exact, text.exact);
  EXPECT_EQ(lab::runs_fields(again).times, text.times);
  EXPECT_EQ(again[0].key, record.key);
  EXPECT_EQ(again[0].kinds, record.kinds);
  EXPECT_EQ(again[0].solved, record.solved);
  EXPECT_EQ(again[0].seconds, record.seconds);
  EXPECT_FALSE(lab::runs_of({text.exact + "1 ", text.times}));
  EXPECT_FALSE(lab::runs_of({text.exact, ""}));
}

TEST(RunRecord, TheThreeHullsChangeTogether) {
  std::uint64_t external = 0;
  for (const char* structure :
       {"convex_hull_2", "convex_hull_2_brute_force", "convex_hull_2_delaunay"}) {
    lab::RunKey key = small_run(structure, 40);
    key.forever = true;
    const lab::RunRecord record = lab::run_record(key, kGoOn).value();
    if (external == 0) external = record.external;
    EXPECT_EQ(record.external, external) << structure;
  }
  EXPECT_GT(external, 10u);
}

TEST(RunRecord, IsNotMadeOfAnInterruptedRun) {
  EXPECT_FALSE(lab::run_record(small_run("sorted_list"), [] { return false; }).has_value());
}

TEST(Series, SeedsGoOnUntilTheMeanIsPrecise) {
  lab::SeriesPoint point;
  point.key = small_run("sorted_list");
  point.key.parameters.dimension = 1;
  point.precise = "processed";
  point.min_seeds = 2;
  point.max_seeds = 500;
  point.relative_error = 0.03;
  const lab::SeriesResult result = lab::run_point(point, {}).value();
  const lab::RunningMean mean = result.mean("processed");
  EXPECT_GT(mean.count(), 5u);
  EXPECT_LE(mean.standard_error(), 0.03 * mean.mean());
  EXPECT_NEAR(mean.mean(), 20 * 19 / 4.0, 4 * mean.standard_error());
  EXPECT_THROW(lab::quantity_of(result.runs[0], "colour"), std::invalid_argument);
  int asked = 0;
  lab::SeriesOptions stopped;
  stopped.go_on = [&] { return ++asked < 20; };
  EXPECT_FALSE(lab::run_point(point, stopped));
}

sweep::Experiments only_reproduce() {
  sweep::Experiments all;
  reproduce::add_experiment(all);
  return all;
}

TEST(PlannedReproduce, ACellRunsFromItsTextAndComesBack) {
  lab::SeriesPoint point = reproduce::paper_named("kds-report-1998").parts[0].points(true).front();
  const sweep::PlanCell cell = reproduce::planned(point);
  const sweep::CellReport there = sweep::run_any(cell.text, only_reproduce());
  const sweep::Record record = sweep::record_of(cell, there, 1);
  EXPECT_EQ(record.outcome, sweep::Outcome::kDone) << record.message;
  const sweep::Record read = sweep::parse_record(sweep::record_line(record), "file", 1);
  std::string trouble;
  const lab::SeriesResult back = reproduce::series_of(read, point, trouble);
  EXPECT_EQ(trouble, "");
  const lab::SeriesResult here = lab::run_point(point, {}).value();
  EXPECT_EQ(lab::runs_fields(back.runs).exact, lab::runs_fields(here.runs).exact);
  point.cost *= 2;
  EXPECT_EQ(reproduce::planned(point).key, cell.key);
  point.max_seeds += 1;
  EXPECT_NE(reproduce::planned(point).key, cell.key);
  // A cell that the papers do not have.
  EXPECT_EQ(sweep::run_any(reproduce::planned(point).text, only_reproduce()).outcome,
            sweep::Outcome::kRefused);
}

TEST(PlannedReproduce, APlanHasEveryPointAndStudyOfItsParts) {
  const sweep::Experiments all = only_reproduce();
  const auto cells = [&](const std::vector<std::string>& parts) {
    return sweep::plan_of(reproduce::selection_of("separation-sensitive-1999", parts, true), all).cells;
  };
  EXPECT_EQ(cells({"hierarchies"}).size(), 1u);
  std::set<std::string> keys;
  const lab::Paper& paper = reproduce::paper_named("separation-sensitive-1999");
  for (const lab::PaperPart& part : paper.parts) {
    for (const lab::SeriesPoint& point : part.points(true)) keys.insert(reproduce::planned(point).key);
  }
  EXPECT_EQ(cells({}).size(), keys.size() + 1);
  EXPECT_THROW(cells({"figure-3"}), formats::InputError);
  EXPECT_THROW(sweep::plan_of(reproduce::selection_of("", {}, true), all), formats::InputError);
  sweep::Selection wrong = reproduce::selection_of("separation-sensitive-1999", {}, true);
  wrong.options["seeds"] = {"3"};
  EXPECT_THROW(sweep::plan_of(wrong, all), formats::InputError);
}

// A cell that crashed elsewhere has no runs: its claims stay open, and it is named.
TEST(PlannedReproduce, ACrashLeavesTheClaimsOpen) {
  const lab::PaperPart& part = reproduce::paper_named("separation-sensitive-1999").parts[2];
  sweep::Attempt attempt;
  attempt.provenance = sweep::provenance_of(sweep::PlanText{}, "test", "0/1");
  for (const lab::SeriesPoint& point : part.points(true)) {
    sweep::CellReport crashed;
    crashed.outcome = sweep::Outcome::kMemory;
    crashed.message = "there is not enough memory";
    attempt.records.push_back(sweep::record_of(reproduce::planned(point), crashed, 1));
  }
  sweep::Journal journal(std::vector{attempt});
  const lab::SecondProgram none("no-such-program", kGoOn, nullptr);
  reproduce::RunnerOptions options;
  options.quick = true;
  options.source.journal = &journal;
  const reproduce::ReproducedPart done = reproduce::run_part(part, none, options);
  EXPECT_TRUE(done.interrupted);
  EXPECT_EQ(done.troubles.size(), part.points(true).size());
  EXPECT_THAT(done.troubles.front(), HasSubstr("there is not enough memory"));
  for (const lab::PaperClaim& claim : done.report.claims) EXPECT_EQ(claim.verdict, lab::Verdict::kOpen);
}

TEST(Fits, FindTheLawOfTheirPoints) {
  std::vector<lab::FitPoint> squares, powers;
  for (const double n : {10.0, 30.0, 100.0, 300.0, 1000.0, 3000.0}) {
    const double log = std::log(n);
    squares.push_back({n, 3 + 2 * log * log, 0.5});
    powers.push_back({n, 4 * std::pow(n, 0.25), 0.1});
  }
  const auto log_squared = [](double n) { return std::log(n) * std::log(n); };
  const lab::Fit right = *lab::fit_law("a + b ln^2 n", squares, log_squared);
  EXPECT_NEAR(right.a, 3, 1e-9);
  EXPECT_NEAR(right.b, 2, 1e-9);
  EXPECT_NEAR(right.at(50), 3 + 2 * log_squared(50), 1e-9);
  EXPECT_LT(right.chi_square, 1e-9);
  EXPECT_GT(lab::fit_power(squares)->chi_square, 1);
  const lab::Fit power = *lab::fit_power(powers);
  EXPECT_NEAR(power.a, 4, 1e-9);
  EXPECT_NEAR(power.b, 0.25, 1e-9);
  EXPECT_LE(power.lower, power.b);
  EXPECT_GT(lab::fit_law("", powers, log_squared)->chi_square, 1);
  EXPECT_FALSE(lab::fit_power(std::span(powers).first(2)));
}

TEST(Fits, ABetterFitIsBetterBeyondChance) {
  const auto fit = [](double chi_square, int degrees) {
    lab::Fit one;
    one.chi_square = chi_square;
    one.degrees = degrees;
    return one;
  };
  EXPECT_EQ(lab::better_fit(fit(4, 4), fit(14, 4)), lab::BetterFit::kFirst);
  EXPECT_EQ(lab::better_fit(fit(14, 4), fit(4, 4)), lab::BetterFit::kSecond);
  EXPECT_EQ(lab::better_fit(fit(4, 4), fit(4.1, 4)), lab::BetterFit::kNeither);
  // Where even the better one leaves ten times what it may, ten times as much is chance.
  EXPECT_EQ(lab::better_fit(fit(40, 4), fit(50, 4)), lab::BetterFit::kNeither);
  EXPECT_EQ(lab::better_fit(fit(40, 4), fit(150, 4)), lab::BetterFit::kFirst);
}

TEST(PowerClaim, TheWholeIntervalDecides) {
  const auto verdict = [](double exponent, double scatter) {
    std::vector<lab::FitPoint> points;
    double sign = 1;
    for (const double n : {10.0, 20.0, 40.0, 80.0, 160.0}) {
      points.push_back({n, std::pow(n, exponent) * (1 + sign * scatter), 0});
      sign = -sign;
    }
    return families::power_claim("id", "statement", points, "n", 1).verdict;
  };
  EXPECT_EQ(verdict(1, 0.001), lab::Verdict::kConfirmed);
  EXPECT_EQ(verdict(0.5, 0.001), lab::Verdict::kConfirmed);
  EXPECT_EQ(verdict(1, 0.4), lab::Verdict::kOpen);
  EXPECT_EQ(verdict(1.3, 0.4), lab::Verdict::kOpen);
  EXPECT_EQ(verdict(1.3, 0.001), lab::Verdict::kRefuted);
}

TEST(PolynomialWeights, SumOverTheDegrees) {
  lab::RunRecord record;
  record.solved = {7, 3, 5, 0, 2};
  EXPECT_EQ(families::cost_of(record, families::square_weights()), 3 + 4 * 5 + 16 * 2);
  const families::PolynomialWeights measured = families::measured_weights("exact");
  EXPECT_EQ(measured.by_degree[1], 1);
  EXPECT_GT(measured.by_degree[4], measured.by_degree[2]);
}

lab::SeriesResult result_of(const char* structure, int n, std::uint64_t twos, std::uint64_t fours) {
  lab::SeriesResult result;
  result.point.key = small_run(structure, n);
  lab::RunRecord record;
  record.solved = {0, 0, twos, 0, fours};
  result.runs.push_back(record);
  return result;
}

// The verdicts are those of the numbers, not of the paper.
TEST(Figure3, RefutesWhatTheNumbersDoNotShow) {
  const auto verdicts = [](std::uint64_t brute_at_50, std::uint64_t delaunay_at_200) {
    std::vector<lab::SeriesResult> results;
    for (const auto& [n, kinetic, brute, delaunay] :
         {std::tuple(20, 100, 50, 100), std::tuple(50, 200, static_cast<int>(brute_at_50), 200),
          std::tuple(200, 400, 9000, static_cast<int>(delaunay_at_200))}) {
      results.push_back(result_of("convex_hull_2", n, static_cast<std::uint64_t>(kinetic), 0));
      results.push_back(
          result_of("convex_hull_2_brute_force", n, static_cast<std::uint64_t>(brute), 0));
      results.push_back(
          result_of("convex_hull_2_delaunay", n, 0, static_cast<std::uint64_t>(delaunay)));
    }
    const lab::PartReport report = families::kds_figure_3_report(results, "command");
    return std::pair(report.claims[0], report.claims[1]);
  };
  const auto [brute, delaunay] = verdicts(300, 800);
  EXPECT_EQ(brute.verdict, lab::Verdict::kConfirmed);
  // ln(2) above at 20, ln(1.5) below at 50: 20 (50/20)^(0.693/(0.693+0.405)) = 36
  EXPECT_THAT(brute.observed, HasSubstr("from n = 36 on"));
  EXPECT_EQ(delaunay.verdict, lab::Verdict::kConfirmed);
  EXPECT_EQ(verdicts(1, 800).first.verdict, lab::Verdict::kRefuted);
  EXPECT_EQ(verdicts(300, 90).second.verdict, lab::Verdict::kRefuted);
}

TEST(PaperClaim, RefutedIsNoSurpriseWithAKnownCounterexample) {
  lab::PaperClaim claim;
  for (const bool known : {false, true}) {
    claim.counterexample = known ? "a square" : "";
    claim.verdict = lab::Verdict::kRefuted;
    EXPECT_EQ(claim.is_surprising(), !known);
    claim.verdict = lab::Verdict::kConfirmed;
    EXPECT_EQ(claim.is_surprising(), known);
    claim.verdict = lab::Verdict::kOpen;
    EXPECT_FALSE(claim.is_surprising());
  }
}

TEST(PaperFiles, HaveEveryFieldOfEveryClaim) {
  lab::PaperClaim claim;
  claim.id = "a \"quoted\" id";
  claim.place = "section 1";
  claim.statement = "It grows.";
  claim.kind = "growth";
  claim.command = "kinex reproduce x";
  claim.expected = "exponent 2";
  claim.tolerance = "0.1";
  claim.observed = "2.01";
  claim.verdict = lab::Verdict::kRefuted;
  claim.assumptions = {"one", "two"};
  claim.counterexample = "a square";
  claim.checked_by.message = "nothing moves";
  reproduce::ReproducedPart part;
  part.part = &reproduce::papers()[0].parts[0];
  part.report.claims = {claim};
  part.troubles = {"an audit"};
  const std::string text = reproduce::claims_json(reproduce::papers()[0], {part}, {});
  const formats::JsonDocument json_document = formats::parse_json(text, "claims.json");
  const formats::JsonValue& json = *json_document;
  ASSERT_EQ(json.find("claims")->items().size(), 1u);
  const formats::JsonValue& one = json.find("claims")->items()[0];
  for (const char* field : {"id", "place", "statement", "kind", "command", "expected", "tolerance",
                            "observed", "verdict", "counterexample"}) {
    ASSERT_NE(one.find(field), nullptr) << field;
    EXPECT_FALSE(one.find(field)->text().empty()) << field;
  }
  EXPECT_EQ(one.find("verdict")->text(), "refuted");
  EXPECT_EQ(one.find("assumptions")->items().size(), 2u);
  ASSERT_NE(one.find("checked_by"), nullptr);
  EXPECT_EQ(one.find("checked_by")->find("verdict")->text(), "not checked: nothing moves");
  const std::string readme = reproduce::paper_readme(reproduce::papers()[0], {part}, {}, false);
  EXPECT_THAT(readme, HasSubstr("**refuted**"));
  EXPECT_THAT(readme, HasSubstr("known counterexample: a square"));
  EXPECT_THAT(readme, HasSubstr("**Failed:** an audit"));
  EXPECT_THAT(readme, HasSubstr("checked by a second program: not checked: nothing moves"));
  EXPECT_THAT(readme, Not(HasSubstr(".svg")));
}

}  // namespace reproduce_test
}  // namespace kinex
