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
namespace runner_test {

using test::Folder;
using test::random_cell;
using test::run;
using test::small_catalogue;
using test::sorting_cell;
using ::testing::HasSubstr;

TEST(RunCell, PassesATrueExpectation) {
  const lab::CellResult result = run(sorting_cell(28));
  EXPECT_EQ(result.verdict(), lab::Verdict::kConfirmed) << verify::table_row(result);
  EXPECT_EQ(result.trials.size(), 1u);
  EXPECT_TRUE(result.kept.empty());
  ASSERT_TRUE(result.contest);
  EXPECT_TRUE(result.contest->same_counts);
}

TEST(RunCell, FailsAFalseExpectationAndKeepsTheScene) {
  const Folder folder;
  verify::VerifyOptions options;
  options.keep_folder = folder.name();
  const lab::CellResult result = run(sorting_cell(29), options);
  EXPECT_EQ(result.verdict(), lab::Verdict::kRefuted);
  EXPECT_EQ(result.checks.front().expected, "29");
  EXPECT_EQ(result.checks.front().observed, "28");
  ASSERT_EQ(result.kept.size(), 1u);
  const Scene kept = formats::read_scene(result.kept.front());
  EXPECT_EQ(formats::scene_hash(kept), result.trials.front().measurement.scene_hash);
  EXPECT_THAT(verify::table_row(result), HasSubstr("FAIL test.claim processed: expected 29, observed 28"));
}

Integer one_more(const Scene& scene) { return families::inversions(scene) + Integer(1); }

TEST(RunCell, ChecksEverySceneAgainstItsWitness) {
  lab::Cell cell = random_cell(12, 5);
  EXPECT_EQ(run(cell).verdict(), lab::Verdict::kConfirmed);
  cell.expectations.back().witness = one_more;
  EXPECT_EQ(run(cell).verdict(), lab::Verdict::kRefuted);
}

TEST(RunCell, ThrowsAreFailures) {
  lab::Cell cell = sorting_cell(28);
  cell.expectations.back().quantity = "no such count";
  EXPECT_THROW(lab::judge(cell, run(sorting_cell(28)).trials), std::invalid_argument);
  cell = random_cell(12, 2);
  cell.parameters.degree = 2;  // the witness is for lines only
  const lab::CellResult result = run(cell);
  EXPECT_EQ(result.verdict(), lab::Verdict::kRefuted);
  EXPECT_THAT(result.checks.back().observed, HasSubstr("not linear"));
}

TEST(RunCell, SaysWhenItGaveUp) {
  lab::Cell cell = random_cell(300, 1);
  cell.max_seconds = 1e-9;
  const lab::CellResult result = run(cell);
  EXPECT_EQ(result.verdict(), lab::Verdict::kGaveUp) << verify::table_row(result);
  EXPECT_THAT(verify::table_row(result), HasSubstr("GAVE UP run"));
}

TEST(RunCell, AddsSeedsUntilTheMeanIsKnown) {
  lab::Cell cell = random_cell(16, 4);
  cell.max_seeds = 1000;
  cell.precise = {{"processed", 0.05}};
  const lab::CellResult result = run(cell);
  EXPECT_GT(result.trials.size(), 4u);
  EXPECT_LT(result.trials.size(), 100u);
  const lab::RunningMean mean = lab::mean_of(result.trials, "processed");
  EXPECT_LE(mean.standard_error(), 0.05 * mean.mean());
  verify::VerifyOptions options;
  options.seeds = 3;
  EXPECT_EQ(run(cell, options).trials.size(), 3u);
}

// Everything but times.
std::string counts_of(const verify::VerifyResult& result) {
  std::string text;
  for (const lab::CellResult& cell : result.cells) {
    nlohmann::json row = nlohmann::json::parse(verify::json_row(cell));
    row.erase("seconds");
    row.erase("exact_over_double");
    text += row.dump() + "\n";
  }
  for (const lab::GrowthResult& growth : result.growths) text += verify::json_row(growth);
  return text;
}

TEST(RunCatalogue, GivesTheSameForAnyNumberOfJobs) {
  const verify::VerifyResult one = verify::run_catalogue(small_catalogue(), {});
  verify::VerifyOptions options;
  options.jobs = 3;
  std::vector<std::size_t> order;
  options.on_cell = [&](std::size_t index, const lab::CellResult&) { order.push_back(index); };
  const verify::VerifyResult three = verify::run_catalogue(small_catalogue(), options);
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 3}));
  EXPECT_EQ(counts_of(one), counts_of(three));
  EXPECT_EQ(one.verdict(), lab::Verdict::kConfirmed) << counts_of(one);
}

TEST(RunCatalogue, KeepsWhatWasFinishedWhenInterrupted) {
  verify::VerifyOptions options;
  std::atomic<int> finished{0};
  options.on_cell = [&](std::size_t, const lab::CellResult&) { ++finished; };
  options.source.go_on = [&] { return finished < 2; };
  const verify::VerifyResult result = verify::run_catalogue(small_catalogue(), options);
  EXPECT_TRUE(result.interrupted);
  EXPECT_EQ(result.cells.size(), 2u);
}

std::atomic<bool> study_began{false};

lab::StudyResult long_study(bool, const std::function<bool()>& go_on) {
  study_began = true;
  lab::StudyResult result;
  if (go_on()) result.checks.resize(100);
  return result;
}

// What the last study has done by then is not all of it.
TEST(RunCatalogue, KnowsThatItsLastStudyWasInterrupted) {
  lab::Catalogue catalogue;
  catalogue.studies.push_back({"study", long_study, true});
  verify::VerifyOptions options;
  EXPECT_FALSE(verify::run_catalogue(catalogue, options).interrupted);
  study_began = false;
  options.source.go_on = [] { return !study_began; };
  const verify::VerifyResult result = verify::run_catalogue(catalogue, options);
  EXPECT_TRUE(result.interrupted);
  EXPECT_TRUE(result.studies.empty());
}

}  // namespace runner_test
}  // namespace kinex
