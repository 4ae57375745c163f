// SPDX-License-Identifier: GPL-3.0-or-later
// Outputs that are no files of their own: pipes, standard output by another name; temporary files that were there before; and
// signals that are ignored.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/places.h"
#include "tests/program/spawn.h"

namespace kinex {
namespace pipes_test {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

// b appears at 3 in touch with a.
const char* const kRefused =
    R"({"kinex": 1, "name": "refused", "dimension": 2, "time": {"start": 0, "end": 9},
 "objects": [
  {"id": "a", "polygon": [[-1, -1], [1, -1], [1, 1], [-1, 1]], "motion": [[0], [0]]},
  {"id": "b", "polygon": [[-1, -1], [1, -1], [1, 1], [-1, 1]],
   "motion": [{"from": 3, "coordinates": [[0], [5, -1]]}]}
 ],
 "maintain": ["separation_mixed"]})";

class Pipes : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(run_kinex({"gen", "grid", "--n", "9", "-o", scene_}).exit_code, 0);
    ASSERT_EQ(run_kinex({"run", scene_, "-q", "--events", scratch_.file("log")}).exit_code, 0);
    log_ = read_file(scratch_.file("log"));
    ASSERT_THAT(log_, StartsWith("{\"format\""));
  }
  // What a shell makes of the words behind the scratch folder's name, $1, the program's, $2, and the scene's, $3.
  struct Shell {
    int exit_code;
    std::string out, err;
  };
  Shell shell(const std::string& script) const {
    const std::string out = scratch_.file("shell.out"), err = scratch_.file("shell.err");
    write_file(scratch_.file("script"), script);
    const std::string command = "cd '" + scratch_.path().string() +
                                "' && sh script . " KINEX_PROGRAM " '" + scene_ + "' > '" + out +
                                "' 2> '" + err + "'";
    const int status = std::system(command.c_str());
    return {WEXITSTATUS(status), read_file(out), read_file(err)};
  }
  ScratchFolder scratch_;
  const std::string scene_ = scratch_.file("scene.json");
  std::string log_;
};

TEST_F(Pipes, GetTheWholeLog) {
  const Shell done = shell(
      "mkfifo pipe\ncat pipe > got &\n\"$2\" run \"$3\" -q --events pipe\ncode=$?\nwait\nexit "
      "$code\n");
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(read_file(scratch_.file("got")), log_);
}

// The part up to the change is made once more, but the reader gets it once.
TEST_F(Pipes, GetTheLogOfARefusedRunOnce) {
  write_file(scratch_.file("refused.json"), kRefused);
  for (const char* reader :
       {"mkfifo pipe\ncat pipe > got &\ntimeout 60 \"$2\" run refused.json -q --events pipe\n",
        "timeout 60 \"$2\" run refused.json -q --events /dev/fd/3 3> got\n"}) {
    const Shell done =
        shell(std::string("rm -f pipe got\n") + reader + "code=$?\nwait\nexit $code\n");
    EXPECT_EQ(done.exit_code, 2) << reader << done.err;
    const std::string got = read_file(scratch_.file("got"));
    EXPECT_THAT(got, HasSubstr("\n{\"end\": \"interrupted\"")) << reader;
    EXPECT_EQ(got.find("\"format\": \"kinex-log\"", 20), std::string::npos) << reader;
    const Finished checked = run_kinex({"check", scratch_.file("got")});
    EXPECT_EQ(checked.exit_code, 0) << reader << checked.err;
  }
}

// A pipe without a reader: one signal ends the wait.
TEST_F(Pipes, ASignalEndsTheWaitForAReader) {
  const Shell done =
      shell("mkfifo pipe\ntimeout -k 60 4 \"$2\" run \"$3\" -q --events pipe\nexit $?\n");
  EXPECT_EQ(done.exit_code, 124) << done.err;
  EXPECT_THAT(done.err, HasSubstr("pipe: cannot be written: "));
}

TEST_F(Pipes, StandardOutputByAnotherName) {
  const Shell run = shell("\"$2\" run \"$3\" --events /dev/stdout | cat\n");
  EXPECT_EQ(run.out, log_);
  EXPECT_THAT(run.err, HasSubstr("objects   9"));
  const Shell both = shell("\"$2\" run \"$3\" --events /dev/stdout --json | cat\nexit 0\n");
  EXPECT_THAT(both.err, HasSubstr("--json: standard output has the event log"));
  const Shell page = shell("\"$2\" view \"$3\" -o /dev/stdout | cat\n");
  EXPECT_THAT(page.out, StartsWith("<!DOCTYPE html>"));
  EXPECT_THAT(page.out, testing::EndsWith("</html>\n"));
}

// Numbers of processes come again: a file that the program has not made is not its own.
TEST_F(Pipes, ATemporaryFileThatIsThereIsLeftAlone) {
  const Shell done =
      shell("echo precious > \"x.jsonl.partial-$$\"\nexec \"$2\" run \"$3\" --events x.jsonl\n");
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(read_file(scratch_.file("x.jsonl")), log_);
  EXPECT_THAT(done.err, HasSubstr("x.jsonl.partial-"));
  int kept = 0;
  for (const auto& entry : std::filesystem::directory_iterator(scratch_.path())) {
    if (entry.path().filename().string().find(".partial-") == std::string::npos) continue;
    EXPECT_EQ(read_file(entry.path().string()), "precious\n") << entry.path();
    ++kept;
  }
  EXPECT_EQ(kept, 1);
}

// As in a script's background, whose shell has it ignored.
TEST_F(Pipes, AnIgnoredInterruptIsIgnored) {
  const Shell done = shell(
      "trap '' INT\nmkfifo pipe\n\"$2\" run - -q --events out.jsonl < pipe &\nprogram=$!\nexec 4> "
      "pipe\nsleep 0.2\n"
      "kill -INT $program\ncat \"$3\" >&4\nexec 4>&-\nwait $program\nexit $?\n");
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(read_file(scratch_.file("out.jsonl")), log_);
}

}  // namespace pipes_test
}  // namespace kinex
