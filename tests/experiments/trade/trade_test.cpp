// SPDX-License-Identifier: GPL-3.0-or-later
// Whole comparisons, and what is written of them: runs that are known to go wrong must be seen, and
// exact ones must be clean.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "experiments/formats/scene_reader.h"
#include "experiments/lab/family.h"
#include "experiments/trade/database.h"
#include "experiments/trade/markdown.h"
#include "experiments/trade/report.h"
#include "experiments/trade/plots.h"
#include "experiments/trade/report_text.h"
#include "experiments/trade/standings.h"
#include "structures/registry.h"
#include "tests/experiments/expect_input_error.h"

namespace kinex {
namespace trade_test {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

trade::TradeCase make_case(std::string structure, std::string workload, int n, int dimension) {
  trade::TradeCase one;
  one.structure = std::move(structure);
  one.workload = workload;
  one.name = std::move(workload);
  one.parameters.n = n;
  one.parameters.dimension = dimension;
  return one;
}

trade::CaseResult run(const trade::TradeCase& one, std::vector<std::string> arithmetics) {
  trade::TradeOptions options;
  options.arithmetics = std::move(arithmetics);
  return trade::run_case(one, options).value();
}

// A scene as text, which maintains one structure.
trade::TradeCase given_case(const std::string& scene) {
  trade::TradeCase one;
  one.given = std::make_shared<Scene>(formats::parse_scene(scene, "given"));
  one.structure = one.given->maintain.at(0).structure;
  one.name = "given";
  return one;
}

trade::CaseResult nearly() {
  return run(make_case("sorted_list", "near-one-point", 10, 1), {"sturm", "gsl", "mpfr:100"});
}

TEST(TradeCase, OrdinarySceneIsTheSameEverywhere) {
  const trade::CaseResult one =
      run(make_case("delaunay_2", "uniform-square", 8, 2), {"sturm", "gsl", "mpfr:53"});
  EXPECT_TRUE(one.faults().empty());
  ASSERT_EQ(one.runs.size(), 5u);
  EXPECT_EQ(one.runs[0].arithmetic, "exact");
  EXPECT_EQ(one.runs[1].arithmetic, "double");
  for (const trade::TradeRun& run : one.runs) {
    EXPECT_EQ(run.standing(), trade::Standing::kSame) << run.arithmetic;
    EXPECT_EQ(run.events, one.events);
    EXPECT_EQ(run.valid, run.checkpoints);
    EXPECT_GT(run.checkpoints, 7);
    EXPECT_TRUE(run.seconds);
    EXPECT_GT(run.peak_bytes, 0u);
    const bool exact = trade::bits_of_arithmetic(run.arithmetic) == 0;
    EXPECT_EQ(run.deviation.error == 0, exact) << run.arithmetic;
  }
  EXPECT_EQ(one.memory_ratio(one.runs[1]), 1);
}

// A structure that reads another one: its own states are audited, the events of both compared.
TEST(TradeCase, LooksAtTheStructureThatIsAskedFor) {
  const trade::CaseResult lists = run(make_case("sorted_list", "near-one-point", 10, 1), {});
  const trade::CaseResult maxima = run(make_case("maximum_sorted_list", "near-one-point", 10, 1), {});
  EXPECT_TRUE(maxima.faults().empty());
  EXPECT_EQ(lists.events, 45u);
  EXPECT_GT(maxima.events, lists.events);
  for (const trade::CaseResult* one : {&lists, &maxima}) {
    EXPECT_EQ(one->runs.at(1).arithmetic, "double");
    EXPECT_EQ(one->runs.at(1).standing(), trade::Standing::kWrong);
  }
  // Between the crossings the list is wrong more often than its maximum.
  EXPECT_GT(maxima.runs[1].valid, lists.runs[1].valid);
  const trade::CaseResult hull =
      run(make_case("convex_hull_2_delaunay", "uniform-square", 10, 2), {"sturm", "mpfr:53"});
  EXPECT_TRUE(hull.faults().empty());
  for (const trade::TradeRun& run : hull.runs) EXPECT_EQ(run.standing(), trade::Standing::kSame);
}

// Pairs that cross 2^-60 apart cannot be told apart in doubles: the states between are wrong.
TEST(TradeCase, NearlyDegenerateSceneIsWrongInDoubles) {
  const trade::CaseResult one = nearly();
  EXPECT_TRUE(one.faults().empty());
  EXPECT_EQ(one.events, 45u);
  EXPECT_GT(one.bits.most, 60);
  EXPECT_EQ(one.run_in("exact")->standing(), trade::Standing::kSame);
  EXPECT_EQ(one.run_in("sturm")->standing(), trade::Standing::kSame);
  EXPECT_EQ(one.run_in("mpfr:100")->standing(), trade::Standing::kSame);
  for (const char* name : {"double", "gsl"}) {
    const trade::TradeRun* run = one.run_in(name);
    ASSERT_NE(run, nullptr);
    EXPECT_EQ(run->standing(), trade::Standing::kWrong) << name;
    EXPECT_LT(run->valid, run->checkpoints);
    EXPECT_TRUE(run->valid_at_end);
    EXPECT_GT(run->deviation.inversions, 10u);
    EXPECT_TRUE(run->first_wrong);
  }
  EXPECT_EQ(one.run_in("mpfr:53"), nullptr);  // was not asked for
}

// 24 bits put the last of the swaps after the scene's end.
TEST(TradeCase, WrongAtTheEndIsSeen) {
  const trade::CaseResult one = run(make_case("sorted_list", "sort-worst", 24, 1), {"mpfr:24"});
  const trade::TradeRun* run = one.run_in("mpfr:24");
  EXPECT_EQ(run->ending, trade::Ending::kEnded);
  EXPECT_EQ(run->deviation.missed, 1u);
  EXPECT_FALSE(run->valid_at_end);
  EXPECT_EQ(run->valid, run->checkpoints - 1);
  EXPECT_EQ(run->standing(), trade::Standing::kWrong);
  EXPECT_TRUE(one.run_in("double")->valid_at_end);
}

TEST(TradeCase, SceneWithoutEndGetsOne) {
  const trade::TradeCase one = given_case(
      R"({"kinex": 1, "dimension": 1, "time": {"start": 0}, "objects": [
          {"id": "a", "motion": [[0, 1]]}, {"id": "b", "motion": [["7/2"]]},
          {"id": "c", "motion": [["11/2"]]}], "maintain": ["sorted_list"]})");
  const trade::CaseResult result = run(one, {"sturm"});
  EXPECT_EQ(result.events, 2u);
  EXPECT_EQ(result.run_in("double")->standing(), trade::Standing::kSame);
  EXPECT_TRUE(result.run_in("sturm")->valid_at_end);
  EXPECT_EQ(result.bits.most, 5);  // the end is 6: log2(6 / (1/2)), and one more
}

