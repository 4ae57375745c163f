// SPDX-License-Identifier: GPL-3.0-or-later
// Logs that are not whole, or not of the same: what diff, log, view and check say of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/program/spawn.h"

namespace kinex {
namespace log_endings_test {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class LogEndings : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(run_kinex({"gen", "uniform-square", "--n", "12", "-o", scene_}).exit_code, 0);
    ASSERT_EQ(run_kinex({"run", scene_, "--maintain", "sorted_list", "--events", log_}).exit_code,
              0);
  }
  ScratchFolder scratch_;
  const std::string scene_ = scratch_.file("scene.json"), log_ = scratch_.file("run.log");
};

// Logs of the same structure by other keys, or with other parameters: these are named.
TEST_F(LogEndings, DiffOfOtherKeys) {
  const std::string other = scratch_.file("other.log");
  ASSERT_EQ(run_kinex({"run", scene_, "--maintain", "sorted_list:y", "--events", other}).exit_code,
            0);
  EXPECT_THAT(
      run_kinex({"diff", log_, other}).err,
      HasSubstr(": it maintains sorted_list by \"y\", the other sorted_list by \"x\"; compare"));
  const std::string few = R"({"structure": "sorted_list", "of": ["p0", "p1"]})";
  ASSERT_EQ(run_kinex({"run", scene_, "--maintain", few, "--events", other, "--force"}).exit_code,
            0);
  EXPECT_THAT(
      run_kinex({"diff", log_, other}).err,
      HasSubstr(": it maintains sorted_list by \"x\" with {\"of\":[\"p0\",\"p1\"]}, the other "
                "sorted_list by \"x\"; compare"));
}

// A log that does not hold all of its run: diff, log and view say so.
TEST_F(LogEndings, LogsThatAreNotWhole) {
  const std::string other = scratch_.file("other.log"), page = scratch_.file("page.html");
  const auto view = [&] {
    return run_kinex({"view", log_, "--scene", scene_, "--with", other, "-o", page, "--force"});
  };
  EXPECT_EQ(run_kinex({"run", scene_, "--maintain", "sorted_list", "--max-events", "1", "--events",
                       other})
                .exit_code,
            3);
  const std::string ends = " ends at about t = 0[.0-9]*: limit";
  const std::string note =
      "kinex: " + other + ": the log" + ends + "; run the scene with a larger limit for the rest\n";
  const Finished stopped = run_kinex({"diff", log_, other});
  EXPECT_EQ(stopped.exit_code, 1);
  EXPECT_THAT(stopped.out, testing::ContainsRegex("^" + other + ends + "\nfirst difference"));
  EXPECT_THAT(run_kinex({"diff", "--json", log_, other}).out,
              testing::ContainsRegex(
                  "\"status\": \\[\"done\", \"limit\"\\], \"reached\": \\[\"1\", \"[0-9]"));
  EXPECT_THAT(run_kinex({"log", other}).err, testing::ContainsRegex(note));
  const Finished seen = view();
  EXPECT_EQ(seen.exit_code, 0) << seen.err;
  EXPECT_THAT(seen.err, testing::ContainsRegex(note));
  EXPECT_THAT(seen.out, HasSubstr("compared  the same log records, as far as both go\n"));

  const std::string text = read_file(log_);
  write_file(other, text.substr(0, text.find("\n{\"end\"") + 1));
  const Finished cut = run_kinex({"diff", log_, other});
  EXPECT_EQ(cut.exit_code, 0);
  EXPECT_THAT(cut.out, StartsWith(other + " was cut off\nequal: "));
  EXPECT_THAT(run_kinex({"diff", "--json", log_, other}).out,
              HasSubstr("\"status\": [\"done\", \"cut off\"], \"reached\": [\"1\", null]"));
  EXPECT_THAT(view().err, HasSubstr(other + ": the log has no last line: its run was cut off"));

  // A run up to an earlier time is whole, but shorter.
  ASSERT_EQ(run_kinex({"run", scene_, "--maintain", "sorted_list", "--until", "1/4", "--events",
                       other, "--force"})
                .exit_code,
            0);
  EXPECT_THAT(run_kinex({"diff", log_, other}).out,
              StartsWith(log_ + " ends at t = 1, " + other + " at t = 1/4 (0.25)\n"));
  // One line is missing: one complaint about numbers.
  const std::size_t third = text.find("\n{\"seq\": 3"), fourth = text.find("\n{\"seq\": 4");
  write_file(other, text.substr(0, third) + text.substr(fourth));
  const std::string checked = run_kinex({"check", other}).err;
  EXPECT_THAT(checked, HasSubstr("sequence number 4 where 3 is due"));
  EXPECT_THAT(checked, Not(HasSubstr("where 4 is due")));
}

}  // namespace log_endings_test
}  // namespace kinex
