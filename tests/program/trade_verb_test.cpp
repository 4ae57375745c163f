// SPDX-License-Identifier: GPL-3.0-or-later
// kinex trade from outside: outputs, scenes of one's own, bad input, interruption.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>

#include "tests/program/spawn.h"

namespace kinex {
namespace trade_verb_test {

using testing::HasSubstr;
using testing::StartsWith;

class TradeVerb : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(run_kinex({"gen", "near-one-point", "--n", "6", "--dimension", "1", "--maintain",
                         "sorted_list,maximum_heap", "-o", scene_})
                  .exit_code,
              0);
  }
  ScratchFolder scratch_;
  const std::string scene_ = scratch_.file("scene.json");
  const std::string folder_ = scratch_.file("results");
};

TEST_F(TradeVerb, ComparesArithmeticsOnAScene) {
  const Finished finished = run_kinex({"trade", scene_, "--arithmetic", "sturm,mpfr:120", "-o",
                                       folder_, "--markdown", scratch_.file("trade.md"), "--json"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  std::istringstream lines(finished.out);
  std::set<std::string> structures;
  for (std::string line; std::getline(lines, line);) {
    const nlohmann::json row = nlohmann::json::parse(line);
    EXPECT_EQ(row["row"], "case");
    structures.insert(row["structure"].get<std::string>());
    ASSERT_EQ(row["runs"].size(), 4u);
    EXPECT_EQ(row["runs"][0]["arithmetic"], "exact");
    EXPECT_EQ(row["runs"][0]["standing"], "same");
    EXPECT_EQ(row["runs"][2]["arithmetic"], "sturm");
    EXPECT_EQ(row["runs"][3]["standing"], "same");
    if (row["structure"] == "sorted_list") {
      EXPECT_EQ(row["events"], 15);
      EXPECT_EQ(row["runs"][1]["standing"], "wrong");
      EXPECT_GT(row["bits"]["most"], 55);
    }
  }
  EXPECT_EQ(structures, (std::set<std::string>{"maximum_heap", "sorted_list"}));
  EXPECT_THAT(read_file(folder_ + "/trade.sqlite"), StartsWith("SQLite format 3"));
  EXPECT_THAT(read_file(folder_ + "/trade.html"), HasSubstr("<h1>kinex trade</h1>"));
  EXPECT_THAT(read_file(scratch_.file("trade.md")), HasSubstr("# The trade"));
}

// One scene is not "all of them".
TEST_F(TradeVerb, CountsAgreeInNumber) {
  const std::string one = scratch_.file("one.json");
  ASSERT_EQ(run_kinex({"gen", "sort-worst", "--n", "4", "--maintain", "sorted_list", "-o", one}).exit_code, 0);
  const Finished finished = run_kinex({"trade", one, "--arithmetic", "gsl", "-o", folder_});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(finished.out, HasSubstr("1 scene: exact, double, gsl right in it; "));
  EXPECT_THAT(read_file(folder_ + "/trade.txt"), HasSubstr("1 scene; same events / other events, valid / wrong:"));
  const std::string two = scratch_.file("two.json");
  ASSERT_EQ(run_kinex({"gen", "sort-worst", "--n", "4", "--maintain", "sorted_list,maximum_heap",
                       "-o", two})
                .exit_code,
            0);
  EXPECT_THAT(run_kinex({"trade", two, "--arithmetic", "gsl", "-o", scratch_.file("two")}).out,
              HasSubstr("2 structures of 1 scene: "));
}

TEST_F(TradeVerb, TableSaysHowManyBitsTheSceneNeeds) {
  const Finished finished =
      run_kinex({"trade", scene_, "--arithmetic", "gsl", "-o", folder_, "--jobs", "2", "--table"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(finished.out, HasSubstr("sorted_list, near-one-point n=6"));
  EXPECT_THAT(finished.out,
              testing::ContainsRegex("15 log records at 15 instants; needs [67][0-9] bits"));
  EXPECT_THAT(finished.out, HasSubstr("WRONG"));
}

TEST_F(TradeVerb, NeverReplacesAFile) {
  const std::vector<std::string> command{"trade", scene_, "--arithmetic", "double", "-o", folder_};
  EXPECT_EQ(run_kinex(command).exit_code, 0);
  const Finished again = run_kinex(command);
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_EQ(again.out, "");
  EXPECT_THAT(again.err, HasSubstr("trade.sqlite: exists already; give another name, or --force"));
  std::vector<std::string> forced = command;
  forced.push_back("--force");
  EXPECT_EQ(run_kinex(forced).exit_code, 0);
}

void expect_refused(std::vector<std::string> arguments, const std::string& message) {
  arguments.insert(arguments.begin(), "trade");
  const Finished finished = run_kinex(arguments);
  EXPECT_EQ(finished.exit_code, 2) << testing::PrintToString(arguments);
  EXPECT_EQ(finished.out, "");
  EXPECT_THAT(finished.err, HasSubstr(message));
}

TEST_F(TradeVerb, RefusesBadInput) {
  expect_refused({"delauney_2"},
                 "\"delauney_2\" is neither a file nor a structure; did you mean delaunay_2?");
  expect_refused({scene_, "--arithmetic", "decimal"}, "--arithmetic: ");
  expect_refused({scene_, "--arithmetic", "mpfr:1"}, "--arithmetic: ");
  expect_refused({scene_, "--jobs", "0"}, "--jobs: 0 is out of range");
  expect_refused({scene_, "--max-seconds", "0"}, "--max-seconds: ");
  expect_refused({scene_, "-o", "/dev/null/x"},
                 "the folder \"/dev/null/x\" cannot be made: Not a directory");
  write_file(scratch_.file("empty.json"),
             R"({"kinex": 1, "dimension": 1, "time": {"start": 0, "end": 1}, "objects": [],
                 "maintain": []})");
  expect_refused({scratch_.file("empty.json")}, "nothing is to be maintained");
  write_file(scratch_.file("broken.json"), "{");
  expect_refused({scratch_.file("broken.json")}, "broken.json");
}

TEST_F(TradeVerb, GivesUpAtItsLimit) {
  ASSERT_EQ(run_kinex({"gen", "uniform-square", "--n", "400", "-o", scratch_.file("large.json")})
                .exit_code,
            0);
  const Finished finished =
      run_kinex({"trade", scratch_.file("large.json"), "--max-seconds", "0.000001", "-o", folder_, "--table"});
  EXPECT_EQ(finished.exit_code, 3);
  EXPECT_THAT(finished.out, HasSubstr("takes too long"));
  EXPECT_THAT(read_file(folder_ + "/trade.html"), HasSubstr("takes too long"));
}

}  // namespace trade_verb_test
}  // namespace kinex
