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
  EXPECT_THAT(stopped.out, HasSubstr(": 0 missing, 0 invented, "));
  EXPECT_THAT(stopped.out,
              HasSubstr(" records of " + log_ + " are after the end of " + other + "\n"));
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
  EXPECT_THAT(run_kinex({"diff", "--json", log_, other}).out,
              testing::ContainsRegex(
                  "\"missing\": 0, \"invented\": 0.*\"after_end\": \\[[1-9][0-9]*, 0\\]"));
  // One line is missing: one complaint about numbers, and one difference.
  const std::size_t third = text.find("\n{\"seq\": 3"), fourth = text.find("\n{\"seq\": 4");
  write_file(other, text.substr(0, third) + text.substr(fourth));
  const std::string differs = run_kinex({"diff", log_, other}).out;
  EXPECT_THAT(
      differs,
      HasSubstr(" records: 1 missing, 0 invented, 0 out of order, 0 with another effect, 0 at "));
  EXPECT_THAT(differs, HasSubstr("\n  missing  " + log_ + ":4:  3  "));
  EXPECT_THAT(run_kinex({"diff", "--json", "--all", other, log_}).out,
              HasSubstr("\"differences\": [{\"what\": [\"invented\"], \"lines\": [null, 4]}]"));
  const std::string checked = run_kinex({"check", other}).err;
  EXPECT_THAT(checked, HasSubstr("sequence number 4 where 3 is due"));
  EXPECT_THAT(checked, Not(HasSubstr("where 4 is due")));
}

// A run that was killed while it wrote leaves part of a line: the whole ones are used, the part is named.
TEST_F(LogEndings, LogsThatEndWithinALine) {
  const std::string other = scratch_.file("other.log"), text = read_file(log_);
  write_file(other, text.substr(0, text.find("\n{\"seq\": 4") + 20));
  const Finished shown = run_kinex({"log", other, "--columns", "seq"});
  EXPECT_EQ(shown.exit_code, 0);
  EXPECT_EQ(shown.out, "seq\n  1\n  2\n  3\n");
  EXPECT_THAT(
      shown.err,
      HasSubstr(other + ": line 5: the log was cut off within this line; what is shown is all "
                        "whole lines before it; for a whole log run the scene again"));
  const Finished diff = run_kinex({"diff", log_, other});
  EXPECT_EQ(diff.exit_code, 1);
  EXPECT_THAT(diff.out,
              StartsWith(other + " was cut off within line 5\nfirst difference at record 4\n"));
  EXPECT_THAT(diff.out, HasSubstr(" and 3 records: 0 missing, 0 invented, "));
  const Finished checked = run_kinex({"check", other, "--scene", scene_});
  EXPECT_EQ(checked.exit_code, 1);
  EXPECT_THAT(checked.err, StartsWith("kinex: " + other +
                                      ": line 5: the log was cut off within this line; run the "
                                      "scene again"));
  const Finished page = run_kinex(
      {"view", log_, "--scene", scene_, "--with", other, "-o", scratch_.file("page.html")});
  EXPECT_EQ(page.exit_code, 0) << page.err;
  EXPECT_THAT(page.err, HasSubstr("line 5: the log was cut off within this line"));
  write_file(other, text.substr(0, 50));
  for (const std::string verb : {"log", "check"}) {
    const Finished refused = run_kinex({verb, other});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(
        refused.err,
        HasSubstr(other + ": line 1: the log was cut off within its first line; run the scene"));
  }
}

// The run goes on to its end without a structure that became corrupt: the last line says so, and all that read it.
TEST_F(LogEndings, StructuresThatBecameCorrupt) {
  const std::string grid = scratch_.file("grid.json"), exact = scratch_.file("exact.log"),
                    corrupt = scratch_.file("corrupt.log"), page = scratch_.file("page.html");
  ASSERT_EQ(run_kinex({"gen", "grid", "--n", "36", "-o", grid}).exit_code, 0);
  const auto run = [&](const std::string& arithmetic, const std::string& log) {
    return run_kinex({"run", grid, "--maintain", "delaunay_2,sorted_list", "--arithmetic",
                      arithmetic, "--events", log});
  };
  ASSERT_EQ(run("exact", exact).exit_code, 0);
  const Finished broken = run("double", corrupt);
  ASSERT_EQ(broken.exit_code, 1);
  const std::string begin = "kinex: delaunay_2 is corrupt: ";
  const std::size_t place = broken.err.find(begin);
  ASSERT_NE(place, std::string::npos) << broken.err;
  const std::size_t end = broken.err.find('\n', place);
  const std::string text = broken.err.substr(place + begin.size(), end - place - begin.size());
  EXPECT_THAT(text, testing::ContainsRegex(" \\(at t = [0-9.]+\\)$"));
  const std::string member = "\"corrupt\": {\"delaunay_2\": \"" + text + "\"}";
  EXPECT_THAT(
      read_file(corrupt),
      testing::ContainsRegex("\n\\{\"end\": \"done\", \"reached\": \"4\", \"records\": [0-9]+, "
                             "\"external\": [0-9]+, \"corrupt\": [^\n]*\n$"));
  EXPECT_THAT(read_file(corrupt), HasSubstr(", " + member + ", \"digest\": "));
  EXPECT_THAT(read_file(exact), Not(HasSubstr("corrupt")));

  const std::string note = "delaunay_2 is corrupt: " + text + "; it has no records from then on\n";
  const Finished checked = run_kinex({"check", corrupt, "--scene", grid});
  EXPECT_EQ(checked.exit_code, 0);
  EXPECT_THAT(checked.out, HasSubstr("\nrun       done\n          " + note));
  EXPECT_THAT(run_kinex({"check", "--json", corrupt}).out,
              HasSubstr(", " + member + ", \"problems\": []"));
  EXPECT_THAT(run_kinex({"check", "--json", exact}).out,
              HasSubstr(", \"corrupt\": {}, \"problems\": []"));
  EXPECT_THAT(run_kinex({"log", corrupt}).err,
              testing::EndsWith("kinex: " + corrupt + ": " + note));
  EXPECT_EQ(run_kinex({"log", exact}).err, "");
  EXPECT_THAT(run_kinex({"diff", exact, corrupt}).out,
              StartsWith(corrupt + ": " + note + "first difference"));
  EXPECT_THAT(run_kinex({"diff", corrupt, exact}).out,
              StartsWith(corrupt + ": " + note + "first difference"));
  EXPECT_THAT(
      run_kinex({"diff", "--json", exact, corrupt}).out,
      HasSubstr("\"corrupt\": [{}, " + member.substr(member.find('{')) + "], \"events\": "));
  EXPECT_EQ(run_kinex({"view", exact, "--scene", grid, "--with", corrupt, "-o", page}).exit_code,
            0);
}

