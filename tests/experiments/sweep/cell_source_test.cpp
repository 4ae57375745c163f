// SPDX-License-Identifier: GPL-3.0-or-later
// CellSource: records come from the journal, or from a child that runs the cell; a child that crashes is
// a result. The children are shell scripts.
#include "experiments/sweep/cell_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "experiments/verify/report_text.h"
#include "tests/experiments/verify/cells.h"

namespace kinex {
namespace cell_source_test {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class ACellSource : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("kinex-source-" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  // A program that notes each start of it in the file `starts`.
  std::string program(const std::string& lines) const {
    std::ofstream(path("program")) << "#!/bin/sh\necho >> " << path("starts") << "\n" << lines << "\n";
    fs::permissions(path("program"), fs::perms::owner_all);
    return path("program");
  }
  int starts() const {
    std::ifstream file(path("starts"));
    int count = 0;
    for (std::string line; std::getline(file, line);) ++count;
    return count;
  }
  sweep::AttemptProvenance provenance() const {
    return sweep::provenance_of({"plan", "{}", std::string(64, '0')}, "test", "0/1");
  }
  static sweep::PlanCell cell(const char* text) { return sweep::make_cell("test", text, 1); }
  static std::optional<sweep::CellReport> never() {
    ADD_FAILURE() << "the cell was run here";
    return std::nullopt;
  }

  fs::path folder_;
};

TEST_F(ACellSource, RunsEachCellOnceInAChild) {
  sweep::Journal journal(path("journal"), provenance(), sweep::Leftover::kKeep);
  sweep::CellSource source;
  source.journal = &journal;
  source.program = program(
      R"(echo '{"status": "done", "message": "", "simulate_s": 0, "peak_kb": 1, "times": "2", "exact": {"a":1}}')");
  EXPECT_TRUE(source.is_to_be_run(cell("{\"n\": 1}")));
  for (int i = 0; i < 2; ++i) {
    const auto record = source.record_of(cell("{\"n\": 1}"), never);
    ASSERT_TRUE(record);
    EXPECT_EQ(record->outcome, sweep::Outcome::kDone);
    EXPECT_EQ(record->exact, "{\"a\":1}");
    EXPECT_EQ(starts(), 1);
  }
  EXPECT_FALSE(source.is_to_be_run(cell("{\"n\": 1}")));
  EXPECT_TRUE(source.record_of(cell("{\"n\": 2}"), never));
  EXPECT_EQ(starts(), 2);
}

TEST_F(ACellSource, ACrashIsARecord) {
  sweep::Journal journal(path("journal"), provenance(), sweep::Leftover::kKeep);
  sweep::CellSource source;
  source.journal = &journal;
  source.program = program("echo 'kinex: no way' >&2; kill -SEGV $$");
  for (int i = 0; i < 2; ++i) {
    const auto record = source.record_of(cell("{\"n\": 1}"), never);
    ASSERT_TRUE(record);
    EXPECT_EQ(record->outcome, sweep::Outcome::kCrash);
    EXPECT_EQ(record->signal, SIGSEGV);
    EXPECT_EQ(record->message, "kinex: no way");
    EXPECT_EQ(starts(), 1);
  }
  // One that was ended from outside is run again.
  source.program = program("kill -KILL $$");
  EXPECT_EQ(source.record_of(cell("{\"n\": 2}"), never)->outcome, sweep::Outcome::kKilled);
  EXPECT_TRUE(source.is_to_be_run(cell("{\"n\": 2}")));
}

TEST_F(ACellSource, AnInterruptionIsNone) {
  sweep::Journal journal(path("journal"), provenance(), sweep::Leftover::kKeep);
  sweep::CellSource source;
  source.journal = &journal;
  source.program = program("sleep 60");
  int looks = 0;
  source.go_on = [&] { return ++looks < 5; };
  EXPECT_FALSE(source.record_of(cell("{\"n\": 1}"), never));
  EXPECT_TRUE(source.is_to_be_run(cell("{\"n\": 1}")));
}

TEST_F(ACellSource, RunsHereWithoutAProgram) {
  sweep::CellSource source;
  const auto fine = source.record_of(cell("{\"n\": 1}"), [] {
    sweep::CellReport report;
    report.exact = "{\"a\":1}";
    return std::optional(report);
  });
  EXPECT_EQ(fine.value().exact, "{\"a\":1}");
  const auto thrown = source.record_of(cell("{\"n\": 1}"), []() -> std::optional<sweep::CellReport> {
    throw std::logic_error("no way");
  });
  EXPECT_EQ(thrown.value().outcome, sweep::Outcome::kCrash);
  EXPECT_EQ(thrown.value().message, "no way");
}

// `kinex verify` goes on after a cell that crashes, and says so.
TEST_F(ACellSource, ACrashIsAFailedCheckOfItsCell) {
  verify::VerifyOptions options;
  options.jobs = 2;
  options.source.program = program("kill -ABRT $$");
  const verify::VerifyResult result = verify::run_catalogue(test::small_catalogue(), options);
  EXPECT_FALSE(result.interrupted);
  ASSERT_EQ(result.cells.size(), 4u);
  EXPECT_EQ(starts(), 4);
  for (const lab::CellResult& one : result.cells) {
    EXPECT_EQ(one.verdict(), lab::Verdict::kRefuted);
    EXPECT_THAT(verify::table_row(one), HasSubstr("FAIL error: expected runs to the end, observed crash"));
  }
}

}  // namespace cell_source_test
}  // namespace kinex