// States are audited on the objects that a structure is built from: those of "of", or lines beside points.
TEST(TradeCase, AuditsTheObjectsOfTheStructureAlone) {
  std::vector<std::string> scenes;
  for (const char* of : {R"("red")", R"(["a", "b"])", R"({"all_but": ["c"]})"}) {
    scenes.push_back(R"({"kinex": 1, "dimension": 2, "time": {"start": 0, "end": 4}, "objects": [
        {"id": "a", "colour": "red", "motion": [[0, 1], [0]]},
        {"id": "b", "colour": "red", "motion": [[1], [1]]},
        {"id": "c", "motion": [[0], ["1/2"]]}], "maintain": [
        {"structure": "closest_pair_all", "of": )" +
                     std::string(of) + "}]}");
  }
  for (const char* structure : {"line_arrangement_2", "trapezoids_2"}) {
    scenes.push_back(R"({"kinex": 1, "dimension": 2, "time": {"start": 0, "end": 4}, "objects": [
        {"id": "l", "line": true, "motion": [[0, 1], [1]]},
        {"id": "m", "line": true, "motion": [[-1], [0, 1]]},
        {"id": "n", "line": true, "motion": [[1], [2]]},
        {"id": "p", "motion": [[2], [6]]}], "maintain": [")" +
                     std::string(structure) + R"("]})");
  }
  for (const std::string& scene : scenes) {
    SCOPED_TRACE(scene);
    const trade::CaseResult result = run(given_case(scene), {"sturm"});
    EXPECT_TRUE(result.faults().empty());
    for (const char* name : {"exact", "sturm"}) {
      EXPECT_EQ(result.run_in(name)->standing(), trade::Standing::kSame) << name;
      EXPECT_EQ(result.run_in(name)->valid, result.run_in(name)->checkpoints) << name;
    }
  }
}

