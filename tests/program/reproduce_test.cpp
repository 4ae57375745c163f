// SPDX-License-Identifier: GPL-3.0-or-later
// `kinex reproduce` from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/program/spawn.h"
#include "tests/sanitized.h"

namespace kinex {
namespace reproduce_test {

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
  for (const char* name : {"/claims.json", "/README.md"}) {
    EXPECT_TRUE(std::filesystem::exists(folder + name)) << name;
  }
  EXPECT_FALSE(std::filesystem::exists(folder + "/reproduce.unfinished"));
  const Finished refused =
      run_kinex({"reproduce", "kds-report-1998", "large-runs", "--quick", "-o", folder});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("--force"));
  const Finished again =
      run_kinex({"reproduce", "kds-report-1998", "large-runs", "--quick", "-o", folder, "--force"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  // The verdicts: the tables have times.
  const auto claims = [](const std::string& out) { return out.substr(out.rfind("|\n")); };
  EXPECT_EQ(claims(again.out), claims(first.out));
}

TEST(ReproduceVerb, TellsThePaperOnCollisions) {
  const ScratchFolder scratch;
  const std::string folder = scratch.file("features");
  const Finished run =
      run_kinex({"reproduce", "separation-sensitive-1999", "features", "--quick", "-o", folder});
  EXPECT_EQ(run.exit_code, 0) << run.err << run.out;
  EXPECT_THAT(run.out, HasSubstr("agrees  features.closest"));
  EXPECT_THAT(read_file(folder + "/README.md"), HasSubstr("n (3n + 2)"));
  const Finished part = run_kinex({"reproduce", "separation-sensitive-1999", "figure-3"});
  EXPECT_EQ(part.exit_code, 2);
  EXPECT_THAT(part.err, HasSubstr("translation, rigid, features, hysteresis, hierarchies"));
}

// A figure in the way is reported before any run, although figures are written last.
TEST(ReproduceVerb, IsRefusedWhereAFigureIs) {
  const ScratchFolder scratch;
  const std::string folder = scratch.file("round");
  std::filesystem::create_directories(folder);
  write_file(folder + "/translation-line.svg", "mine");
  const Finished run =
      run_kinex({"reproduce", "separation-sensitive-1999", "translation", "--quick", "-o", folder});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(run.err,
              HasSubstr("translation-line.svg: exists already, and a figure may have this name"));
  EXPECT_EQ(read_file(folder + "/translation-line.svg"), "mine");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
  // Nor is a folder left behind.
  const Finished from = run_kinex({"verify", "sorted_list", "--quick", "--from",
                                   scratch.file("none"), "-o", scratch.file("empty")});
  EXPECT_EQ(from.exit_code, 2);
  EXPECT_FALSE(std::filesystem::exists(scratch.file("empty")));
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
  EXPECT_THAT(read_file(folder + "/README.md"), HasSubstr("nothing wrong"));
  command.insert(command.end(), {"--force", "--logcheck", stub});
  const Finished run = run_kinex(command);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.out, HasSubstr("open  features.closest"));
  EXPECT_THAT(run.out, HasSubstr("refused: an event is missing"));
  EXPECT_THAT(run.out, Not(HasSubstr("agrees  ")));
  EXPECT_THAT(run.out, Not(HasSubstr("confirmed")));
  EXPECT_THAT(read_file(folder + "/claims.json"), HasSubstr("refused: an event is missing"));
  EXPECT_THAT(read_file(folder + "/README.md"), HasSubstr("refused: an event is missing"));
}

// A check that was asked for and does not happen is no success.
TEST(ReproduceVerb, AMissingOrMuteSecondProgramIsTold) {
  const ScratchFolder scratch;
  const std::string folder = scratch.file("features");
  const Words command{"reproduce", "separation-sensitive-1999", "features", "--quick", "-o", folder, "--logcheck"};
  const auto with = [&](const std::string& program) {
    Words words = command;
    words.push_back(program);
    return words;
  };
  const Finished missing = run_kinex(with("python3 " + scratch.file("none")));
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_THAT(missing.err, HasSubstr("kinex: --logcheck: there is no program \"python3 "));
  EXPECT_THAT(missing.err, HasSubstr("without arguments"));
  EXPECT_FALSE(std::filesystem::exists(folder + "/claims.json"));
  const std::string stub = scratch.file("mute");
  write_file(stub, "#!/bin/sh\nexit 0\n");
  std::filesystem::permissions(stub, std::filesystem::perms::owner_all);
  const Finished mute = run_kinex(with(stub));
  EXPECT_EQ(mute.exit_code, 3) << mute.err;
  EXPECT_THAT(mute.out, HasSubstr("not checked: exit code 0"));
  EXPECT_THAT(mute.err, HasSubstr("kinex: the second program did not check "));
}

// An interruption ends the second program too; what was run by then is kept and written.
TEST(ReproduceVerb, IsInterruptedWhileTheSecondProgramRuns) {
  const ScratchFolder scratch;
  const std::string stub = scratch.file("slow");
  write_file(stub, "#!/bin/sh\nsleep 1000\n");
  std::filesystem::permissions(stub, std::filesystem::perms::owner_all);
  const std::string listed =
      run_kinex({"sweep", "list", "reproduce", "separation-sensitive-1999", "features", "--quick"}).out;
  const auto points = std::count(listed.begin(), listed.end(), '\n') - 1;  // the last line counts them
  const int lines = static_cast<int>(points) + 1;  // and the header
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const std::string folder = scratch.file(std::to_string(signal));
    const std::string journal = folder + "/reproduce.unfinished";
    Words command{"reproduce", "separation-sensitive-1999", "features", "--quick", "-o", folder};
    Words stuck = command;
    stuck.insert(stuck.end(), {"--logcheck", stub});
    const Finished stopped = run_kinex_until(stuck, journal, lines, signal);
    EXPECT_EQ(stopped.exit_code, 3) << stopped.err;
    EXPECT_THAT(stopped.err, HasSubstr("interrupted: the same command resumes"));
    EXPECT_THAT(read_file(folder + "/claims.json"), HasSubstr("not checked: interrupted"));
    const Finished resumed = run_kinex(command);  // without --force: the results are its own
    EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
    EXPECT_THAT(resumed.err, HasSubstr(std::to_string(points) + " experiments are finished already"));
    EXPECT_THAT(read_file(folder + "/claims.json"), Not(HasSubstr("interrupted")));
    EXPECT_FALSE(std::filesystem::exists(journal));
    if (test::kSanitized) break;
  }
}

