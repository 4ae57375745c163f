// SPDX-License-Identifier: GPL-3.0-or-later
// Standard streams that are closed, and standard input that is named twice.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/places.h"
#include "tests/program/spawn.h"

namespace kinex {
namespace standard_streams_test {

using testing::HasSubstr;
using Words = std::vector<std::string>;

class StandardStreams : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(run_kinex({"gen", "uniform-square", "--n", "12", "-o", scene_}).exit_code, 0);
    ASSERT_EQ(run_kinex({"run", scene_, "--events", log_, "--summary", summary_}).exit_code, 0);
  }
  // Of the program with these words, as a shell reads them.
  int exit_code_of(const std::string& words) const {
    const std::string command = std::string(KINEX_PROGRAM) + " " + words;
    return WEXITSTATUS(std::system(command.c_str()));
  }
  ScratchFolder scratch_;
  const std::string scene_ = scratch_.file("scene.json"), log_ = scratch_.file("run.log"),
                    summary_ = scratch_.file("summary.json"), other_ = scratch_.file("other"),
                    err_ = scratch_.file("err");
  const std::string run_ = "run '" + scene_ + "' ";
};

// The report is lost, and said to be lost; the files are what they are with all streams.
TEST_F(StandardStreams, ClosedOnesAreNotGivenToFiles) {
  const std::string log = read_file(log_), summary = read_file(summary_);
  const std::string lost = "kinex: standard output: cannot be written: Bad file descriptor; ";
  for (const std::string closed : {">&-", "<&- >&-"}) {
    const std::string to_err = "2> '" + err_ + "' " + closed;
    EXPECT_EQ(exit_code_of(run_ + "--events '" + other_ + "' " + to_err), 2);
    EXPECT_EQ(read_file(other_), log);
    EXPECT_THAT(read_file(err_), HasSubstr(lost));
    EXPECT_EQ(exit_code_of(run_ + "--force -q --events '" + other_ + "' " + to_err), 0);
    EXPECT_EQ(read_file(other_), log);
    EXPECT_EQ(exit_code_of(run_ + "--force --summary '" + other_ + "' " + to_err), 2);
    EXPECT_THAT(read_file(other_), testing::StartsWith(summary.substr(0, 20)));
    EXPECT_THAT(read_file(other_), testing::EndsWith("}\n"));
    EXPECT_THAT(read_file(err_), HasSubstr(lost));
    std::filesystem::remove(other_);
    EXPECT_EQ(exit_code_of(run_ + "--events - " + to_err), 2);
    EXPECT_THAT(read_file(err_), HasSubstr(lost));
    EXPECT_EQ(exit_code_of("gen grid --n 4 " + to_err), 2);
    EXPECT_THAT(read_file(err_), HasSubstr(lost));
  }
  // Notes and errors are lost, not added to what is written.
  for (const std::string closed : {"2>&-", "<&- 2>&-"}) {
    EXPECT_EQ(exit_code_of(run_ + "-v --events '" + other_ + "' > /dev/null " + closed), 0);
    EXPECT_EQ(read_file(other_), log);
    std::filesystem::remove(other_);
  }
  EXPECT_EQ(exit_code_of(run_ + "--events '" + other_ + "' <&- >&- 2>&-"), 2);
  EXPECT_EQ(read_file(other_), log);
}

TEST_F(StandardStreams, ClosedInputHasNoBytes) {
  EXPECT_EQ(exit_code_of("check - <&- 2> '" + err_ + "'"), 2);
  EXPECT_THAT(read_file(err_), HasSubstr("kinex: -: cannot be read: Bad file descriptor"));
  EXPECT_EQ(exit_code_of("check '" + scene_ + "' <&- > /dev/null"), 0);
}

// A link to a stream that is closed does not lead to /dev/null, which takes everything.
TEST_F(StandardStreams, LinksToClosedOnes) {
  for (const int stream : {0, 1, 2}) {
    const std::string link = scratch_.file("link"), number = std::to_string(stream);
    std::filesystem::remove(link);
    std::filesystem::create_symlink("/proc/self/fd/" + number, link);
    if (stream == 0) {
      EXPECT_EQ(exit_code_of("check '" + link + "' <&- 2> '" + err_ + "'"), 2);
      EXPECT_THAT(read_file(err_), HasSubstr(link + ": cannot be read: "));
    } else {
      const std::string streams = stream == 1 ? ">&- 2> '" + err_ + "'" : "2>&- > /dev/null";
      EXPECT_EQ(exit_code_of(run_ + "-q --events '" + link + "' " + streams), 2) << stream;
    }
  }
}

// The children of an experiment have streams of their own.
TEST_F(StandardStreams, ChildrenOfExperiments) {
  const std::string folder = scratch_.file("results");
  EXPECT_EQ(
      exit_code_of("trade '" + scene_ + "' -q --arithmetic gsl -o '" + folder + "' <&- >&- 2>&-"),
      0);
  EXPECT_THAT(read_file(folder + "/trade.sqlite"), testing::StartsWith("SQLite format 3"));
}

TEST_F(StandardStreams, InputThatIsNamedTwice) {
  const std::string log = read_file(log_);
  for (const auto& [words, place] :
       {std::pair(Words{"diff", "-", "-"}, "LOG and OTHER"),
        {{"check", "-", "--scene", "-"}, "FILE and --scene"},
        {{"view", "-", "--scene", "-", "-o", other_}, "FILE and --scene"},
        {{"view", "-", "--with", "-", "-o", other_}, "FILE and --with"},
        {{"view", log_, "--scene", "-", "--with", "-", "-o", other_}, "--scene and --with"},
        {{"trade", "-", scene_, "-", "-o", other_}, "WHAT"},
        {{"import", "-", "--polygons", "-"}, "FILE and --polygons"},
        {{"ccd", "-", "-", "--kind", "edge-edge"}, "FILE"}}) {
    const Finished twice = run_kinex(words, log);
    EXPECT_EQ(twice.exit_code, 2) << words[0];
    EXPECT_EQ(twice.err,
              "kinex: " + std::string(place) +
                  ": standard input is named twice; give one of the two the name of a file\n");
    EXPECT_EQ(twice.out, "") << words[0];
    EXPECT_FALSE(std::filesystem::exists(other_)) << words[0];
  }
  EXPECT_EQ(run_kinex({"diff", "-", log_}, log).exit_code, 0);
  EXPECT_EQ(run_kinex({"check", log_, "--scene", "-"}, read_file(scene_)).exit_code, 0);
}

}  // namespace standard_streams_test
}  // namespace kinex
