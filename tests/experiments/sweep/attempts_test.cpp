// SPDX-License-Identifier: GPL-3.0-or-later
// Attempt files, what several of them say together, and the merged database.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

#include "experiments/sweep/cell_run.h"
#include "experiments/sweep/database.h"
#include "tests/experiments/expect_input_error.h"

namespace kinex::sweep {
namespace attempts_test {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kPlan =
    R"({"kinex_plan": 1, "name": "small", "blocks": [{"structure": ["sorted_list", "delaunay_2"],
        "workload": "uniform-square", "n": [6, 7], "seed": [1, 2, 3]}]})";

class SweepAttempts : public ::testing::Test {
 protected:
  SweepAttempts() : plan_(parse_plan(kPlan, "plan.json", PlanCheck::kScenes)) {
    std::string pattern = (fs::temp_directory_path() / "kinex-sweep-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
  }
  ~SweepAttempts() override { fs::remove_all(folder_); }

  AttemptProvenance provenance() const {
    AttemptProvenance of;
    of.plan_name = plan_.name;
    of.plan_hash = plan_.hash;
    of.plan = plan_.text;
    of.program = "a program";
    of.build = {"kinex 1", "abc", false, "a \"compiler\"", "-O2", "libraries"};
    of.machine = {"a processor", 2, 1000, "a kernel"};
    of.host = "host";
    of.command = "kinex sweep run";
    of.shard = "0/1";
    of.started = "2026-01-01T00:00:00Z";
    return of;
  }
  // Of the cell at this place, with a verdict that depends on `digest`.
  Record record(std::size_t place, const std::string& digest = "1") const {
    Record result;
    result.key = plan_.cells[place].key;
    result.cell = plan_.cells[place].text;
    result.exact = R"({"digest":")" + digest + R"("})";
    result.cpu_s = 0.123456;
    result.ended = "2026-01-01T00:00:01Z";
    return result;
  }
  Record ended(std::size_t place, Outcome outcome) const {
    Record result = record(place);
    result.outcome = outcome;
    result.exact.clear();
    return result;
  }
  std::string write(const std::vector<Record>& records) {
    AttemptFile file(folder_, {0, 1}, provenance());
    for (const Record& one : records) file.append(one);
    return file.path();
  }
  std::string text_of(const std::string& path) const {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
  }
  void append(const std::string& path, const std::string& text) const {
    std::ofstream(path, std::ios::binary | std::ios::app) << text;
  }

  Plan plan_;
  std::string folder_;
};

TEST_F(SweepAttempts, RecordsAreReadAsTheyWereWritten) {
  Record full = record(0);
  full.outcome = Outcome::kCrash;
  full.signal = SIGSEGV;
  full.message = "a \"message\"\\";
  full.limits = {60, 4000};
  full.simulate_s = 1.0 / 3;
  full.peak_kb = 123456;
  const std::string path = write({full, record(1)});
  EXPECT_THAT(path, HasSubstr(folder_ + "/shard-0-20"));
  const std::vector<Attempt> attempts = read_attempts({folder_});
  ASSERT_EQ(attempts.size(), 1u);
  ASSERT_EQ(attempts[0].records.size(), 2u);
  EXPECT_EQ(record_line(attempts[0].records[0]), record_line(full));
  EXPECT_EQ(attempts[0].records[0].message, full.message);
  EXPECT_EQ(attempts[0].records[0].limits.megabytes, 4000);
  EXPECT_EQ(provenance_line(attempts[0].provenance), provenance_line(provenance()));
}

TEST_F(SweepAttempts, EveryAttemptHasAFileOfItsOwn) {
  EXPECT_NE(write({record(0)}), write({record(1)}));
  EXPECT_EQ(read_attempts({folder_}).size(), 2u);
}

TEST_F(SweepAttempts, ALastLineThatIsNotWholeIsDropped) {
  const std::string path = write({record(0), record(1)});
  const std::string whole = text_of(path);
  const std::size_t second = whole.rfind('\n', whole.size() - 2) + 1;
  for (std::size_t size = second; size < whole.size(); size += 7) {
    fs::resize_file(path, size);
    ASSERT_EQ(read_attempts({folder_})[0].records.size(), 1u) << size;
    std::ofstream(path, std::ios::binary) << whole;
  }
  fs::resize_file(path, whole.find('\n'));  // within the first line: nothing is known of it
  EXPECT_TRUE(read_attempts({folder_}).empty());
}

TEST_F(SweepAttempts, OtherLinesMustBeRecords) {
  const std::string path = write({record(0)});
  append(path, "{\"key\": 1}\n");
  EXPECT_INPUT_ERROR(read_attempts({folder_}), path + ": line 3: \"key\": 1 is not a string");
}

// Tables are made of a result: what would not fit into them is seen when it is read.
TEST_F(SweepAttempts, AResultHasItsShape) {
  for (const char* exact :
       {"", "5", "{}", R"({"structures":["a"]})", R"({"structures":{"a":{"bounds":5}}})",
        R"({"structures":{"a":{"bounds":[5]}}})", R"({"structures":{"a":{"extremes":[[5]]}}})",
        R"({"structures":{"a":{"counters":{"x":[]}}}})", R"({"run":{"counters":["a"]}})",
        R"({"run":{"extremes":[5]}})", R"({"run":5})", R"({"violations":{"a":1}})"}) {
    SCOPED_TRACE(exact);
    Record damaged = record(0);
    damaged.exact = exact;
    const std::string path = write({damaged});
    EXPECT_INPUT_ERROR(read_attempts({folder_}),
                       path + ": line 2: its exact fields are not the result of a cell");
    fs::remove(path);
  }
}

// Seconds with a damaged exponent: no plot has an axis for them.
TEST_F(SweepAttempts, TimesAreSeconds) {
  for (const char* times : {"1 0x1.8p+1023 ", "0x1p-1000 ", "-0x1p+99999 ", "0x1.8q+3 ", "0x"}) {
    SCOPED_TRACE(times);
    Record damaged = record(0);
    damaged.times = times;
    const std::string path = write({damaged});
    EXPECT_INPUT_ERROR(read_attempts({folder_}), path + ": line 2: its times are none that a cell takes");
    fs::remove(path);
  }
  Record right = record(0);
  right.times = "2 0x0p+0 0x1.8p-30 1 0x1.6d0dd4471d288p+10 ";
  write({right});
  EXPECT_EQ(read_attempts({folder_}).front().records.front().times, right.times);
}

TEST_F(SweepAttempts, AKeyBelongsToItsCell) {
  Record wrong = record(0);
  wrong.key = record(1).key;
  write({wrong});
  EXPECT_INPUT_ERROR(read_attempts({folder_}), "is not that of its cell");
}

TEST_F(SweepAttempts, ProgramsAreNotMixed) {
  write({record(0)});
  AttemptProvenance other = provenance();
  other.program = "another program";
  { AttemptFile file(folder_, {1, 2}, other); }
  EXPECT_INPUT_ERROR(read_attempts({folder_}), "its records are of another commit");
}

TEST_F(SweepAttempts, NothingThatIsThereIsWrittenTo) {
  EXPECT_INPUT_ERROR(AttemptFile("/nonexistent", Shard{0, 1}, provenance()), "cannot be written");
}

TEST_F(SweepAttempts, DuplicatesMustAgree) {
  Record slower = record(0);
  slower.cpu_s = 99;
  slower.peak_kb = 1;
  write({record(0), slower, ended(0, Outcome::kLimit), ended(0, Outcome::kCrash)});
  EXPECT_FALSE(find_conflict(read_attempts({folder_})));
  const std::string path = write({record(1), record(0, "2")});
  const std::vector<Attempt> attempts = read_attempts({folder_});
  const auto conflict = find_conflict(attempts);
  ASSERT_TRUE(conflict);
  const bool is_first = attempts[0].path == path;
  EXPECT_EQ(is_first ? conflict->place_a : conflict->place_b, path + ", line 3");
  EXPECT_EQ(is_first ? conflict->line_a : conflict->line_b, record_line(record(0, "2")));
}

TEST_F(SweepAttempts, DifferentVerdictsDisagree) {
  EXPECT_TRUE(agree(record(0), record(0)));
  EXPECT_FALSE(agree(record(0), ended(0, Outcome::kRefused)));
  EXPECT_FALSE(agree(record(0), record(0, "2")));
  EXPECT_TRUE(agree(record(0), ended(0, Outcome::kMemory)));
}

TEST_F(SweepAttempts, AVerdictStandsForTheCell) {
  std::vector<Attempt> attempts{{"a", provenance(), {}}};
  const auto outcome_after = [&](Outcome outcome) {
    attempts[0].records.push_back(ended(0, outcome));
    return settle(attempts).at(plan_.cells[0].key)->outcome;
  };
  EXPECT_EQ(outcome_after(Outcome::kKilled), Outcome::kKilled);
  EXPECT_EQ(outcome_after(Outcome::kLimit), Outcome::kLimit);
  EXPECT_EQ(outcome_after(Outcome::kMemory), Outcome::kMemory);
  EXPECT_EQ(outcome_after(Outcome::kKilled), Outcome::kMemory);
  EXPECT_EQ(outcome_after(Outcome::kCrash), Outcome::kCrash);
  EXPECT_EQ(outcome_after(Outcome::kRefused), Outcome::kRefused);
  EXPECT_EQ(outcome_after(Outcome::kCrash), Outcome::kRefused);
}

TEST_F(SweepAttempts, RaisedLimitsAreTriedAgain) {
  Record limit = ended(0, Outcome::kLimit);
  limit.limits = {60, 4000};
  EXPECT_TRUE(is_settled(limit, {60, 4000}, false));
  EXPECT_TRUE(is_settled(limit, {30, 8000}, false));
  EXPECT_FALSE(is_settled(limit, {61, 4000}, false));
  EXPECT_FALSE(is_settled(limit, {0, 4000}, false));  // none
  EXPECT_FALSE(is_settled(limit, {60, 4000}, true));
  Record memory = ended(0, Outcome::kMemory);
  memory.limits = {60, 4000};
  EXPECT_TRUE(is_settled(memory, {600, 4000}, false));
  EXPECT_FALSE(is_settled(memory, {60, 4001}, false));
  EXPECT_TRUE(is_settled(ended(0, Outcome::kCrash), {0, 0}, false));
  EXPECT_FALSE(is_settled(ended(0, Outcome::kKilled), {0, 0}, false));
  EXPECT_TRUE(is_settled(record(0), {0, 0}, true));
}

TEST_F(SweepAttempts, TheRestIsScaledByWhatIsDone) {
  std::vector<Attempt> attempts{{"a", provenance(), {}}};
  EXPECT_FALSE(expected_rest(plan_.cells, settle(attempts)));
  for (std::size_t i = 0; i < plan_.cells.size(); ++i) {
    if (parse_cell(plan_.cells[i].text, "cell").parameters.n == 6) continue;
    attempts[0].records.push_back(record(i));
    attempts[0].records.back().cpu_s = 49;  // n^2
  }
  const Settled settled = settle(attempts);
  const Tally counts = tally(plan_.cells, settled);
  EXPECT_EQ(counts.text(), "6 done, 6 missing");
  EXPECT_DOUBLE_EQ(*expected_rest(plan_.cells, settled), 6.0 * 36);
}

// A run that the plan's max_events ended is done, but its results are those of a part.
TEST_F(SweepAttempts, RunsThatEndedAtMaxEventsAreCounted) {
  const Plan plan = parse_plan(
      R"({"kinex_plan": 1, "name": "short", "blocks": [{"structure": "sorted_list", "workload": "uniform-square",
          "n": 20, "seed": [1, 2], "max_events": [3, 100000]}]})",
      "plan.json", PlanCheck::kScenes);
  std::vector<Record> records;
  for (const PlanCell& cell : plan.cells) {
    records.push_back(record_of(cell, run_cell(parse_cell(cell.text, "cell")), 1));
    EXPECT_EQ(records.back().outcome, Outcome::kDone);
  }
  Settled settled;
  for (const Record& one : records) take(settled, one);
  EXPECT_EQ(tally(plan.cells, settled).at_max_events, 2u);
  EXPECT_EQ(tally(plan.cells, settled).text(), "4 done (2 of them ended at max_events)");
  settled.erase(records.back().key);
  EXPECT_THAT(tally(plan.cells, settled).text(),
              HasSubstr(" of them ended at max_events), 1 missing"));
}