// By a sweep in three shards: the claims of one process.
TEST(ReproduceVerb, TellsWhatASweepHasRun) {
  const ScratchFolder scratch;
  const Words what{"reproduce", "separation-sensitive-1999", "features", "--quick"};
  const auto with = [](Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  Words sweep{"sweep", "run"};
  sweep.insert(sweep.end(), what.begin(), what.end());
  const std::string out = scratch.file("out"), one = scratch.file("one"), two = scratch.file("two");
  EXPECT_EQ(run_kinex(with(sweep, {"--shard", "0/3", "-o", out})).exit_code, 0);
  const Finished early = run_kinex(with(what, {"--from", out, "-o", two}));
  EXPECT_EQ(early.exit_code, 2);
  EXPECT_THAT(early.err, HasSubstr("are missing"));
  for (const char* shard : {"1/3", "2/3"}) {
    EXPECT_EQ(run_kinex(with(sweep, {"--shard", shard, "--jobs", "2", "-o", out})).exit_code, 0);
  }
  const Finished swept = run_kinex(with(what, {"--from", out, "-o", two}));
  const Finished alone = run_kinex(with(what, {"-o", one}));
  EXPECT_EQ(swept.exit_code, 0) << swept.err;
  EXPECT_EQ(alone.exit_code, 0) << alone.err;
  EXPECT_EQ(swept.out, alone.out);
  EXPECT_EQ(read_file(one + "/features.svg"), read_file(two + "/features.svg"));
}

}  // namespace reproduce_test
}  // namespace kinex