TEST(TradeCase, SaysThatTheExactRunGaveUp) {
  trade::TradeOptions options;
  options.max_seconds = 1e-9;
  const std::optional<trade::CaseResult> one =
      trade::run_case(make_case("sorted_list", "uniform-square", 300, 1), options);
  ASSERT_TRUE(one);
  EXPECT_TRUE(one->gave_up);
  EXPECT_TRUE(one->runs.empty());
  EXPECT_THAT(trade::table_of(*one), HasSubstr("takes too long"));
  options.source.go_on = [] { return false; };
  EXPECT_FALSE(trade::run_case(make_case("sorted_list", "grid", 9, 1), options));
}

// Cut after five events: reported as endless, with what was missed, and not as right.
TEST(TradeCase, EndlessRunsAreCut) {
  trade::TradeOptions options;
  options.arithmetics = {"gsl", "sturm"};
  options.events_factor = 0;
  options.events_more = 5;
  const trade::CaseResult one =
      trade::run_case(make_case("sorted_list", "uniform-square", 8, 1), options).value();
  EXPECT_GT(one.events, 6u);
  for (const char* name : {"double", "gsl"}) {
    const trade::TradeRun* run = one.run_in(name);
    EXPECT_EQ(run->ending, trade::Ending::kEndless) << name;
    EXPECT_EQ(run->standing(), trade::Standing::kWrong);
    EXPECT_EQ(run->events, 5u);
    EXPECT_EQ(run->deviation.missed, one.events - 5);
    EXPECT_EQ(run->deviation.first, 6u);
    EXPECT_LT(run->valid, run->checkpoints);
    EXPECT_FALSE(run->valid_at_end);
    EXPECT_FALSE(run->seconds);
  }
  EXPECT_EQ(one.run_in("sturm")->standing(), trade::Standing::kSame);  // exact ones have no budget
  EXPECT_THAT(trade::table_of(one), HasSubstr("ENDLESS: stopped after 5 log records"));
  EXPECT_TRUE(one.faults().empty());
}

TEST(TradeCase, FaultsAreThoseOfExactArithmeticsAndThrows) {
  trade::CaseResult one = nearly();
  EXPECT_TRUE(one.faults().empty());
  one.runs[0].valid -= 1;
  EXPECT_EQ(one.faults().size(), 1u);
  one.runs[0].differs = true;
  EXPECT_THAT(one.faults().at(0), HasSubstr("exact does not give"));
  one.runs[1].ending = trade::Ending::kThrew;
  EXPECT_EQ(one.faults().size(), 2u);
}

TEST(TradeRun, StandingsByEnding) {
  trade::TradeRun run;
  run.checkpoints = run.valid = 4;
  EXPECT_EQ(run.standing(), trade::Standing::kSame);
  run.deviation.inversions = 1;
  EXPECT_EQ(run.standing(), trade::Standing::kValid);
  run.valid = 3;
  EXPECT_EQ(run.standing(), trade::Standing::kWrong);
  run.valid = 4;
  for (const trade::Ending ending :
       {trade::Ending::kCorrupt, trade::Ending::kEndless, trade::Ending::kGaveUp, trade::Ending::kThrew}) {
    run.ending = ending;
    EXPECT_EQ(run.standing(), trade::Standing::kWrong);
  }
}

