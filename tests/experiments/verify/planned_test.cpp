// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments verify and trade as plans of sweeps: their cells by content, run from their
// texts, and results that come back from records as they were.
#include "experiments/verify/planned.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "experiments/families/collision/turned_scene.h"
#include "experiments/formats/input_error.h"
#include "experiments/sweep/plan.h"
#include "experiments/trade/planned.h"
#include "experiments/verify/report_text.h"
#include "tests/experiments/verify/cells.h"

namespace kinex {
namespace planned_test {

using test::random_cell;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const sweep::Experiments& experiments() {
  static const sweep::Experiments kAll = [] {
    sweep::Experiments all;
    verify::add_experiment(all);
    trade::add_experiment(all);
    return all;
  }();
  return kAll;
}

sweep::Selection selected(const char* experiment, std::vector<std::string> names) {
  sweep::Selection selection;
  selection.experiment = experiment;
  selection.names = std::move(names);
  selection.quick = true;
  return selection;
}

TEST(PlannedVerify, TheKeyIsOfWhatDecidesTheRuns) {
  const lab::Cell cell = random_cell(12, 3);
  const std::string key = verify::planned(cell, {}).key;
  lab::Cell other = cell;
  other.question = "Another question?";
  other.cost = 7;
  other.family = "elsewhere";
  other.expectations.front().source = "another";
  EXPECT_EQ(verify::planned(other, {}).key, key);
  std::set<std::string> keys{key, verify::planned(cell, 5).key};
  const auto changed = [&](auto change) {
    lab::Cell one = cell;
    change(one);
    keys.insert(verify::planned(one, {}).key);
  };
  changed([](lab::Cell& one) { one.parameters.seed = 2; });
  changed([](lab::Cell& one) { one.parameters.degree = 2; });
  changed([](lab::Cell& one) { one.parameters.m = 2; });
  changed([](lab::Cell& one) { one.parameters.separation = Rational(1); });
  changed([](lab::Cell& one) { one.parameters.turns = 0; });
  changed([](lab::Cell& one) { one.mirrored = true; });
  changed([](lab::Cell& one) { one.change = &families::kTurned; });
  changed([](lab::Cell& one) { one.audit = AuditLevel::kEvents; });
  changed([](lab::Cell& one) { one.max_seeds = 4; });
  changed([](lab::Cell& one) { one.min_seeds = 2; });
  changed([](lab::Cell& one) { one.max_seconds = 1; });
  changed([](lab::Cell& one) { one.precise = {{"processed", 0.02}}; });
  changed([](lab::Cell& one) { one.expectations.front().claim = "another.witness"; });
  changed([](lab::Cell& one) { one.structure = "another"; });
  EXPECT_EQ(keys.size(), 16u);
}

TEST(PlannedVerify, APlanIsTheCatalogueByCost) {
  const sweep::Plan plan = sweep::plan_of(selected("verify", {"sorted_list"}), experiments());
  EXPECT_EQ(plan.name, "verify sorted_list --quick");
  const lab::Catalogue catalogue = verify::make_catalogue("sorted_list", lab::Extent::kQuick);
  std::set<std::string> keys;
  for (const lab::Cell& cell : catalogue.cells) keys.insert(verify::planned(cell, {}).key);
  ASSERT_EQ(plan.cells.size(), keys.size());
  for (std::size_t i = 0; i < plan.cells.size(); ++i) {
    EXPECT_TRUE(keys.contains(plan.cells[i].key));
    EXPECT_THAT(plan.cells[i].text, StartsWith("{\"verify\":{"));
    EXPECT_LE(plan.cells[i].cost, plan.cells[i == 0 ? 0 : i - 1].cost);
  }
  // As it is kept in attempt files.
  const sweep::Plan again =
      sweep::parse_plan(plan.text, "plan", sweep::PlanCheck::kFormOnly, experiments());
  EXPECT_EQ(again.hash, plan.hash);
  EXPECT_EQ(again.cells.size(), plan.cells.size());
}

// Once as a child of a sweep runs it, once as `kinex verify` does.
TEST(PlannedVerify, ACellRunsFromItsText) {
  const lab::Catalogue catalogue = verify::make_catalogue("sorted_list", lab::Extent::kQuick);
  const lab::Cell* cell = nullptr;
  for (const lab::Cell& one : catalogue.cells) {
    if (one.random && one.parameters.n <= 64) cell = &one;
  }
  ASSERT_NE(cell, nullptr);
  const sweep::PlanCell planned = verify::planned(*cell, 3);
  const sweep::CellReport report = sweep::run_any(planned.text, experiments());
  EXPECT_EQ(report.outcome, sweep::Outcome::kDone) << report.message;
  verify::VerifyOptions options;
  options.seeds = 3;
  const lab::CellResult here = verify::run_cell(*cell, options).value();
  EXPECT_EQ(verify::report_of(here).exact, report.exact);
  const sweep::Record record =
      sweep::parse_record(sweep::record_line(sweep::record_of(planned, report, 1)), "file", 2);
  const lab::CellResult back = verify::result_of(record, *cell);
  EXPECT_EQ(verify::report_of(back).exact, report.exact);
  EXPECT_EQ(verify::report_of(back).times, report.times);
  EXPECT_EQ(back.trials.size(), 3u);
}

TEST(PlannedVerify, RefusesWhatItDoesNotHave) {
  const sweep::CellReport report =
      sweep::run_any(R"({"verify": {"structure": "x"}})", experiments());
  EXPECT_EQ(report.outcome, sweep::Outcome::kRefused);
  EXPECT_THAT(report.message, HasSubstr("no experiment of this program has such a cell"));
  EXPECT_THROW(sweep::plan_of(selected("verify", {"x"}), experiments()), formats::InputError);
  EXPECT_THROW(sweep::plan_of(selected("verify", {"all", "all"}), experiments()),
               formats::InputError);
  EXPECT_THROW(sweep::plan_of(selected("nothing", {}), experiments()), formats::InputError);
  sweep::Selection selection = selected("verify", {});
  selection.options["seeds"] = {"0"};
  EXPECT_THROW(sweep::plan_of(selection, experiments()), formats::InputError);
}

// A bound that fails is a failed cell; an expectation is judged by the report alone.
TEST(PlannedVerify, FailedIsOfBoundsAndAudits) {
  lab::CellResult result = test::run(test::sorting_cell(29));
  EXPECT_EQ(result.verdict(), lab::Verdict::kRefuted);
  EXPECT_EQ(verify::report_of(result).outcome, sweep::Outcome::kDone);
  result.trials.front().measurement.bounds.front().holds = false;
  EXPECT_EQ(verify::report_of(result).outcome, sweep::Outcome::kFailed);
  result = test::run(test::sorting_cell(28));
  result.trials.front().measurement.violations = {"a is not before b"};
  EXPECT_EQ(verify::report_of(result).message, "a is not before b");
  result = test::run(test::sorting_cell(28));
  result.trials.front().measurement.status = RunStatus::kLimit;
  EXPECT_EQ(verify::report_of(result).outcome, sweep::Outcome::kLimit);
}

TEST(PlannedVerify, ARecordWithoutRunsIsSaidToBeNone) {
  const lab::Cell cell = random_cell(8, 2);
  sweep::Record record;
  record.outcome = sweep::Outcome::kCrash;
  record.message = "a signal";
  const lab::CellResult result = verify::result_of(record, cell);
  EXPECT_EQ(result.verdict(), lab::Verdict::kRefuted);
  EXPECT_THAT(verify::table_row(result), HasSubstr("crash: a signal"));
  record.outcome = sweep::Outcome::kMemory;
  EXPECT_EQ(verify::result_of(record, cell).verdict(), lab::Verdict::kGaveUp);
}

TEST(PlannedTrade, ACaseRunsFromItsText) {
  sweep::Selection selection = selected("trade", {"sorted_list"});
  selection.options["arithmetic"] = {"gsl"};
  const sweep::Plan plan = sweep::plan_of(selection, experiments());
  EXPECT_EQ(plan.name, "trade sorted_list --quick --arithmetic gsl");
  bool found = false;
  trade::TradeOptions options;
  options.arithmetics = {"gsl"};
  for (const trade::TradeCase& which :
       trade::make_trade_catalogue({"sorted_list"}, lab::Extent::kQuick).cases) {
    if (which.workload != "grid") continue;
    found = true;
    const sweep::PlanCell planned = trade::planned(which, options);
    const sweep::CellReport report = sweep::run_any(planned.text, experiments());
    EXPECT_EQ(report.outcome, sweep::Outcome::kDone) << report.message;
    const trade::CaseResult here = trade::run_case(which, options).value();
    EXPECT_EQ(trade::report_of(here).exact, report.exact);
    const trade::CaseResult back = trade::result_of(sweep::record_of(planned, report, 1), which);
    EXPECT_EQ(back.runs.size(), 3u);
    EXPECT_EQ(trade::report_of(back).times, report.times);
  }
  EXPECT_TRUE(found);
}

}  // namespace planned_test
}  // namespace kinex
