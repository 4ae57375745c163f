// SPDX-License-Identifier: GPL-3.0-or-later
// A run that comes to a change that cannot be made: what was finished before it is written. One that
// becomes corrupt says so once.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/program/spawn.h"

namespace kinex {
namespace refused_run_test {

using testing::HasSubstr;
using testing::Not;

// b meets a at 1 and passes; c appears at 6 in touch with a, and goes on into it.
const char* const kScene =
    R"({"kinex": 1, "name": "refused", "dimension": 2, "time": {"start": 0, "end": 9},
 "objects": [
  {"id": "a", "polygon": [[-1, -1], [1, -1], [1, 1], [-1, 1]], "motion": [[0], [0]]},
  {"id": "b", "polygon": [[-1, -1], [1, -1], [1, 1], [-1, 1]], "motion": [[3, -1], [0]]},
  {"id": "c", "polygon": [[-1, -1], [1, -1], [1, 1], [-1, 1]],
   "motion": [{"from": 6, "coordinates": [[0], [8, -1]]}]}
 ],
 "maintain": ["separation_mixed"]})";

TEST(RefusedRun, WritesWhatWasFinished) {
  ScratchFolder scratch;
  const std::string scene = scratch.file("scene.json"), log = scratch.file("log.jsonl");
  const std::string summary = scratch.file("summary.json");
  write_file(scene, kScene);
  const Finished refused = run_kinex({"run", scene, "--events", log, "--summary", summary});
  EXPECT_EQ(refused.exit_code, 2) << refused.err;
  EXPECT_THAT(refused.err,
              HasSubstr("kinex: " + scene +
                        ": /objects/2/motion/0: \"c\" appears at 6 in contact with \"a\"; "));
  EXPECT_THAT(refused.err, HasSubstr("\"overlapping_starts\": \"contact\""));
  EXPECT_THAT(refused.err, Not(HasSubstr("internal error")));
  const std::string events = read_file(log);
  EXPECT_THAT(events, HasSubstr(R"("kind": "contact", "ids": ["a", "b", )"));
  EXPECT_THAT(events, HasSubstr(R"("kind": "separation", "ids": ["a", "b", )"));
  EXPECT_THAT(events, Not(HasSubstr(R"("kind": "insert")")));
  EXPECT_THAT(events, HasSubstr("\n{\"end\": \"interrupted\""));
  EXPECT_THAT(read_file(summary), HasSubstr(R"("contact": 1)"));
  const Finished checked = run_kinex({"check", log});
  EXPECT_EQ(checked.exit_code, 0) << checked.err << checked.out;
  // The remedy.
  std::string allowed = kScene;
  allowed.insert(1, "\"overlapping_starts\": \"contact\", ");
  write_file(scene, allowed);
  const Finished done = run_kinex({"run", scene, "--events", log, "--force", "--audit", "events"});
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_THAT(read_file(log), HasSubstr(R"("kind": "overlap", "ids": ["a", "c"])"));
  const Finished good = run_kinex({"check", log});
  EXPECT_EQ(good.exit_code, 0) << good.err << good.out;
  const std::string page = scratch.file("page.html");
  EXPECT_EQ(run_kinex({"view", log, "--scene", scene, "-o", page}).exit_code, 0);
  EXPECT_EQ(run_kinex({"view", scene, "-o", page, "--force"}).exit_code, 0);
}

TEST(RefusedRun, AViewSaysTheSame) {
  ScratchFolder scratch;
  const std::string scene = scratch.file("scene.json");
  write_file(scene, kScene);
  const Finished viewed = run_kinex({"view", scene, "-o", scratch.file("page.html")});
  EXPECT_EQ(viewed.exit_code, 2);
  EXPECT_THAT(viewed.err,
              HasSubstr("kinex: " + scene +
                        ": /objects/2/motion/0: \"c\" appears at 6 in contact with \"a\"; "));
}

TEST(CorruptRun, SaysSoOnce) {
  ScratchFolder scratch;
  const std::string scene = scratch.file("grid.json"), summary = scratch.file("summary.json");
  ASSERT_EQ(
      run_kinex({"gen", "grid", "--n", "36", "--maintain", "delaunay_2", "-o", scene}).exit_code,
      0);
  for (const std::string audit : {"end", "none"}) {
    const Finished run = run_kinex({"run", scene, "--arithmetic", "double", "--audit", audit, "-q",
                                    "--summary", summary, "--force"});
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_EQ(
        run.err,
        "kinex: delaunay_2 is corrupt: the static construction found no place for a point (at t = "
        "0.3333333333)\n");
    EXPECT_THAT(read_file(summary),
                HasSubstr("\"corrupt\": \"the static construction found no place"));
  }
}

}  // namespace refused_run_test
}  // namespace kinex
