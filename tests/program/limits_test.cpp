// SPDX-License-Identifier: GPL-3.0-or-later
// Runs that end at a limit, by a signal, with a reader that is gone or with no memory left: they
// say so with exit code 3 (or that they cannot write), and what they finished is complete.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/places.h"
#include "tests/program/spawn.h"
#include "tests/sanitized.h"

namespace kinex {
namespace limits_test {

using testing::EndsWith;
using testing::HasSubstr;

class Limits : public testing::Test {
 protected:
  // Runs a line of the shell in the folder; $KINEX is the program. Its exit code.
  int shell(const std::string& line) const {
    const std::string command = "cd '" + scratch_.path().string() + "' && KINEX='" KINEX_PROGRAM
                                "' && { " + line + "; } 2> err";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }
  std::string file(const std::string& name) const { return read_file(scratch_.file(name)); }
  // The files of `--events log --summary sum` are whole, and say how the run ended.
  void expect_files(const std::string& status) const {
    const std::string log = file("log");
    EXPECT_THAT(log, EndsWith("}\n"));
    const std::size_t last = log.rfind('\n', log.size() - 2) + 1;
    EXPECT_THAT(log.substr(last), HasSubstr("\"end\": \"" + status + "\"")) << file("err");
    EXPECT_THAT(file("sum"), HasSubstr("\"status\": \"" + status + "\""));
    for (const auto& entry : std::filesystem::directory_iterator(scratch_.path())) {
      EXPECT_THAT(entry.path().string(), Not(HasSubstr(".partial")));
    }
  }
  // Points on a line with motions of this degree, and of numbers of this size in between.
  void write_points(int degree, const std::string& start, const std::string& end) const {
    std::string text = R"({"kinex": 1, "name": "points", "dimension": 1, "time": {"start": ")" +
                       start + R"(", "end": ")" + end + R"("}, "maintain": ["sorted_list"], )" +
                       R"("objects": [)";
    unsigned random = 1;
    for (int i = 0; i < 4; ++i) {
      text += (i == 0 ? "" : ", ") + std::string(R"({"id": "o)") + std::to_string(i) +
              R"(", "motion": [[)";
      for (int k = 0; k <= degree; ++k) {
        random = random * 1103515245u + 12345u;
        text += (k == 0 ? "\"" : ", \"") + std::to_string(static_cast<int>(random >> 16) % 19 - 9) +
                "/" + std::to_string((random >> 20) % 97 + 2) + "\"";
      }
      text += "]]}";
    }
    write_file(scratch_.file("scene"), text + "]}");
  }

  ScratchFolder scratch_;
};

TEST_F(Limits, ALongRunInSturmIsInterrupted) {
  ASSERT_EQ(shell("$KINEX gen sort-worst --n 700 -o scene"), 0) << file("err");
  for (const char* signal : {"INT", "TERM", "HUP"}) {
    EXPECT_EQ(shell(std::string("timeout --foreground --preserve-status -s ") + signal +
                    " 0.6 $KINEX run scene --arithmetic sturm --force --events log --summary sum "
                    "> out"),
              3)
        << signal << file("err");
    expect_files("interrupted");
  }
}

TEST_F(Limits, ALongComputationIsStopped) {
  write_points(200, "-1", "1");
  for (const char* arithmetic : {"exact", "sturm"}) {
    SCOPED_TRACE(arithmetic);
    EXPECT_EQ(shell(std::string("$KINEX run scene --max-seconds 0.05 --force --events log "
                                "--summary sum --arithmetic ") + arithmetic + " > out"),
              3)
        << file("err");
    expect_files("limit");
  }
}

TEST_F(Limits, HugeTimesAreStopped) {
  write_points(120, "-1e99998", "1e99998");
  for (const char* arithmetic : {"exact", "sturm"}) {
    SCOPED_TRACE(arithmetic);
    EXPECT_EQ(shell(std::string("$KINEX run scene --max-seconds 0.2 --force --events log "
                                "--summary sum --arithmetic ") + arithmetic + " > out"),
              3)
        << file("err");
  }
}

TEST_F(Limits, AReportThatNobodyReadsLeavesTheFilesWhole) {
  ASSERT_EQ(shell("$KINEX gen uniform-square --n 30 -o scene"), 0);
  EXPECT_EQ(shell("(sleep 0.1; $KINEX run scene --events log --summary sum; echo $? > code) | true"),
            0);
  EXPECT_EQ(file("code"), "2\n");
  EXPECT_THAT(file("err"), HasSubstr("standard output: cannot be written"));
  expect_files("done");
}

// A limit on the size of files is an error of writing, not the end of the program.
TEST_F(Limits, AFileThatMayNotGrowIsToldOf) {
  EXPECT_EQ(shell("(ulimit -f 16; exec $KINEX gen uniform-square --n 2000 -o scene)"), 2);
  EXPECT_THAT(file("err"), HasSubstr("scene"));
  EXPECT_THAT(file("err"), HasSubstr("cannot be written: File too large"));
  EXPECT_EQ(file("scene"), "");
  EXPECT_EQ(shell("(ulimit -f 16; exec $KINEX gen uniform-square --n 2000 > out)"), 2);
  EXPECT_THAT(file("err"), HasSubstr("standard output: cannot be written: File too large"));
}

// A scene that is small on disk: GMP asks for more than there is, in the reader or in the run.
TEST_F(Limits, TheEndOfMemoryIsALimit) {
  if (test::kSanitized) GTEST_SKIP() << "the sanitizer needs more memory than this leaves";
  std::string text = R"({"kinex": 1, "dimension": 1, "time": {"start": 0, "end": 1}, "objects": [)";
  for (int i = 0; i < 12; ++i) {
    text += (i == 0 ? "" : ", ") + std::string(R"({"id": "o)") + std::to_string(i) +
            R"(", "motion": [[)";
    for (int k = 0; k < 40; ++k) {
      text += (k == 0 ? "\"" : ", \"") + std::to_string(7 * i + k * k - 99) + "e" +
              std::to_string(99000 + 11 * i + 13 * k) + "\"";
    }
    text += "]]}";
  }
  write_file(scratch_.file("scene"), text + R"(], "maintain": ["sorted_list"]})");
  // The program itself needs more than 36,000 to begin.
  for (const char* size : {"40000", "60000"}) {
    EXPECT_EQ(shell(std::string("ulimit -v ") + size + "; $KINEX run scene > out"), 3) << size;
    EXPECT_THAT(file("err"), HasSubstr("memory")) << size;
  }
}

}  // namespace limits_test
}  // namespace kinex