// ---- the catalogue

// Three scenes beside random ones of degrees 1 to 3, as far as the structure takes them.
TEST(TradeCatalogue, HoldsSixScenesOfEveryPlan) {
  std::set<std::string> planned;
  std::size_t cases = 0;
  for (const lab::FamilyExperiments& family : lab::experiment_families()) {
    for (const lab::TradePlan& plan : family.trade) {
      planned.emplace(plan.structure);
      cases += std::min<std::size_t>(3, find_structure_info(plan.structure)->largest_degree) + 3;
    }
  }
  ASSERT_GE(planned.size(), 5u);
  for (const lab::Extent extent : {lab::Extent::kQuick, lab::Extent::kFull}) {
    const trade::TradeCatalogue all = trade::make_trade_catalogue({}, extent);
    EXPECT_EQ(all.cases.size(), cases);
    std::set<std::string> structures, names;
    for (const trade::TradeCase& one : all.cases) {
      structures.insert(one.structure);
      EXPECT_TRUE(names.insert(one.structure + ", " + one.name).second)
          << one.structure << ", " << one.name << " is there twice";
      EXPECT_EQ(one.scene().maintain.size(), 1u);
    }
    EXPECT_EQ(structures, planned);
    for (const char* name : {"delaunay_2", "convex_hull_2"}) {
      EXPECT_EQ(trade::make_trade_catalogue({name}, extent).cases.size(), 6u);
    }
  }
  EXPECT_INPUT_ERROR(trade::make_trade_catalogue({"delauney_2"}, lab::Extent::kQuick),
                     "trade: \"delauney_2\" is neither a file nor a structure");
  EXPECT_EQ(trade::bits_of_arithmetic("mpfr:200"), 200);
  EXPECT_EQ(trade::bits_of_arithmetic("gsl"), 53);
  EXPECT_EQ(trade::bits_of_arithmetic("sturm"), 0);
}

// ---- several, and bits

trade::TradeCatalogue small_catalogue() {
  trade::TradeCatalogue catalogue;
  catalogue.cases.push_back(make_case("sorted_list", "uniform-square", 8, 1));
  catalogue.cases.push_back(make_case("sorted_list", "near-one-point", 8, 1));
  catalogue.cases.push_back(make_case("delaunay_2", "grid", 9, 2));
  for (const int n : {8, 16, 32}) {
    trade::BitsCase one;
    one.structure = "sorted_list";
    one.workload = "uniform-square";
    one.parameters.n = n;
    one.parameters.dimension = 1;
    one.seeds = 3;
    one.family = "uniform";
    catalogue.bits.push_back(one);
  }
  return catalogue;
}

trade::TradeResult small_result(int jobs) {
  trade::TradeOptions options;
  options.jobs = jobs;
  options.arithmetics = {"sturm", "mpfr:100"};
  return trade::run_trade(small_catalogue(), options, {});
}

// Everything but times.
std::string counts_of(const trade::TradeResult& result) {
  std::string text;
  for (const trade::CaseResult& one : result.cases) {
    nlohmann::json row = nlohmann::json::parse(trade::json_row(one));
    row.erase("seconds");
    for (nlohmann::json& run : row["runs"]) {
      run.erase("seconds");
      run.erase("time_over_double");
    }
    text += row.dump() + "\n";
  }
  for (const trade::BitsResult& one : result.bits) text += trade::json_row(one);
  for (const trade::BitsGrowth& growth : result.growths) text += trade::json_row(growth);
  return text;
}

TEST(RunTrade, GivesTheSameForAnyNumberOfJobs) {
  const trade::TradeResult one = small_result(1);
  EXPECT_EQ(counts_of(one), counts_of(small_result(3)));
  EXPECT_EQ(one.cases.size(), 3u);
  EXPECT_EQ(one.bits.size(), 3u);
  ASSERT_EQ(one.growths.size(), 1u);
  EXPECT_GT(one.growths[0].most->b, 1);  // about 4: n^2 events, the closest n^-4 apart
  EXPECT_TRUE(one.faults().empty());
  EXPECT_FALSE(one.gave_up());
}