// Records that diff does not compare are counted by what they are.
TEST_F(LogEndings, DiffOfRecordsThatAreNotCompared) {
  const auto log_of = [&](const std::string& name, const std::string& motion) {
    const std::string scene = scratch_.file(name + ".json"), log = scratch_.file(name + ".log");
    write_file(
        scene,
        "{\"kinex\": 1, \"dimension\": 1, \"time\": {\"start\": 0, \"end\": 4}, \"maintain\": "
        "[\"sorted_list\"], \"objects\": [{\"id\": \"a\", \"motion\": " +
            motion + "}, {\"id\": \"b\", \"motion\": [[9]]}]}");
    EXPECT_EQ(run_kinex({"run", scene, "--events", log}).exit_code, 0);
    return log;
  };
  const std::string none = log_of("none", "[[0]]");
  const std::string one =
      log_of("one", R"([{"to": 1, "coordinates": [[0]]}, {"from": 1, "coordinates": [[0]]}])");
  const std::string two = log_of("two", R"([{"to": 1, "coordinates": [[0]]}, {"from": 1, "to": 2,
      "coordinates": [[0]]}, {"from": 2, "coordinates": [[0]]}])");
  EXPECT_THAT(run_kinex({"diff", none, one}).out,
              HasSubstr("\n1 record that is not compared (a rebuild, or a change of the scene) is "
                        "in one log only\n"));
  EXPECT_THAT(run_kinex({"diff", none, two}).out,
              HasSubstr("\n2 records that are not compared (rebuilds, or changes of the scene) are "
                        "in one log only\n"));
}

// check says what it could not check of a log whose instants are not exact, or are not there.
TEST_F(LogEndings, WhatIsNotChecked) {
  const auto checked = [&](const std::vector<std::string>& how,
                           const std::vector<std::string>& with) {
    std::vector<std::string> run{"run",      scene_, "--maintain", "sorted_list",
                                 "--events", log_,   "--force",    "-q"};
    run.insert(run.end(), how.begin(), how.end());
    EXPECT_EQ(run_kinex(run).exit_code, 0);
    std::vector<std::string> check{"check", log_};
    check.insert(check.end(), with.begin(), with.end());
    return run_kinex(check).out;
  };
  const std::string in_double = checked({"--arithmetic", "double"}, {"--scene", scene_});
  EXPECT_THAT(in_double,
              HasSubstr("verified  level 0: format, names, counts, digest, seal; the scene\n"));
  EXPECT_THAT(in_double,
              testing::ContainsRegex(
                  "not checked: level 1 \\(instants\\) and level 2 \\([0-9]+ certificates\\), "
                  "since the arithmetic double is not exact\n$"));
  EXPECT_THAT(
      checked({"--arithmetic", "double"}, {"--json", "--scene", scene_}),
      testing::ContainsRegex("\"levels\": \\[0\\], \"certificates\": 0, \"unchecked\": [1-9]"));
  EXPECT_THAT(checked({"--instants", "none"}, {}),
              HasSubstr("not checked: level 1 (instants), since the log has no instants\n"));
  const std::string intervals = checked({"--instants", "intervals"}, {"--scene", scene_});
  EXPECT_THAT(intervals, HasSubstr("verified  levels 0, 1: "));
  EXPECT_THAT(intervals, HasSubstr(" certificates), since the log does not name its instants\n"));
  EXPECT_THAT(checked({}, {"--scene", scene_}), HasSubstr("verified  levels 0, 1, 2: "));
  // Without --scene it says where it looked for one.
  const std::string name = scratch_.file("uniform-square n=12 seed=1.json");
  EXPECT_THAT(checked({}, {}),
              HasSubstr("there is no " + name + "; --scene SCENE checks the certificates too"));
  write_file(name, read_file(scene_));
  EXPECT_THAT(checked({}, {}), HasSubstr("verified  levels 0, 1, 2: "));
  ASSERT_EQ(run_kinex({"gen", "grid", "--n", "4", "--force", "-o", name}).exit_code, 0);
  EXPECT_THAT(checked({}, {}),
              HasSubstr(name + " is another scene: it has another hash; --scene SCENE checks"));
}

}  // namespace log_endings_test
}  // namespace kinex
