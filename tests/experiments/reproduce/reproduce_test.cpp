// SPDX-License-Identifier: GPL-3.0-or-later
// What `kinex reproduce` is made of: records that a later run goes on from, fits, claims, files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "experiments/families/collision/separation_paper.h"
#include "experiments/families/hull/experiments.h"
#include "experiments/families/hull/polynomial_weights.h"
#include "experiments/formats/file_io.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_document.h"
#include "experiments/lab/fit.h"
#include "experiments/lab/record_store.h"
#include "experiments/reproduce/paper_files.h"
#include "experiments/reproduce/papers.h"

namespace kinex {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "kinex-test-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~Folder() { fs::remove_all(path_); }
  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

lab::RunKey small_run(const std::string& structure, int n = 20) {
  lab::RunKey key;
  key.structure = structure;
  key.workload = "uniform-square";
  key.n = n;
  return key;
}

const auto kGoOn = [] { return true; };

TEST(RunRecord, SurvivesItsLine) {
  lab::RunKey key = small_run("convex_hull_2_delaunay");
  key.forever = true;
  const lab::RunRecord record = lab::run_record(key, kGoOn).value();
  EXPECT_EQ(record.key, "convex_hull_2_delaunay uniform-square n=20 d=2 seed=1 forever");
  EXPECT_TRUE(record.clean) << record.trouble;
  EXPECT_GT(record.external, 0u);
  EXPECT_GT(record.processed, record.external);  // the flips of the triangulation are counted
  ASSERT_EQ(record.solved.size(), 5u);
  EXPECT_GT(record.solved[4], record.solved[2]);
  const lab::RunRecord again = lab::parse_record(lab::record_line(record), "file", 1);
  EXPECT_EQ(lab::record_line(again), lab::record_line(record));
  EXPECT_EQ(again.kinds, record.kinds);
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

TEST(RecordStore, GoesOnWhereItWas) {
  const Folder folder;
  const std::string path = folder.file("runs.jsonl");
  lab::SeriesPoint point;
  point.key = small_run("sorted_list");
  point.key.dimension = 1;
  point.precise = "processed";
  point.min_seeds = point.max_seeds = 3;
  int runs = 0;
  lab::SeriesOptions options;
  options.on_run = [&](std::size_t, const std::string&) { ++runs; };
  double mean = 0;
  {
    lab::RecordStore store(path, "commit", false);
    const lab::SeriesRun run = lab::run_series({point}, store, options);
    ASSERT_EQ(run.results.size(), 1u);
    mean = run.results[0].mean("processed").mean();
    EXPECT_EQ(runs, 3);
    EXPECT_EQ(store.size(), 3u);
  }
  // What a killed program leaves: half a line.
  std::ofstream(path, std::ios::app | std::ios::binary) << "{\"run\": \"sorted_list uni";
  point.min_seeds = point.max_seeds = 4;
  lab::RecordStore store(path, "commit", false);
  EXPECT_EQ(store.size(), 3u);
  const lab::SeriesRun run = lab::run_series({point}, store, options);
  EXPECT_EQ(runs, 4);
  lab::RunningMean first;
  for (std::size_t k = 0; k < 3; ++k) {
    first.add(static_cast<double>(run.results[0].runs[k].processed));
  }
  EXPECT_EQ(first.mean(), mean);
  EXPECT_THROW(lab::RecordStore(path, "another commit", false), formats::InputError);
  EXPECT_EQ(lab::RecordStore(path, "another commit", true).size(), 0u);
}

TEST(RecordStore, RefusesWhatIsNoRecord) {
  const Folder folder;
  const std::string path = folder.file("runs.jsonl");
  std::ofstream(path) << "{\"kinex_runs\": 1, \"commit\": \"c\"}\n{\"run\": \"x\"}\n";
  try {
    lab::RecordStore store(path, "c", false);
    FAIL();
  } catch (const formats::InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("line 2"));
    EXPECT_THAT(error.what(), HasSubstr("processed"));
  }
}

TEST(Series, SeedsGoOnUntilTheMeanIsPrecise) {
  const Folder folder;
  lab::RecordStore store(folder.file("runs.jsonl"), "commit", false);
  lab::SeriesPoint point;
  point.key = small_run("sorted_list");
  point.key.dimension = 1;
  point.precise = "processed";
  point.min_seeds = 2;
  point.max_seeds = 500;
  point.relative_error = 0.03;
  const lab::SeriesRun run = lab::run_series({point}, store, {});
  const lab::RunningMean mean = run.results[0].mean("processed");
  EXPECT_GT(mean.count(), 5u);
  EXPECT_LE(mean.standard_error(), 0.03 * mean.mean());
  EXPECT_NEAR(mean.mean(), 20 * 19 / 4.0, 4 * mean.standard_error());
  EXPECT_THROW(lab::quantity_of(run.results[0].runs[0], "colour"), std::invalid_argument);
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
                            "observed", "verdict"}) {
    ASSERT_NE(one.find(field), nullptr) << field;
    EXPECT_FALSE(one.find(field)->text().empty()) << field;
  }
  EXPECT_EQ(one.find("verdict")->text(), "refuted");
  EXPECT_EQ(one.find("assumptions")->items().size(), 2u);
  ASSERT_NE(one.find("checked_by"), nullptr);
  EXPECT_EQ(one.find("checked_by")->find("verdict")->text(), "not checked: nothing moves");
  const std::string readme = reproduce::paper_readme(reproduce::papers()[0], {part}, {}, false);
  EXPECT_THAT(readme, HasSubstr("**refuted**"));
  EXPECT_THAT(readme, HasSubstr("**Failed:** an audit"));
  EXPECT_THAT(readme, HasSubstr("checked by a second program: not checked: nothing moves"));
  EXPECT_THAT(readme, Not(HasSubstr(".svg")));
}

}  // namespace
}  // namespace kinex