// Everything in the exact tables, row by row.
std::string exact_tables(const std::string& database) {
  sqlite3* opened = nullptr;
  EXPECT_EQ(sqlite3_open(":memory:", &opened), SQLITE_OK);
  const std::unique_ptr<sqlite3, int (*)(sqlite3*)> keep(opened, sqlite3_close);
  const auto size = static_cast<sqlite3_int64>(database.size());
  auto* bytes = static_cast<unsigned char*>(sqlite3_malloc64(database.size()));
  std::copy(database.begin(), database.end(), bytes);
  EXPECT_EQ(sqlite3_deserialize(opened, "main", bytes, size, size, SQLITE_DESERIALIZE_FREEONCLOSE),
            SQLITE_OK);
  std::string text;
  for (const std::string table :
       {"plan", "cell", "plan_cell", "run", "counter", "extreme", "bound", "violation"}) {
    sqlite3_stmt* statement = nullptr;
    EXPECT_EQ(
        sqlite3_prepare_v2(opened, ("SELECT * FROM " + table).c_str(), -1, &statement, nullptr),
        SQLITE_OK);
    while (sqlite3_step(statement) == SQLITE_ROW) {
      text += table;
      for (int i = 0; i < sqlite3_column_count(statement); ++i) {
        const unsigned char* value = sqlite3_column_text(statement, i);
        text +=
            std::string("|") + (value == nullptr ? "NULL" : reinterpret_cast<const char*>(value));
      }
      text += "\n";
    }
    sqlite3_finalize(statement);
  }
  return text;
}