TEST(RunTrade, KeepsWhatWasFinishedWhenInterrupted) {
  trade::TradeOptions options;
  options.arithmetics = {};
  std::atomic<int> finished{0};
  options.source.go_on = [&] { return finished < 1; };
  trade::TradeWatch watch;
  watch.on_case = [&](const trade::CaseResult&) { ++finished; };
  const trade::TradeResult result = trade::run_trade(small_catalogue(), options, watch);
  EXPECT_TRUE(result.interrupted);
  EXPECT_EQ(result.cases.size(), 1u);
  EXPECT_TRUE(result.bits.empty());
}

// Families whose bits are a n^b exactly are fitted exactly.
TEST(FitBits, FindsTheSlope) {
  std::vector<trade::BitsResult> bits;
  for (const int k : {3, 4, 5, 6}) {
    trade::BitsResult one;
    one.which.structure = "s";
    one.which.family = "f";
    one.which.parameters.n = 1 << k;
    for (const int more : {-1, 1}) {
      one.most.add(3 * k + 2 + more);
      one.percentile_99.add(2 * k + 1);
    }
    bits.push_back(one);
  }
  bits.push_back(bits.front());  // another family, of one size: no fit
  bits.back().which.family = "g";
  const std::vector<trade::BitsGrowth> growths = trade::fit_bits(bits);
  ASSERT_EQ(growths.size(), 1u);
  EXPECT_NEAR(growths[0].most->b, 3, 1e-9);
  EXPECT_NEAR(std::log2(growths[0].most->a), 2, 1e-9);
  EXPECT_NEAR(growths[0].percentile_99->b, 2, 1e-9);
  EXPECT_THAT(trade::growth_text(*growths[0].most), HasSubstr("bits = 3.00 log2(n) + 2.0"));
}

// ---- what is written

struct CloseHandle {
  void operator()(sqlite3* handle) const { sqlite3_close(handle); }
};

std::string query(sqlite3* handle, const std::string& sql) {
  std::string text;
  const auto add = [](void* out, int, char** values, char**) {
    std::string& joined = *static_cast<std::string*>(out);
    joined += (joined.empty() ? "" : " ") + std::string(values[0] == nullptr ? "NULL" : values[0]);
    return 0;
  };
  char* message = nullptr;
  if (sqlite3_exec(handle, sql.c_str(), add, &text, &message) != SQLITE_OK) {
    text = std::string("error: ") + message;
    sqlite3_free(message);
  }
  return text;
}

TEST(TradeDatabase, IsReadableStrictAndComplete) {
  const fs::path path =
      fs::temp_directory_path() / ("kinex-trade-test-" + std::to_string(::getpid()) + ".sqlite");
  std::ofstream(path, std::ios::binary)
      << trade::trade_database(small_result(1), lab::build_facts(), lab::machine_facts());
  sqlite3* opened = nullptr;
  ASSERT_EQ(sqlite3_open_v2(path.c_str(), &opened, SQLITE_OPEN_READONLY, nullptr), SQLITE_OK);
  const std::unique_ptr<sqlite3, CloseHandle> handle(opened);
  fs::remove(path);
  EXPECT_EQ(query(opened, "PRAGMA integrity_check"), "ok");
  EXPECT_EQ(query(opened, "PRAGMA foreign_key_check"), "");
  EXPECT_EQ(query(opened,
                  "SELECT count(*) FROM pragma_table_list WHERE schema = 'main' AND strict = 0 AND "
                  "name NOT LIKE 'sqlite%'"),
            "0");
  EXPECT_EQ(query(opened, "SELECT count(*) FROM build, machine"), "1");
  EXPECT_EQ(query(opened, "SELECT count(*) FROM trade_case"), "3");
  EXPECT_EQ(query(opened, "SELECT count(*) FROM trade_run"), "12");
  EXPECT_EQ(query(opened, "SELECT events FROM trade_case WHERE name = 'near-one-point'"), "28");
  EXPECT_EQ(query(opened,
                  "SELECT DISTINCT standing FROM trade_run JOIN trade_case ON id = case_id WHERE "
                  "name = 'near-one-point' AND arithmetic = 'double'"),
            "wrong");
  EXPECT_EQ(query(opened, "SELECT DISTINCT standing FROM trade_run WHERE arithmetic = 'sturm'"),
            "same");
  EXPECT_EQ(query(opened, "SELECT n FROM bits"), "8 16 32");
  EXPECT_EQ(query(opened, "SELECT count(*) FROM bits_growth"), "2");
}

