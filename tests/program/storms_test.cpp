// SPDX-License-Identifier: GPL-3.0-or-later
// A year of storms: 1783 tracks, up to 181 at once, tens of thousands of flight-plan changes on the
// same six-hour marks, positions rounded to a tenth of a degree. What the witness says is computed
// from the table itself (storm_witness.h).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "experiments/formats/json_document.h"
#include "tests/program/spawn.h"
#include "tests/program/storm_witness.h"
#include "tests/shared_data.h"

namespace kinex {
namespace storms_test {

using testing::HasSubstr;
using testing::StartsWith;

constexpr std::int64_t kHour = Storms::kUnits;

std::string time_text(std::int64_t time) {
  return std::to_string(time) + "/" + std::to_string(Storms::kUnits);
}

class StormYear : public testing::Test {
 protected:
  void SetUp() override {
    KINEX_REQUIRE_DATA(table_);
    const Finished made = run_kinex({"import", table_, "-o", scene_});
    ASSERT_EQ(made.exit_code, 0) << made.err;
    storms_.emplace(table_);
    ASSERT_THAT(made.err, HasSubstr(std::to_string(storms_->count()) + " objects"));
  }

  // Runs the year and keeps log and summary under the arithmetic's name.
  Finished simulate(const std::string& structure, const std::string& arithmetic,
                    const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{
        "run",          scene_,          "--maintain", structure,
        "--arithmetic", arithmetic,      "--audit",    "end",
        "--events",     log(arithmetic), "--summary",  scratch_.file(arithmetic + ".json")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_kinex(arguments);
  }
  std::string log(const std::string& arithmetic) const {
    return scratch_.file(arithmetic + ".log");
  }
  formats::JsonDocument summary(const std::string& arithmetic) const {
    const std::string file = scratch_.file(arithmetic + ".json");
    return formats::parse_json(read_file(file), file);
  }

  // Between the fixes, all year round; and right after fixes, where many storms turn at once.
  std::vector<std::int64_t> sample_times(bool at_fixes) const {
    std::vector<std::int64_t> times;
    const std::int64_t step = (storms_->end() - storms_->start()) / 60;
    for (std::int64_t t = storms_->start(); t < storms_->end(); t += step) {
      const std::int64_t fix = t / (6 * kHour) * (6 * kHour) + 6 * kHour;
      if (at_fixes && fix < storms_->end()) times.push_back(fix);
      times.push_back(fix + 2 * kHour + kHour / 7);
    }
    while (times.back() >= storms_->end()) times.pop_back();
    return times;
  }
  static std::vector<std::string> at(const std::vector<std::int64_t>& times) {
    std::string texts;
    for (const std::int64_t t : times) texts += (texts.empty() ? "" : ",") + time_text(t);
    return {"--at", texts};
  }

  // The witness counts what happens to the scene; the ledger must have it all, and no violation.
  void expect_clean(const formats::JsonValue& ledger) {
    const auto count = [&](const char* name) { return std::stoull(std::string(ledger.find(name)->text())); };
    EXPECT_EQ(count("motion_updates"), storms_->turns());
    EXPECT_EQ(count("insertions"), storms_->arrivals());
    EXPECT_EQ(count("erasures"), storms_->departures());
    EXPECT_EQ(ledger.find("audit")->find("violations")->text(), "0");
    EXPECT_NE(ledger.find("audit")->find("checks")->text(), "0");
    std::uint64_t explained = 0;
    for (const formats::JsonValue& times : ledger.find("rebuild_reasons")->items()) {
      explained += std::stoull(std::string(times.text()));
    }
    EXPECT_EQ(count("rebuilds"), explained);
    for (const formats::JsonValue& bound : ledger.find("bounds")->items()) {
      EXPECT_TRUE(bound.find("holds")->boolean()) << bound.find("id")->text();
    }
  }

  // Exchanges in the exact log, without those of storms that are erased at that very instant: the
  // order at an instant is motions, failures, erasures, so they have passed each other by then.
  std::uint64_t exchanges_in_log() const {
    std::set<std::pair<std::string, std::string>> erased;
    std::vector<std::array<std::string, 3>> exchanges;
    std::istringstream lines(read_file(log("exact")));
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
      const formats::JsonDocument event_document = formats::parse_json(line, "log");
      const formats::JsonValue& event = *event_document;
      if (event.find("end") != nullptr) break;
      const std::string_view kind = event.find("kind")->text();
      const std::string time(event.find("time")->find("decimal")->text());
      const auto ids = event.find("ids")->items();
      if (kind == "erase") erased.emplace(time, ids[0].text());
      if (kind != "swap" && kind != "tie") continue;
      EXPECT_TRUE(event.find("external")->boolean());
      exchanges.push_back({time, std::string(ids[0].text()), std::string(ids[1].text())});
    }
    return static_cast<std::uint64_t>(
        std::count_if(exchanges.begin(), exchanges.end(), [&](const auto& one) {
          return erased.count({one[0], one[1]}) + erased.count({one[0], one[2]}) == 0;
        }));
  }

