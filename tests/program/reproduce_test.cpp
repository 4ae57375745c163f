// SPDX-License-Identifier: GPL-3.0-or-later
// `kinex reproduce` from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/program/spawn.h"
#include "tests/sanitized.h"

namespace kinex {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Words = std::vector<std::string>;

TEST(ReproduceVerb, NamesWhatThereIs) {
  const Finished paper = run_kinex({"reproduce", "some-paper"});
  EXPECT_EQ(paper.exit_code, 2);
  EXPECT_THAT(paper.err, HasSubstr("\"some-paper\": there is no such paper"));
  EXPECT_THAT(paper.err, HasSubstr("kds-report-1998"));
  const Finished part = run_kinex({"reproduce", "kds-report-1998", "figure-9"});
  EXPECT_EQ(part.exit_code, 2);
  EXPECT_THAT(part.err, HasSubstr("the paper has no such part; did you mean figure-3?"));
  const Finished other = run_kinex({"reproduce", "kds-report-1998", "tables"});
  EXPECT_THAT(other.err, HasSubstr("figure-3, large-runs, section-9"));
}

TEST(ReproduceVerb, WritesItsFilesOnceAndGoesOn) {
  const ScratchFolder scratch;
  const std::string folder = scratch.file("large");
  const Finished first =
      run_kinex({"reproduce", "kds-report-1998", "large-runs", "--quick", "-o", folder});
  EXPECT_EQ(first.exit_code, 0) << first.err;
  EXPECT_THAT(first.out, HasSubstr("no event is left"));
  for (const char* name : {"/claims.json", "/README.md", "/runs.jsonl"}) {
    EXPECT_TRUE(std::filesystem::exists(folder + name)) << name;
  }
  const std::string runs = read_file(folder + "/runs.jsonl");
  const Finished refused =
      run_kinex({"reproduce", "kds-report-1998", "large-runs", "--quick", "-o", folder});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("--force"));
  const Finished again =
      run_kinex({"reproduce", "kds-report-1998", "large-runs", "--quick", "-o", folder, "--force"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(read_file(folder + "/runs.jsonl"), runs);  // nothing was run
  EXPECT_EQ(again.out, first.out);
}

TEST(ReproduceVerb, TellsThePaperOnCollisions) {
  const ScratchFolder scratch;
  const std::string folder = scratch.file("features");
  const Finished run =
      run_kinex({"reproduce", "separation-sensitive-1999", "features", "--quick", "-o", folder});
  EXPECT_EQ(run.exit_code, 0) << run.err << run.out;
  EXPECT_THAT(run.out, HasSubstr("confirmed  features.closest"));
  EXPECT_THAT(read_file(folder + "/README.md"), HasSubstr("n (3n + 2)"));
  const Finished part = run_kinex({"reproduce", "separation-sensitive-1999", "figure-3"});
  EXPECT_EQ(part.exit_code, 2);
  EXPECT_THAT(part.err, HasSubstr("translation, rigid, features, hysteresis, hierarchies"));
}

// The second program refuses the small run: the claim is not confirmed, and says so.
TEST(ReproduceVerb, WhatTheSecondProgramRefusesIsNotConfirmed) {
  const ScratchFolder scratch;
  const std::string stub = scratch.file("refuse");
  write_file(stub, "#!/bin/sh\necho 'an event is missing' >&2\nexit 1\n");
  std::filesystem::permissions(stub, std::filesystem::perms::owner_all);
  const std::string folder = scratch.file("features");
  Words command{"reproduce", "separation-sensitive-1999", "features", "--quick", "-o", folder};
  const Finished fine = run_kinex(command);
  EXPECT_EQ(fine.exit_code, 0) << fine.err << fine.out;
  EXPECT_THAT(read_file(folder + "/claims.json"),
              HasSubstr("\"checked_by\": {\"program\": \"kinex-logcheck\", \"levels\": [0, 1, 5]"));
  EXPECT_THAT(read_file(folder + "/runs.jsonl"), HasSubstr("{\"check\": \"closest_features "));
  EXPECT_THAT(read_file(folder + "/README.md"), HasSubstr("nothing wrong"));
  command.insert(command.end(), {"--force", "--logcheck", stub});
  const Finished run = run_kinex(command);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.out, HasSubstr("open  features.closest"));
  EXPECT_THAT(run.out, HasSubstr("refused: an event is missing"));
  EXPECT_THAT(run.out, Not(HasSubstr("confirmed")));
  EXPECT_THAT(read_file(folder + "/claims.json"), HasSubstr("refused: an event is missing"));
  EXPECT_THAT(read_file(folder + "/README.md"), HasSubstr("refused: an event is missing"));
}

// An interruption ends the second program too; what was run by then is kept and written.
TEST(ReproduceVerb, IsInterruptedWhileTheSecondProgramRuns) {
  const ScratchFolder scratch;
  const std::string stub = scratch.file("slow");
  write_file(stub, "#!/bin/sh\nsleep 1000\n");
  std::filesystem::permissions(stub, std::filesystem::perms::owner_all);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const std::string folder = scratch.file(std::to_string(signal)), runs = folder + "/runs.jsonl";
    Words command{"reproduce", "separation-sensitive-1999", "features", "--quick", "-o", folder};
    command.insert(command.end(), {"--logcheck", stub});
    constexpr int kLines = 46;  // all runs and the header
    const Finished stopped = run_kinex_until(command, runs, kLines, signal);
    EXPECT_EQ(stopped.exit_code, 3) << stopped.err;
    EXPECT_THAT(stopped.err, HasSubstr("interrupted: the same command with --force resumes"));
    EXPECT_THAT(read_file(folder + "/claims.json"), HasSubstr("not checked: interrupted"));
    const std::string text = read_file(runs);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), kLines);
    if (test::kSanitized) break;
  }
}

}  // namespace
}  // namespace kinex