TEST_F(SweepAttempts, TheDatabaseDoesNotDependOnTheAttempts) {
  std::vector<Record> records;
  for (std::size_t i = 0; i + 1 < plan_.cells.size(); ++i) {
    const CellReport report = run_cell(parse_cell(plan_.cells[i].text, "cell"));
    ASSERT_EQ(report.outcome, Outcome::kDone) << report.message;
    records.push_back(record(i));
    records.back().exact = report.exact;
  }
  const std::string whole = exact_tables(sweep_database({{"a", provenance(), records}}));
  EXPECT_THAT(whole, HasSubstr("counter|1|sorted_list|external|"));
  EXPECT_THAT(whole, HasSubstr("bound|1|"));
  EXPECT_THAT(whole, HasSubstr("|missing|"));
  std::vector<Record> odd, even{ended(1, Outcome::kKilled)};
  for (std::size_t i = records.size(); i > 0; --i) {
    Record one = records[i - 1];
    one.cpu_s += 1;
    (i % 2 == 0 ? even : odd).push_back(one);
    if (i % 3 == 0) even.push_back(one);
  }
  const std::string parts =
      exact_tables(sweep_database({{"b", provenance(), odd}, {"a", provenance(), even}}));
  EXPECT_EQ(parts, whole);
  records.pop_back();
  EXPECT_NE(exact_tables(sweep_database({{"a", provenance(), records}})), whole);
}

TEST(SweepCell, ARefusedCellSaysWhy) {
  const RunCell cell = parse_cell(
      R"({"structure": "maximum_dual_hull", "workload": "uniform-square", "n": 5, "degree": 2})",
      "cell");
  const CellReport report = run_cell(cell);
  EXPECT_EQ(report.outcome, Outcome::kRefused);
  EXPECT_THAT(report.message, HasSubstr("maximum_dual_hull"));
  EXPECT_TRUE(report.exact.empty());
  const CellReport again = parse_report(report_text(report), "report");
  EXPECT_EQ(again.message, report.message);
  EXPECT_EQ(again.outcome, report.outcome);
}

}  // namespace attempts_test
}  // namespace kinex::sweep
