// SPDX-License-Identifier: GPL-3.0-or-later
// `kinex reproduce` from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/program/spawn.h"

namespace kinex {
namespace {

using ::testing::HasSubstr;

TEST(ReproduceVerb, NamesWhatThereIs) {
  const Finished paper = run_kinex({"reproduce", "some-paper"});
  EXPECT_EQ(paper.exit_code, 2);
  EXPECT_THAT(paper.err, HasSubstr("\"some-paper\": there is no such paper"));
  EXPECT_THAT(paper.err, HasSubstr("kds-report-1998"));
  const Finished part = run_kinex({"reproduce", "kds-report-1998", "figure-9"});
  EXPECT_EQ(part.exit_code, 2);
  EXPECT_THAT(part.err, HasSubstr("figure-3, large-runs, section-9"));
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

}  // namespace
}  // namespace kinex