  // An inexact arithmetic may go wrong here, and mostly does: but it says so, its log is a log, and
  // where it parts from the exact run is shown.
  void expect_defined(const std::string& structure, const std::string& arithmetic) {
    const Finished run = simulate(structure, arithmetic);
    ASSERT_TRUE(run.exit_code == 0 || run.exit_code == 1) << run.exit_code << run.err;
    EXPECT_EQ(run.exit_code == 0, run.err.empty()) << run.err;
    const Finished check = run_kinex({"check", log(arithmetic)});
    EXPECT_EQ(check.exit_code, 0) << check.err;
    const Finished diff = run_kinex({"diff", log("exact"), log(arithmetic)});
    ASSERT_TRUE(diff.exit_code == 0 || diff.exit_code == 1) << diff.err;
    // A line that a structure is corrupt stands before.
    const std::size_t line =
        diff.out.find(" is corrupt: ") < diff.out.find('\n') ? diff.out.find('\n') + 1 : 0;
    EXPECT_THAT(diff.out.substr(line),
                StartsWith(diff.exit_code == 0 ? "equal: " : "first difference"));
    std::printf("%s in %s, exit code %d: %s", structure.c_str(), arithmetic.c_str(), run.exit_code,
                diff.out.c_str());
    if (!run.err.empty()) std::printf("%s", run.err.c_str());
  }

  const std::string table_ = shared_data("hurricanes.csv");
  ScratchFolder scratch_;
  const std::string scene_ = scratch_.file("storms.json");
  std::optional<Storms> storms_;
};

TEST_F(StormYear, SortedListIsTheOrderOfTheTable) {
  const std::vector<std::int64_t> times = sample_times(true);
  const Finished run = simulate("sorted_list", "exact", at(times));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const formats::JsonDocument result = summary("exact");
  const auto samples = result->find("samples")->items();
  ASSERT_EQ(samples.size(), times.size());
  std::size_t most = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    std::vector<std::string> order;
    for (const formats::JsonValue& id : samples[i].find("sorted_list")->items()) order.emplace_back(id.text());
    EXPECT_EQ(order, storms_->west_to_east(times[i])) << time_text(times[i]);
    most = std::max(most, order.size());
  }
  EXPECT_GT(most, 100u);  // the samples are not all of the quiet months
  const formats::JsonValue* ledger = result->find("structures")->find("sorted_list");
  expect_clean(*ledger);
  EXPECT_EQ(ledger->find("rebuilds")->text(), "0");
  EXPECT_EQ(exchanges_in_log(), storms_->exchanges());
  EXPECT_THAT(run.out, HasSubstr(std::to_string(storms_->departures()) + " erasures"));
}

TEST_F(StormYear, SortedListInEveryArithmetic) {
  ASSERT_EQ(simulate("sorted_list", "exact").exit_code, 0);
  ASSERT_EQ(simulate("sorted_list", "sturm").exit_code, 0);
  const Finished diff = run_kinex({"diff", log("exact"), log("sturm")});
  EXPECT_EQ(diff.exit_code, 0) << diff.out;
  EXPECT_EQ(summary("exact")->find("log_digest")->text(), summary("sturm")->find("log_digest")->text());
  for (const char* arithmetic : {"double", "gsl"}) expect_defined("sorted_list", arithmetic);
}

// The bounds on events grow with every turn, arrival and departure; expect_clean() looks at them.
TEST_F(StormYear, MaximaKeepTheirBounds) {
  const Finished run = simulate("maximum_tournament,minimum_tournament,maximum_heap", "exact");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const formats::JsonDocument result = summary("exact");
  for (const char* name : {"maximum_tournament", "minimum_tournament", "maximum_heap"}) {
    const formats::JsonValue* ledger = result->find("structures")->find(name);
    expect_clean(*ledger);
    bool bounded = false;
    for (const formats::JsonValue& bound : ledger->find("bounds")->items()) {
      bounded = bounded || bound.find("id")->text() == std::string(name) + ".events";
    }
    EXPECT_TRUE(bounded) << name;
  }
}

TEST_F(StormYear, DelaunayHasEmptyCircles) {
  const std::vector<std::int64_t> times = sample_times(false);
  const Finished run = simulate("delaunay_2", "exact", at(times));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const formats::JsonDocument result = summary("exact");
  const auto samples = result->find("samples")->items();
  ASSERT_EQ(samples.size(), times.size());
  std::size_t most = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    std::vector<std::pair<std::string, std::string>> edges;
    for (const formats::JsonValue& edge : samples[i].find("delaunay_2")->items()) {
      edges.emplace_back(edge.items()[0].text(), edge.items()[1].text());
    }
    EXPECT_EQ(storms_->delaunay_complaint(times[i], edges), "") << time_text(times[i]);
    most = std::max(most, storms_->alive_count(times[i]));
  }
  EXPECT_GT(most, 100u);
  expect_clean(*result->find("structures")->find("delaunay_2"));
}

// Sturm sequences take a minute for the whole year: the first half of it here.
TEST_F(StormYear, DelaunayInEveryArithmetic) {
  const std::vector<std::string> half{"--until", "4800"};
  ASSERT_EQ(simulate("delaunay_2", "sturm", half).exit_code, 0);
  ASSERT_EQ(simulate("delaunay_2", "exact", half).exit_code, 0);
  const Finished diff = run_kinex({"diff", log("exact"), log("sturm")});
  EXPECT_EQ(diff.exit_code, 0) << diff.out;
  EXPECT_EQ(summary("exact")->find("log_digest")->text(), summary("sturm")->find("log_digest")->text());
  std::filesystem::remove(log("exact"));
  std::filesystem::remove(scratch_.file("exact.json"));
  ASSERT_EQ(simulate("delaunay_2", "exact").exit_code, 0);
  for (const char* arithmetic : {"double", "gsl"}) expect_defined("delaunay_2", arithmetic);
}

}  // namespace storms_test
}  // namespace kinex
