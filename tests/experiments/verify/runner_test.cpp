// SPDX-License-Identifier: GPL-3.0-or-later
// The runner: cells with all their seeds, catalogues with several at a time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "experiments/formats/scene_reader.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/verify/report_text.h"
#include "tests/experiments/verify/cells.h"
#include "tests/experiments/verify/folder.h"

namespace kinex {
namespace {

using test::Folder;
using test::random_cell;
using test::run;
using test::small_catalogue;
using test::sorting_cell;
using ::testing::HasSubstr;

TEST(RunCell, PassesATrueExpectation) {
  const CellResult result = run(sorting_cell(28));
  EXPECT_EQ(result.verdict(), Verdict::kConfirmed) << table_row(result);
  EXPECT_EQ(result.trials.size(), 1u);
  EXPECT_TRUE(result.kept.empty());
  ASSERT_TRUE(result.contest);
  EXPECT_TRUE(result.contest->same_counts);
}

TEST(RunCell, FailsAFalseExpectationAndKeepsTheScene) {
  const Folder folder;
  VerifyOptions options;
  options.keep_folder = folder.name();
  const CellResult result = run(sorting_cell(29), options);
  EXPECT_EQ(result.verdict(), Verdict::kRefuted);
  EXPECT_EQ(result.checks.front().expected, "29");
  EXPECT_EQ(result.checks.front().observed, "28");
  ASSERT_EQ(result.kept.size(), 1u);
  const Scene kept = read_scene(result.kept.front());
  EXPECT_EQ(scene_hash(kept), result.trials.front().measurement.scene_hash);
  EXPECT_THAT(table_row(result), HasSubstr("FAIL test.claim processed: expected 29, observed 28"));
}

Integer one_more(const Scene& scene) { return inversions(scene) + Integer(1); }

TEST(RunCell, ChecksEverySceneAgainstItsWitness) {
  Cell cell = random_cell(12, 5);
  EXPECT_EQ(run(cell).verdict(), Verdict::kConfirmed);
  cell.expectations.back().witness = one_more;
  EXPECT_EQ(run(cell).verdict(), Verdict::kRefuted);
}

TEST(RunCell, ThrowsAreFailures) {
  Cell cell = sorting_cell(28);
  cell.expectations.back().quantity = "no such count";
  EXPECT_THROW(judge(cell, run(sorting_cell(28)).trials), std::invalid_argument);
  cell = random_cell(12, 2);
  cell.parameters.degree = 2;  // the witness is for lines only
  const CellResult result = run(cell);
  EXPECT_EQ(result.verdict(), Verdict::kRefuted);
  EXPECT_THAT(result.checks.back().observed, HasSubstr("not linear"));
}

TEST(RunCell, SaysWhenItGaveUp) {
  Cell cell = random_cell(300, 1);
  cell.max_seconds = 1e-9;
  const CellResult result = run(cell);
  EXPECT_EQ(result.verdict(), Verdict::kGaveUp) << table_row(result);
  EXPECT_THAT(table_row(result), HasSubstr("GAVE UP run"));
}

TEST(RunCell, AddsSeedsUntilTheMeanIsKnown) {
  Cell cell = random_cell(16, 4);
  cell.max_seeds = 1000;
  cell.precise = {{"processed", 0.05}};
  const CellResult result = run(cell);
  EXPECT_GT(result.trials.size(), 4u);
  EXPECT_LT(result.trials.size(), 100u);
  const RunningMean mean = mean_of(result.trials, "processed");
  EXPECT_LE(mean.standard_error(), 0.05 * mean.mean());
  VerifyOptions options;
  options.seeds = 3;
  EXPECT_EQ(run(cell, options).trials.size(), 3u);
}

// Everything but times.
std::string counts_of(const VerifyResult& result) {
  std::string text;
  for (const CellResult& cell : result.cells) {
    nlohmann::json row = nlohmann::json::parse(json_row(cell));
    row.erase("seconds");
    row.erase("exact_over_double");
    text += row.dump() + "\n";
  }
  for (const GrowthResult& growth : result.growths) text += json_row(growth);
  return text;
}

TEST(RunCatalogue, GivesTheSameForAnyNumberOfJobs) {
  const VerifyResult one = run_catalogue(small_catalogue(), {});
  VerifyOptions options;
  options.jobs = 3;
  std::vector<std::size_t> order;
  options.on_cell = [&](std::size_t index, const CellResult&) { order.push_back(index); };
  const VerifyResult three = run_catalogue(small_catalogue(), options);
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 3}));
  EXPECT_EQ(counts_of(one), counts_of(three));
  EXPECT_EQ(one.verdict(), Verdict::kConfirmed) << counts_of(one);
}

TEST(RunCatalogue, KeepsWhatWasFinishedWhenInterrupted) {
  VerifyOptions options;
  std::atomic<int> finished{0};
  options.on_cell = [&](std::size_t, const CellResult&) { ++finished; };
  options.go_on = [&] { return finished < 2; };
  const VerifyResult result = run_catalogue(small_catalogue(), options);
  EXPECT_TRUE(result.interrupted);
  EXPECT_EQ(result.cells.size(), 2u);
}

std::atomic<bool> study_began{false};

StudyResult long_study(bool, const std::function<bool()>& go_on) {
  study_began = true;
  StudyResult result;
  if (go_on()) result.checks.resize(100);
  return result;
}

// What the last study has done by then is not all of it.
TEST(RunCatalogue, KnowsThatItsLastStudyWasInterrupted) {
  Catalogue catalogue;
  catalogue.studies.push_back({"study", long_study, true});
  VerifyOptions options;
  EXPECT_FALSE(run_catalogue(catalogue, options).interrupted);
  study_began = false;
  options.go_on = [] { return !study_began; };
  const VerifyResult result = run_catalogue(catalogue, options);
  EXPECT_TRUE(result.interrupted);
  EXPECT_TRUE(result.studies.empty());
}

}  // namespace
}  // namespace kinex