TEST(TradePage, HoldsTablesPlotsAndNothingFromOutside) {
  // Such short runs cannot be timed on a fast machine: the times are made up.
  trade::TradeResult result = small_result(1);
  for (trade::CaseResult& one : result.cases) {
    double seconds = 1;
    for (trade::TradeRun& run : one.runs) run.seconds = seconds++;
  }
  const std::vector<lab::Figure> figures = trade::trade_figures(result);
  ASSERT_EQ(figures.size(), 3u);  // two planes, one of bits
  const lab::Drawings drawings = lab::draw(figures);
  ASSERT_EQ(drawings.problem, "");
  for (const std::string& svg : drawings.svg) EXPECT_THAT(svg, HasSubstr("<svg"));
  lab::PageFacts facts;
  facts.command = "kinex trade <test>";
  facts.build = lab::build_facts();
  facts.machine = lab::machine_facts();
  const lab::Report report = trade::trade_report(result, facts);
  const std::string page = lab::report_page(report, drawings, facts);
  EXPECT_THAT(page, HasSubstr("data:image/svg+xml;base64,"));
  EXPECT_THAT(page, HasSubstr("kinex trade &lt;test&gt;"));
  EXPECT_THAT(page, HasSubstr("sorted_list: speed and accuracy"));
  EXPECT_THAT(page, HasSubstr("WRONG"));
  EXPECT_THAT(page, Not(HasSubstr("://")));
  EXPECT_LT(page.find("right in all of them"), page.find("<nav"));
  EXPECT_THAT(page, HasSubstr("kinex trade scene.json"));
  const lab::Drawings none = lab::draw(figures, "no-such-gnuplot");
  EXPECT_THAT(lab::report_page(report, none, facts), HasSubstr("no-such-gnuplot is not installed"));
}

TEST(TradeMarkdown, IsTheSameTwiceButForTimes) {
  const auto without_times = [](const trade::TradeResult& result) {
    trade::TradeResult copy = result;
    for (trade::CaseResult& one : copy.cases) {
      for (trade::TradeRun& run : one.runs) run.seconds.reset();
    }
    return trade::trade_markdown(copy, {});
  };
  const trade::TradeResult result = small_result(1);
  EXPECT_EQ(without_times(result), without_times(small_result(2)));
  const std::string text = trade::trade_markdown(result, {});
  EXPECT_THAT(text, HasSubstr("## sorted_list"));
  EXPECT_THAT(text, HasSubstr("time depends on the machine"));
  EXPECT_THAT(text, HasSubstr("| near-one-point, n = 8 | same | **wrong**"));
}

TEST(TradeTable, ShortNumbers) {
  EXPECT_EQ(trade::short_number(0, 2), "0");
  EXPECT_EQ(trade::short_number(1.2345e-17, 2), "1.2e-17");
  EXPECT_EQ(trade::short_number(std::numeric_limits<double>::infinity(), 2), "inf");
  EXPECT_EQ(trade::short_time(Rational::parse("0.49999999999999999")), "0.5");
  EXPECT_EQ(trade::short_time(Rational::parse("0.26376261582597332")), "0.26376262");
  EXPECT_EQ(trade::short_time(std::nullopt), "-");
}

}  // namespace trade_test
}  // namespace kinex
