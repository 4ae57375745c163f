// SPDX-License-Identifier: GPL-3.0-or-later
// Verdicts, the runner, and what is written: a false expectation, a broken bound and a failed audit
// must all be seen.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "experiments/scene_reader.h"
#include "experiments/scene_writer.h"
#include "experiments/verify/catalogue.h"
#include "experiments/verify/database.h"
#include "experiments/verify/page.h"
#include "experiments/verify/plots.h"
#include "experiments/verify/report_text.h"
#include "experiments/verify/witness.h"

namespace kinex {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

class Folder {
 public:
  Folder()
      : path_(fs::temp_directory_path() / ("kinex-verify-test-" + std::to_string(::getpid()))) {
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  std::string name() const { return path_.string(); }

 private:
  fs::path path_;
};

Expectation expects(ExpectationKind kind, const char* quantity) {
  Expectation expectation;
  expectation.claim = "test.claim";
  expectation.kind = kind;
  expectation.quantity = quantity;
  expectation.source = "this test";
  return expectation;
}

// 28 swaps.
Cell sorting_cell(int swaps) {
  Cell cell;
  cell.question = "A test?";
  cell.structure = "sorted_list";
  cell.workload = "sort-worst";
  cell.parameters.n = 8;
  cell.family = "worst case";
  cell.expectations.push_back(expects(ExpectationKind::kExact, "processed"));
  cell.expectations.back().exact = Integer(swaps);
  return cell;
}

Cell random_cell(int n, int seeds) {
  Cell cell;
  cell.question = "A test?";
  cell.structure = "sorted_list";
  cell.workload = "uniform-square";
  cell.parameters.n = n;
  cell.parameters.dimension = 1;
  cell.family = "uniform";
  cell.random = true;
  cell.min_seeds = cell.max_seeds = seeds;
  cell.expectations.push_back(expects(ExpectationKind::kWitness, "processed"));
  cell.expectations.back().witness = inversions;
  return cell;
}

CellResult run(const Cell& cell, VerifyOptions options = {}) {
  return run_cell(cell, options, nullptr).value();
}

TEST(RunCell, PassesATrueExpectation) {
  const CellResult result = run(sorting_cell(28));
  EXPECT_EQ(result.verdict(), Verdict::kPass) << table_row(result);
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
  EXPECT_EQ(result.verdict(), Verdict::kFail);
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
  EXPECT_EQ(run(cell).verdict(), Verdict::kPass);
  cell.expectations.back().witness = one_more;
  EXPECT_EQ(run(cell).verdict(), Verdict::kFail);
}

TEST(RunCell, ThrowsAreFailures) {
  Cell cell = sorting_cell(28);
  cell.expectations.back().quantity = "no such count";
  EXPECT_THROW(judge(cell, run(sorting_cell(28)).trials), std::invalid_argument);
  cell = random_cell(12, 2);
  cell.parameters.degree = 2;  // the witness is for lines only
  const CellResult result = run(cell);
  EXPECT_EQ(result.verdict(), Verdict::kFail);
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

TEST(Judge, MeansAreComparedInStandardErrors) {
  Cell cell = random_cell(16, 30);
  cell.expectations = {expects(ExpectationKind::kMean, "processed")};
  Expectation& expectation = cell.expectations.front();
  const std::vector<Trial> trials = run(cell).trials;
  const RunningMean mean = mean_of(trials, "processed");
  const auto verdict = [&](double errors) {
    expectation.reference = mean.mean() + errors * mean.standard_error();
    return judge(cell, trials).front().verdict;
  };
  EXPECT_EQ(verdict(1.99), Verdict::kPass);
  EXPECT_EQ(verdict(-2.01), Verdict::kFail);
  expectation.comparisons = 6;
  EXPECT_EQ(verdict(-2.01), Verdict::kPass);
  EXPECT_EQ(verdict(2.7), Verdict::kFail);
  cell.precise = {{"processed", 1e-6}};
  EXPECT_EQ(verdict(1), Verdict::kInconclusive);
  EXPECT_EQ(verdict(3), Verdict::kFail);
}

// Of one scene there is no spread: neither a PASS nor a FAIL, however far off it is.
TEST(Judge, FewerScenesThanItTakesSayNothing) {
  Cell cell = random_cell(16, 8);
  cell.max_seeds = 400;
  cell.precise = {{"processed", 0.05}};
  cell.expectations = {expects(ExpectationKind::kMean, "processed")};
  const CellResult all = run(cell);
  for (const double reference : {mean_of(all.trials, "processed").mean(), 1e6}) {
    cell.expectations.front().reference = reference;
    for (const std::size_t seeds : {1, 2, 3, 5, 7}) {
      const std::vector<Trial> few(all.trials.begin(),
                                   all.trials.begin() + static_cast<std::ptrdiff_t>(seeds));
      const Check check = judge(cell, few).front();
      EXPECT_EQ(check.verdict, Verdict::kInconclusive) << seeds;
      EXPECT_GE(check.seeds_needed, 8) << seeds;
      EXPECT_THAT(check.observed, Not(HasSubstr("inf")));
      EXPECT_THAT(check.observed, HasSubstr("about " + std::to_string(check.seeds_needed)));
    }
  }
  EXPECT_EQ(judge(cell, all.trials).front().verdict, Verdict::kFail);
  EXPECT_EQ(judge(cell, all.trials).front().seeds_needed, 0);
}

TEST(Report, SaysHowManyScenesWouldDo) {
  VerifyResult result;
  CellResult cell;
  cell.checks = {{"a", "mean", "processed", "1", "2", "", Verdict::kInconclusive, {}, 12},
                 {"b", "mean", "processed", "1", "2", "", Verdict::kInconclusive, {}, 40},
                 {"c", "exact", "processed", "1", "1", "", Verdict::kPass, {}, 0}};
  result.cells = {cell};
  EXPECT_THAT(closing_line(result), HasSubstr("for 2 checks: --seeds 40 would do"));
  result.cells.front().checks.resize(1);
  EXPECT_THAT(closing_line(result), HasSubstr("for 1 check: --seeds 12 would do"));
  result.cells.clear();
  EXPECT_THAT(closing_line(result), Not(HasSubstr("--seeds")));
}

TEST(Judge, SeesABrokenBoundInAnyTrial) {
  Cell cell = random_cell(8, 3);
  std::vector<Trial> trials = run(cell).trials;
  ASSERT_FALSE(trials[1].measurement.bounds.empty());
  BoundCheck& bound = trials[1].measurement.bounds.front();
  bound.observed = bound.bound + Integer(1);
  bound.holds = false;
  bool seen = false;
  for (const Check& check : judge(cell, trials)) {
    if (check.verdict == Verdict::kPass) continue;
    seen = true;
    EXPECT_EQ(check.claim, bound.id);
    EXPECT_EQ(check.kind, "bound");
    EXPECT_EQ(check.trial, 1u);
  }
  EXPECT_TRUE(seen);
}

TEST(Judge, MissesABoundThatIsNotChecked) {
  Cell cell = random_cell(8, 2);
  std::vector<Trial> trials = run(cell).trials;
  const auto verdict = [&] {
    Verdict worst = Verdict::kPass;
    for (const Check& check : judge(cell, trials)) worst = std::max(worst, check.verdict);
    return worst;
  };
  cell.bounded = true;
  EXPECT_EQ(verdict(), Verdict::kPass);
  trials[1].measurement.bounds.clear();
  EXPECT_EQ(verdict(), Verdict::kFail);
  cell.bounded = false;
  EXPECT_EQ(verdict(), Verdict::kPass);
}

TEST(Judge, SeesAFailedAudit) {
  Cell cell = random_cell(8, 2);
  std::vector<Trial> trials = run(cell).trials;
  trials[1].measurement.costs.audit_violations = 1;
  trials[1].measurement.violations = {"a is not before b"};
  const std::vector<Check> checks = judge(cell, trials);
  EXPECT_EQ(checks.back().claim, "audit");
  EXPECT_EQ(checks.back().verdict, Verdict::kFail);
  EXPECT_EQ(checks.back().source, "a is not before b");
}

std::vector<CellResult> constructed_family(double exponent) {
  std::vector<CellResult> cells;
  for (const int n : {100, 200, 400, 800}) {
    CellResult cell;
    cell.cell.structure = "sorted_list";
    cell.cell.family = "constructed";
    cell.cell.parameters.n = n;
    for (const int departure : {-1, 0, 1}) {
      Trial trial;
      trial.measurement.objects = static_cast<std::size_t>(n);
      const double count = 10 * std::pow(n, exponent) * (1 + 0.002 * departure);
      trial.measurement.costs.processed = static_cast<std::uint64_t>(count);
      cell.trials.push_back(trial);
    }
    cells.push_back(cell);
  }
  return cells;
}

template <class Count>
Check judge_as_logarithm(const Count& count, int sizes = 10) {
  std::vector<CellResult> cells;
  for (int k = 0; k < sizes; ++k) {
    const double x = std::floor(3 * std::pow(2, 0.7 * k));
    CellResult cell;
    cell.cell.structure = "sorted_list";
    cell.cell.family = "constructed";
    for (const int departure : {-1, 0, 1}) {
      Trial trial;
      trial.measurement.objects = static_cast<std::size_t>(x);
      trial.measurement.costs.processed =
          static_cast<std::uint64_t>(std::llround(10 * count(x)) + 3 * departure);
      cell.trials.push_back(trial);
    }
    cells.push_back(cell);
  }
  GrowthClaim claim{"test.log", "sorted_list", "constructed", "processed", 1, 0.35, 0.1, ""};
  claim.at_most = claim.logarithm = true;
  return judge_growth(claim, cells).check;
}

// A line, a root, and a line that a large offset hides from the power are no logarithms.
TEST(JudgeGrowth, TellsALogarithmFromALine) {
  const auto verdict = [](const auto& count) { return judge_as_logarithm(count).verdict; };
  EXPECT_EQ(verdict([](double x) { return 4 + 2 * std::log2(x); }), Verdict::kPass);
  EXPECT_EQ(verdict([](double x) { return 30 + std::log2(x); }), Verdict::kPass);
  EXPECT_EQ(verdict([](double) { return 12.0; }), Verdict::kPass);
  EXPECT_EQ(verdict([](double x) { return x; }), Verdict::kFail);
  EXPECT_EQ(verdict([](double x) { return 20 + 0.1 * x; }), Verdict::kFail);
  EXPECT_EQ(verdict([](double x) { return 100 + 0.3 * x; }), Verdict::kFail);
  EXPECT_EQ(verdict([](double x) { return 3 * std::sqrt(x); }), Verdict::kFail);
  EXPECT_EQ(verdict([](double x) { return 10 + 2 * std::sqrt(x); }), Verdict::kFail);
  EXPECT_EQ(judge_as_logarithm([](double x) { return std::log2(x); }, 5).verdict,
            Verdict::kInconclusive);
}

TEST(JudgeGrowth, AcceptsTheExponentWithinTheTolerance) {
  GrowthClaim claim{"test.growth", "sorted_list", "constructed", "processed", 1, 1.5, 0.03, ""};
  EXPECT_EQ(judge_growth(claim, constructed_family(1.5)).check.verdict, Verdict::kPass);
  EXPECT_EQ(judge_growth(claim, constructed_family(1.52)).check.verdict, Verdict::kPass);
  EXPECT_EQ(judge_growth(claim, constructed_family(1.54)).check.verdict, Verdict::kFail);
  EXPECT_EQ(judge_growth(claim, constructed_family(1.46)).check.verdict, Verdict::kFail);
  claim.smallest = 300;
  EXPECT_EQ(judge_growth(claim, constructed_family(1.5)).check.verdict, Verdict::kInconclusive);
  claim.smallest = 1;
  claim.tolerance = 1e-5;
  claim.exponent = judge_growth(claim, constructed_family(1.5)).fit->exponent;
  EXPECT_EQ(judge_growth(claim, constructed_family(1.5)).check.verdict, Verdict::kInconclusive);
}

// The interval decides, not the exponent: fewer data widen it, and never confirm more.
TEST(JudgeGrowth, AWideIntervalConfirmsNothing) {
  const auto family = [](double scatter, double exponent) {
    std::vector<CellResult> cells = constructed_family(exponent);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const double factor = 1 + (i % 2 == 0 ? scatter : -scatter);
      for (Trial& trial : cells[i].trials) {
        std::uint64_t& count = trial.measurement.costs.processed;
        count = static_cast<std::uint64_t>(static_cast<double>(count) * factor);
      }
    }
    return cells;
  };
  GrowthClaim claim{"test.growth", "sorted_list", "constructed", "processed", 1, 1.5, 0.03, ""};
  for (const bool at_most : {false, true}) {
    claim.at_most = at_most;
    const auto verdict = [&](double scatter, double exponent) {
      return judge_growth(claim, family(scatter, exponent)).check.verdict;
    };
    EXPECT_EQ(verdict(0.001, 1.5), Verdict::kPass);
    EXPECT_EQ(verdict(0.1, 1.5), Verdict::kInconclusive);
    EXPECT_EQ(verdict(0.1, 1.6), Verdict::kInconclusive);  // off, but it may be chance
    EXPECT_EQ(verdict(0.1, 3), Verdict::kFail);
    EXPECT_EQ(verdict(0.001, 1), at_most ? Verdict::kPass : Verdict::kFail);
  }
}

TEST(JudgeGrowth, WantsTheScenesThatACellNeeds) {
  GrowthClaim claim{"test.growth", "sorted_list", "constructed", "processed", 1, 1.5, 0.03, ""};
  for (const double exponent : {1.5, 3.0}) {
    std::vector<CellResult> cells = constructed_family(exponent);
    cells[2].cell.min_seeds = 8;
    const Check check = judge_growth(claim, cells).check;
    EXPECT_EQ(check.verdict, Verdict::kInconclusive);
    EXPECT_EQ(check.seeds_needed, 8);
    for (CellResult& cell : cells) cell.trials.resize(1);
    cells[2].cell.min_seeds = 1;
    // Exact counts: three sizes may lie on a power by chance.
    cells.resize(3);
    EXPECT_EQ(judge_growth(claim, cells).check.verdict,
              exponent == 1.5 ? Verdict::kInconclusive : Verdict::kFail);
  }
}

// A curve of hard bounds is that of one family, through the bounds of its own runs.
TEST(Figures, BoundsAreNotJoinedAcrossFamilies) {
  VerifyResult result;
  for (const char* family : {"tight", "loose"}) {
    for (const int n : {10, 20, 40, 80}) {
      CellResult cell;
      cell.cell.structure = "sorted_list";
      cell.cell.family = family;
      Trial trial;
      trial.measurement.objects = static_cast<std::size_t>(n);
      trial.measurement.costs.processed = static_cast<std::uint64_t>(n);
      const int bound = family[0] == 't' ? n + 1 : 1000 * n;
      trial.measurement.bounds = {{"sorted_list.swaps", "", Integer(bound), Integer(n), true}};
      cell.trials = {trial};
      result.cells.push_back(cell);
    }
  }
  // Other sizes of the loose family lie between those of the tight one.
  for (std::size_t i = 4; i < 8; ++i) result.cells[i].trials[0].measurement.objects += 3;
  const std::vector<Figure> figures = verify_figures(result);
  ASSERT_EQ(figures.size(), 1u);
  const std::string& script = figures[0].script;
  const auto block = [&](const std::string& name) {
    const std::size_t begin = script.find("$" + name + " << EOD\n");
    EXPECT_NE(begin, script.npos) << name;
    return script.substr(begin, script.find("EOD\n", begin + name.size() + 9) - begin);
  };
  EXPECT_THAT(block("bound0"), HasSubstr("\n10 11 "));
  EXPECT_THAT(block("bound0"), Not(HasSubstr("000 ")));
  EXPECT_THAT(block("bound1"), HasSubstr("\n13 10000 "));
  EXPECT_THAT(block("bound1"), Not(HasSubstr("\n10 ")));
  // A size without a bound: no curve is drawn through it.
  result.cells[1].trials[0].measurement.bounds.clear();
  EXPECT_THAT(verify_figures(result)[0].script, Not(HasSubstr("$bound0")));
}

TEST(Figures, ChiSquareIsSaidOnlyOfCountsWithErrors) {
  GrowthClaim claim{"test.growth", "sorted_list", "constructed", "processed", 1, 1.5, 0.03, ""};
  VerifyResult result;
  result.cells = constructed_family(1.5);
  result.growths = {judge_growth(claim, result.cells)};
  const auto caption = [&] { return verify_figures(result).back().caption; };
  EXPECT_THAT(caption(), HasSubstr("chi^2"));
  EXPECT_THAT(json_row(result.growths[0]), Not(HasSubstr("\"chi_square\": null")));
  for (CellResult& cell : result.cells) cell.trials.resize(1);
  result.growths = {judge_growth(claim, result.cells)};
  EXPECT_THAT(caption(), Not(HasSubstr("chi^2")));
  EXPECT_THAT(json_row(result.growths[0]), HasSubstr("\"chi_square\": null"));
}

// ---- several cells --------------------------------------------------------------------------

Catalogue small_catalogue() {
  Catalogue catalogue;
  for (const int n : {8, 16, 32}) catalogue.cells.push_back(random_cell(n, 3));
  catalogue.cells.push_back(sorting_cell(28));
  catalogue.growths.push_back(
      {"test.growth", "sorted_list", "uniform", "processed", 1, 2, 10, "this test"});
  return catalogue;
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
  EXPECT_EQ(one.verdict(), Verdict::kPass) << counts_of(one);
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

// ---- what is written ------------------------------------------------------------------------

VerifyResult small_result() { return run_catalogue(small_catalogue(), {}); }

struct CloseHandle {
  void operator()(sqlite3* handle) const { sqlite3_close(handle); }
};

// The first column of every row, joined by spaces.
std::string query(sqlite3* handle, const std::string& sql) {
  std::string text;
  char* message = nullptr;
  const auto add = [](void* out, int, char** values, char**) {
    std::string& joined = *static_cast<std::string*>(out);
    joined += (joined.empty() ? "" : " ") + std::string(values[0] == nullptr ? "NULL" : values[0]);
    return 0;
  };
  if (sqlite3_exec(handle, sql.c_str(), add, &text, &message) != SQLITE_OK) {
    text = std::string("error: ") + message;
    sqlite3_free(message);
  }
  return text;
}

TEST(VerifyDatabase, IsReadableStrictAndComplete) {
  const Folder folder;
  const std::string path = folder.name() + "/verify.sqlite";
  const VerifyResult result = small_result();
  std::ofstream(path, std::ios::binary) << verify_database(result, build_facts(), machine_facts());
  sqlite3* opened = nullptr;
  ASSERT_EQ(sqlite3_open_v2(path.c_str(), &opened, SQLITE_OPEN_READONLY, nullptr), SQLITE_OK);
  const std::unique_ptr<sqlite3, CloseHandle> handle(opened);
  EXPECT_EQ(query(opened, "PRAGMA integrity_check"), "ok");
  EXPECT_EQ(query(opened, "PRAGMA foreign_key_check"), "");
  EXPECT_EQ(query(opened, "SELECT count(*) FROM sqlite_schema WHERE type = 'table'"), "9");
  EXPECT_EQ(query(opened,
                  "SELECT count(*) FROM pragma_table_list WHERE schema = 'main' AND "
                  "strict = 0 AND name NOT LIKE 'sqlite%'"),
            "0");
  EXPECT_EQ(query(opened, "SELECT count(*) FROM build, machine"), "1");
  EXPECT_EQ(query(opened, "SELECT count(*) FROM cell"), "4");
  EXPECT_EQ(query(opened, "SELECT count(*) FROM run WHERE number_mode = 'exact'"), "10");
  EXPECT_EQ(query(opened, "SELECT count(*) FROM run WHERE number_mode = 'double'"), "4");
  EXPECT_EQ(query(opened,
                  "SELECT value FROM counter JOIN run ON run.id = run_id JOIN cell ON cell.id = "
                  "cell_id WHERE name = 'processed' AND workload = 'sort-worst' AND number_mode = "
                  "'exact'"),
            "28");
  EXPECT_EQ(query(opened,
                  "SELECT expected || '=' || observed || verdict FROM claim_result WHERE claim_id "
                  "= 'test.claim' AND kind = 'exact'"),
            "28=28PASS");
  EXPECT_EQ(query(opened, "SELECT count(*) FROM growth WHERE exponent IS NOT NULL"), "1");
}

TEST(VerifyPage, HoldsTablesPlotsAndNothingFromOutside) {
  const VerifyResult result = small_result();
  const std::vector<Figure> figures = verify_figures(result);
  ASSERT_EQ(figures.size(), 2u);  // counts, and residuals of the fit
  PageFacts facts;
  facts.command = "kinex verify <test>";
  facts.build = build_facts();
  facts.machine = machine_facts();
  const Drawings drawings = draw(figures);
  ASSERT_EQ(drawings.problem, "");
  for (const std::string& svg : drawings.svg) EXPECT_THAT(svg, HasSubstr("<svg"));
  const std::string page = verify_page(result, figures, drawings, facts);
  EXPECT_THAT(page, HasSubstr("data:image/svg+xml;base64,"));
  EXPECT_THAT(page, HasSubstr("kinex verify &lt;test&gt;"));
  EXPECT_THAT(page, HasSubstr("sorted_list: events over n"));
  EXPECT_THAT(page, HasSubstr("sorted_list.swaps"));
  EXPECT_THAT(page, Not(HasSubstr("What did not pass")));
  EXPECT_THAT(page, Not(HasSubstr("http")));
  EXPECT_THAT(page, Not(HasSubstr("<script")));
}

TEST(VerifyPage, SaysWhatFailedAndThatThereAreNoPlots) {
  Catalogue catalogue = small_catalogue();
  catalogue.cells.back() = sorting_cell(29);
  const VerifyResult result = run_catalogue(catalogue, {});
  EXPECT_EQ(result.verdict(), Verdict::kFail);
  const std::vector<Figure> figures = verify_figures(result);
  const Drawings drawings = draw(figures, "no-such-gnuplot");
  EXPECT_EQ(drawings.problem, "no-such-gnuplot is not installed");
  const std::string page = verify_page(result, figures, drawings, {});
  EXPECT_THAT(page, HasSubstr("What did not pass"));
  EXPECT_THAT(page, HasSubstr("no-such-gnuplot is not installed"));
  EXPECT_THAT(page, Not(HasSubstr("<img")));
  EXPECT_THAT(page, HasSubstr("sorted_list.swaps"));
}

TEST(Table, HasOneAlignedLinePerCell) {
  const std::string header = table_header();
  const std::string row = table_row(run(sorting_cell(28)));
  EXPECT_EQ(std::count(row.begin(), row.end(), '\n'), 1);
  EXPECT_EQ(header.find("verdict"), row.find("PASS"));
  const CellRow cells = cell_row(run(sorting_cell(28)));
  EXPECT_EQ(cells.external, "28");
  EXPECT_EQ(cells.internal, "0");
  EXPECT_EQ(cells.bound, "28");
  EXPECT_EQ(cells.observed, "28");
}

}  // namespace
}  // namespace kinex
