// SPDX-License-Identifier: GPL-3.0-or-later
// What `kinex verify` writes: figures, the database, the page and the table.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <memory>

#include "experiments/verify/database.h"
#include "experiments/verify/report.h"
#include "experiments/verify/plots.h"
#include "experiments/verify/report_text.h"
#include "tests/experiments/verify/cells.h"
#include "tests/experiments/verify/folder.h"

namespace kinex {
namespace report_test {

using test::constructed_family;
using test::Folder;
using test::run;
using test::small_catalogue;
using test::sorting_cell;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(Report, SaysHowManyScenesWouldDo) {
  verify::VerifyResult result;
  lab::CellResult cell;
  cell.checks = {{"a", "mean", "processed", "1", "2", "", lab::Verdict::kOpen, {}, 12},
                 {"b", "mean", "processed", "1", "2", "", lab::Verdict::kOpen, {}, 40},
                 {"c", "exact", "processed", "1", "1", "", lab::Verdict::kConfirmed, {}, 0}};
  result.cells = {cell};
  EXPECT_THAT(verify::seeds_line(result), HasSubstr("for 2 checks: --seeds 40 would do"));
  EXPECT_EQ(verify::verdict_line(result, {3, 0}), "0 of 1 hold; 0 fail; 1 inconclusive; 3 s");
  result.cells.front().checks.resize(1);
  EXPECT_THAT(verify::seeds_line(result), HasSubstr("for 1 check: --seeds 12 would do"));
  result.cells.clear();
  EXPECT_EQ(verify::seeds_line(result), "");
}

TEST(Report, VerdictComesInOneLine) {
  verify::VerifyResult result;
  lab::CellResult good, bad;
  good.checks = {{"a", "exact", "processed", "1", "1", "", lab::Verdict::kConfirmed, {}, 0}};
  bad.checks = {{"b", "exact", "processed", "1", "2", "", lab::Verdict::kRefuted, {}, 0}};
  result.cells = {good, good, bad};
  EXPECT_EQ(verify::verdict_line(result, {300, 0}), "2 of 3 hold; 1 fails; 5 min");
  // Resumed: the time of this command alone would be too little.
  EXPECT_EQ(verify::verdict_line(result, {60, 240}),
            "2 of 3 hold; 1 fails; 5 min, 4 min of them by earlier commands");
  result.cells = {good};
  EXPECT_EQ(verify::verdict_line(result, {9000, 0}), "1 of 1 holds; 0 fail; 2.5 h");
  EXPECT_EQ(verify::work_line(result),
            "1 cell and 0 fits: 1 check, 0 runs, 0 certificate failures");
  // Fits of fewer sizes than their claims ask for neither hold nor fail.
  lab::GrowthResult part;
  part.check.verdict = lab::Verdict::kAgrees;
  result.growths = {part};
  EXPECT_EQ(verify::verdict_line(result, {3, 0}),
            "1 of 2 holds; 0 fail; 1 agrees, of fewer sizes than its claim asks for; 3 s");
  result.growths = {part, part};
  EXPECT_THAT(verify::verdict_line(result, {3, 0}),
              HasSubstr("; 2 agree, of fewer sizes than their claims ask for; "));
  EXPECT_EQ(result.verdict(), lab::Verdict::kAgrees);
  result.interrupted = true;
  EXPECT_THAT(verify::verdict_line(result, {1, 0}), HasSubstr("; interrupted; "));
}

// A curve of hard bounds is that of one family, through the bounds of its own runs.
TEST(Figures, BoundsAreNotJoinedAcrossFamilies) {
  verify::VerifyResult result;
  for (const char* family : {"tight", "loose"}) {
    for (const int n : {10, 20, 40, 80}) {
      lab::CellResult cell;
      cell.cell.structure = "sorted_list";
      cell.cell.family = family;
      lab::Trial trial;
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
  const std::vector<lab::Figure> figures = verify::verify_figures(result);
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
  EXPECT_THAT(verify::verify_figures(result)[0].script, Not(HasSubstr("$bound0")));
}

// A bound far above the counts does not flatten them; the legend tells where it is.
TEST(Figures, DistantBoundsStayOutside) {
  verify::VerifyResult result;
  for (const int n : {10, 20, 40, 80}) {
    lab::CellResult cell;
    cell.cell.structure = "sorted_list";
    cell.cell.family = "one";
    lab::Trial trial;
    trial.measurement.objects = static_cast<std::size_t>(n);
    trial.measurement.costs.processed = static_cast<std::uint64_t>(n);
    trial.measurement.bounds = {{"sorted_list.swaps", "", Integer(1000000 * n), Integer(n), true}};
    cell.trials = {trial};
    result.cells.push_back(cell);
  }
  const std::string script = verify::verify_figures(result).at(0).script;
  EXPECT_THAT(script, HasSubstr("hard bound, one, above: 1e+07 at 10"));
  const std::size_t at = script.find("set yrange [");
  EXPECT_LT(std::stod(script.substr(script.find(':', at) + 1)), 10000);
}

// A row says which count was fitted, over which sizes, unless the fit passes.
TEST(Report, RowsOfFitsSayWhatDecides) {
  lab::GrowthResult growth;
  growth.claim = {"test.growth", "sorted_list", "constructed", "processed", 2, 2, 0.03, ""};
  growth.points = {{10, 100, 0}, {20, 400, 0}};
  growth.check = {"test.growth",         "growth",   "processed",
                  "n^(2 +-0.03)",        "n^2.0000", "",
                  lab::Verdict::kAgrees, {},         0};
  EXPECT_THAT(verify::table_row(growth),
              HasSubstr("  AGREES\n  AGREES test.growth: decided by the fit of processed over 2 "
                        "sizes, n = 10 to 20\n"));
  growth.axis = "m";
  growth.check.verdict = lab::Verdict::kOpen;
  EXPECT_THAT(
      verify::table_row(growth),
      HasSubstr(
          "  INCONCLUSIVE test.growth: decided by the fit of processed over 2 sizes, m = 10"));
  growth.check.verdict = lab::Verdict::kConfirmed;
  EXPECT_THAT(verify::table_row(growth), Not(HasSubstr("decided by")));
}

// What is left of an exact power is rounding: no picture of it.
TEST(Figures, RoundingIsNotDrawn) {
  lab::GrowthClaim claim{"test.growth", "sorted_list", "constructed", "processed", 1, 2, 0.03, ""};
  verify::VerifyResult result;
  for (const int n : {10, 20, 40, 80}) {
    lab::CellResult cell;
    cell.cell.structure = "sorted_list";
    cell.cell.family = "constructed";
    lab::Trial trial;
    trial.measurement.objects = static_cast<std::size_t>(n);
    trial.measurement.costs.processed =
        static_cast<std::uint64_t>(n) * static_cast<std::uint64_t>(n);
    cell.trials = {trial};
    result.cells.push_back(cell);
  }
  result.growths = {lab::judge_growth(claim, result.cells)};
  ASSERT_TRUE(result.growths[0].fit);
  EXPECT_EQ(verify::verify_figures(result).size(), 1u);
  ++result.cells[2].trials[0].measurement.costs.processed;
  result.growths = {lab::judge_growth(claim, result.cells)};
  EXPECT_EQ(verify::verify_figures(result).size(), 2u);
}

// The slope that is claimed of what is drawn is beside it; claims of other counts draw none.
TEST(Figures, ClaimedSlopesAreDrawn) {
  lab::GrowthClaim claim{
      "test.growth", "sorted_list", "constructed", "processed", 1, 1.5, 0.03, ""};
  verify::VerifyResult result;
  result.cells = constructed_family(1.5);
  result.growths = {lab::judge_growth(claim, result.cells)};
  const auto script = [&] { return verify::verify_figures(result).front().script; };
  EXPECT_THAT(script(), HasSubstr("title 'slope 1.5'"));
  result.growths[0].claim.quantity = "external";
  EXPECT_THAT(script(), Not(HasSubstr("slope")));
  result.growths[0].claim.quantity = "processed";
  result.growths[0].claim.logs = 1;
  EXPECT_THAT(script(), Not(HasSubstr("slope")));
}

TEST(Figures, ChiSquareIsSaidOnlyOfCountsWithErrors) {
  lab::GrowthClaim claim{"test.growth", "sorted_list", "constructed", "processed", 1, 1.5, 0.03, ""};
  verify::VerifyResult result;
  result.cells = constructed_family(1.5);
  result.growths = {lab::judge_growth(claim, result.cells)};
  const auto caption = [&] { return verify::verify_figures(result).back().caption; };
  EXPECT_THAT(caption(), HasSubstr("chi^2"));
  EXPECT_THAT(verify::json_row(result.growths[0]), Not(HasSubstr("\"chi_square\": null")));
  for (lab::CellResult& cell : result.cells) cell.trials.resize(1);
  result.growths = {lab::judge_growth(claim, result.cells)};
  EXPECT_THAT(caption(), Not(HasSubstr("chi^2")));
  EXPECT_THAT(verify::json_row(result.growths[0]), HasSubstr("\"chi_square\": null"));
}

verify::VerifyResult small_result() { return verify::run_catalogue(small_catalogue(), {}); }

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
  const verify::VerifyResult result = small_result();
  std::ofstream(path, std::ios::binary) << verify::verify_database(result, lab::build_facts(), lab::machine_facts());
  sqlite3* opened = nullptr;
  ASSERT_EQ(sqlite3_open_v2(path.c_str(), &opened, SQLITE_OPEN_READONLY, nullptr), SQLITE_OK);
  const std::unique_ptr<sqlite3, CloseHandle> handle(opened);
  EXPECT_EQ(query(opened, "PRAGMA integrity_check"), "ok");
  EXPECT_EQ(query(opened, "PRAGMA foreign_key_check"), "");
  EXPECT_EQ(query(opened, "SELECT count(*) FROM sqlite_schema WHERE type = 'table'"), "10");
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

// Nowhere is there a ratio of times where doubles handled other events.
TEST(VerifyDatabase, RatiosAreOfTheSameEvents) {
  verify::VerifyResult result;
  result.cells.push_back(run(sorting_cell(28)));
  lab::CellResult& cell = result.cells.front();
  const auto texts = [&](bool same_counts) {
    cell.contest = lab::SpeedContest{cell.trials.front().measurement, 12.5, same_counts};
    cell.contest->rival.arithmetic = "double";
    const Folder folder;
    const std::string path = folder.name() + "/verify.sqlite";
    std::ofstream(path, std::ios::binary)
        << verify::verify_database(result, lab::build_facts(), lab::machine_facts());
    sqlite3* opened = nullptr;
    sqlite3_open_v2(path.c_str(), &opened, SQLITE_OPEN_READONLY, nullptr);
    const std::unique_ptr<sqlite3, CloseHandle> handle(opened);
    const std::string stored = query(opened, "SELECT exact_over_double FROM cell");
    const std::string row = verify::json_row(cell);
    const std::size_t at = row.find("\"exact_over_double\"");
    return std::array{stored, row.substr(at, row.find(',', at) - at), verify::cell_row(cell).ratio};
  };
  EXPECT_THAT(texts(true), ElementsAre("12.5", "\"exact_over_double\": 12.5", "12.50"));
  EXPECT_THAT(texts(false), ElementsAre("NULL", "\"exact_over_double\": null", "differs"));
}

TEST(VerifyPage, HoldsTablesPlotsAndNothingFromOutside) {
  const verify::VerifyResult result = small_result();
  const std::vector<lab::Figure> figures = verify::verify_figures(result);
  ASSERT_EQ(figures.size(), 2u);  // counts, and residuals of the fit
  lab::PageFacts facts;
  facts.command = "kinex verify <test>";
  facts.build = lab::build_facts();
  facts.machine = lab::machine_facts();
  const lab::Drawings drawings = lab::draw(figures);
  ASSERT_EQ(drawings.problem, "");
  for (const std::string& svg : drawings.svg) EXPECT_THAT(svg, HasSubstr("<svg"));
  const std::string page = lab::report_page(verify::verify_report(result, facts), drawings, facts);
  EXPECT_THAT(page, HasSubstr("data:image/svg+xml;base64,"));
  EXPECT_THAT(page, HasSubstr("kinex verify &lt;test&gt;"));
  EXPECT_THAT(page, HasSubstr("sorted_list: events over n"));
  EXPECT_THAT(page, HasSubstr("sorted_list.swaps"));
  EXPECT_THAT(page, Not(HasSubstr("What did not pass")));
  EXPECT_THAT(page, Not(HasSubstr("://")));
  EXPECT_THAT(page, Not(HasSubstr("src=\"/")));
  // The verdict comes first; every cell has an anchor, its scene and the command that makes it.
  EXPECT_LT(page.find("5 of 5 hold; 0 fail"), page.find("<nav"));
  EXPECT_THAT(page, HasSubstr("<tr id=\"cell-sorted_list-sort-worst-n-8\""));
  EXPECT_THAT(page, HasSubstr("kinex gen sort-worst --n 8 --maintain sorted_list -o scene.json"));
  EXPECT_THAT(page, HasSubstr(result.cells[0].trials[0].measurement.scene_hash));
}

TEST(VerifyPage, SaysWhatFailedAndThatThereAreNoPlots) {
  lab::Catalogue catalogue = small_catalogue();
  catalogue.cells.back() = sorting_cell(29);
  const verify::VerifyResult result = verify::run_catalogue(catalogue, {});
  EXPECT_EQ(result.verdict(), lab::Verdict::kRefuted);
  const std::vector<lab::Figure> figures = verify::verify_figures(result);
  const lab::Drawings drawings = lab::draw(figures, "no-such-gnuplot");
  EXPECT_EQ(drawings.problem, "no-such-gnuplot is not installed");
  const std::string page = lab::report_page(verify::verify_report(result, {}), drawings, {});
  EXPECT_THAT(page, HasSubstr("What did not pass"));
  EXPECT_THAT(page, HasSubstr("no-such-gnuplot is not installed"));
  EXPECT_THAT(page, Not(HasSubstr("<img")));
  EXPECT_THAT(page, HasSubstr("sorted_list.swaps"));
}

TEST(Table, HasOneAlignedLinePerCell) {
  const std::string header = verify::table_header();
  // Columns whose titles say too little are in the legend.
  for (const char* column : {"\nbound ", "\nexpected ", "\nobserved ", "\nchecks ", "\nex/dbl "}) {
    EXPECT_THAT(verify::table_legend(), HasSubstr(column));
    EXPECT_THAT(header, HasSubstr(column + 1));
  }
  EXPECT_THAT(verify::table_legend(false), Not(HasSubstr("bound ")));
  const std::string row = verify::table_row(run(sorting_cell(28)));
  EXPECT_EQ(std::count(row.begin(), row.end(), '\n'), 1);
  EXPECT_EQ(header.find("verdict"), row.find("PASS"));
  const verify::CellRow cells = verify::cell_row(run(sorting_cell(28)));
  EXPECT_EQ(cells.external, "28");
  EXPECT_EQ(cells.internal, "0");
  EXPECT_EQ(cells.bound, "28");
  EXPECT_EQ(cells.observed, "28");
}

}  // namespace report_test
}  // namespace kinex
