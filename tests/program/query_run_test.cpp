// SPDX-License-Identifier: GPL-3.0-or-later
// kinex run with queries for boxes: answers, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/program/spawn.h"

namespace kinex {
namespace query_run_test {

using testing::HasSubstr;
using testing::StartsWith;
using Words = std::vector<std::string>;

// a = (t, 1), b = (2, 3 - t), 0 <= t <= 4.
std::string scene_text(const std::string& maintain, const std::string& queries) {
  return R"({"kinex": 1, "name": "asked", "dimension": 2, "time": {"start": 0, "end": 4},
 "objects": [{"id": "a", "motion": [[0, 1], [1]]}, {"id": "b", "motion": [[2], [3, -1]]}],
 "maintain": [)" +
         maintain + "]" + (queries.empty() ? "" : ", \"queries\": " + queries) + "}\n";
}

TEST(QueryRun, Answers) {
  ScratchFolder scratch;
  const std::string scene = scratch.file("scene.json"), summary = scratch.file("summary.json");
  write_file(scene, scene_text(R"("rank_kd_tree_2")", R"([{"at": 2, "box": [[2, 2], [1, 1]]}])"));
  const Finished run = run_kinex({"run", scene, "--at", "1,2", "--query", "-1,2,1,2", "--query",
                                  "0,1,0,1", "--summary", summary});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("at 1  rank_kd_tree_2 in [-1, 2] x [1, 2]: [\"a\", \"b\"] by "));
  // a is on the side of the second box at 1, and has left it right after.
  EXPECT_THAT(run.out, HasSubstr("at 1  rank_kd_tree_2 in [0, 1] x [0, 1]: [] by "));
  // Both are in the first box at 2, and none right after.
  EXPECT_THAT(run.out, HasSubstr("at 2  rank_kd_tree_2 in [2, 2] x [1, 1]: [] by "));
  EXPECT_THAT(read_file(summary),
              HasSubstr(R"("queries": [{"box": [["-1", "2"], ["1", "2"]], "rank_kd_tree_2": )"
                        R"({"ids": ["a", "b"], "nodes": 3, "signs": )"));
}

// Samples are results that were asked for: only the report around them is left out.
TEST(QueryRun, AnswersStayWhenQuiet) {
  ScratchFolder scratch;
  const std::string scene = scratch.file("scene.json"), summary = scratch.file("summary.json");
  write_file(scene, scene_text(R"("rank_kd_tree_2")", ""));
  const Words asked{"run", scene, "--at", "1,2", "--query", "-1,2,1,2", "-q"};
  const auto with = [&asked](const Words& more) {
    Words all = asked;
    all.insert(all.end(), more.begin(), more.end());
    return run_kinex(all);
  };
  const Finished quiet = with({});
  EXPECT_EQ(quiet.exit_code, 0);
  EXPECT_EQ(quiet.err, "");
  EXPECT_THAT(quiet.out, StartsWith("at 1  rank_kd_tree_2"));
  EXPECT_THAT(quiet.out, HasSubstr("\nat 1  rank_kd_tree_2 in [-1, 2] x [1, 2]: [\"a\", \"b\"] by "));
  EXPECT_THAT(quiet.out, HasSubstr("\nat 2  rank_kd_tree_2 "));
  EXPECT_EQ(std::count(quiet.out.begin(), quiet.out.end(), '\n'), 8) << quiet.out;
  EXPECT_THAT(run_kinex({"run", scene, "--at", "1,2", "--query", "-1,2,1,2"}).out, HasSubstr(quiet.out));
  EXPECT_EQ(with({"--summary", summary}).out, quiet.out);
  // The printed summary has them; beside the log they are on standard error.
  const Finished json = with({"--json"});
  EXPECT_THAT(json.out, StartsWith("{"));
  EXPECT_EQ(json.err, "");
  const Finished log = with({"--events", "-"});
  EXPECT_THAT(log.out, StartsWith("{"));
  EXPECT_EQ(log.err, quiet.out);
}

TEST(QueryRun, BadQueriesAreRefused) {
  ScratchFolder scratch;
  const std::string good = scratch.file("good.json"), asked = scratch.file("asked.json");
  const std::string list = scratch.file("list.json"), empty = scratch.file("empty.json");
  const std::string late = R"([{"at": 3, "box": [[0, 1], [0, 1]]}])";
  write_file(good, scene_text(R"("range_tree_2")", ""));
  write_file(asked, scene_text(R"("range_tree_2")", late));
  write_file(list, scene_text(R"("sorted_list")", late));
  write_file(empty, scene_text(R"("range_tree_2")", R"([{"at": 3, "box": [[1, 0], [0, 1]]}])"));
  struct Bad {
    std::vector<std::string> arguments;
    std::string says;
  };
  const std::vector<Bad> all{
      {{good, "--query", "0,1,0,1"}, "--query: there is no time at which it is asked; give --at"},
      {{good, "--at", "1", "--query", "0,1,0"}, "\"0,1,0\" has 3 numbers, the scene has 2 axes"},
      {{good, "--at", "1", "--query", "0,1,0,x"}, "--query: \"x\" of \"0,1,0,x\" is no number"},
      {{good, "--at", "1", "--query", "1,0,0,1"}, "is an empty box: along x it begins at 1"},
      {{good, "--at", "1", "--query", ""}, "--query"},
      {{good, "--at", "9", "--query", "0,1,0,1"}, "--at: \"9\" is outside of the run's time; write a time from 0 on, at most 4"},
      {{good, "--at", "1", "--query", "0,1,0,1", "--maintain", "delaunay_2"},
       "--query: a query that no structure answers; maintain one of range_tree_2"},
      {{asked, "--maintain", "sorted_list"}, "/queries/0: a query that no structure answers"},
      {{asked, "--until", "2"}, "--until: the scene's query 0 is at 3, after the end of the run"},
      {{list}, "list.json: /queries/0: a query that no structure answers"},
      {{empty}, "empty.json: /queries/0/box/0: an empty box: along x it begins at 1 and ends at 0"},
  };
  for (const Bad& bad : all) {
    std::vector<std::string> arguments{"run"};
    arguments.insert(arguments.end(), bad.arguments.begin(), bad.arguments.end());
    const Finished run = run_kinex(arguments);
    EXPECT_EQ(run.exit_code, 2) << bad.says;
    EXPECT_THAT(run.err, HasSubstr(bad.says));
  }
}

}  // namespace query_run_test
}  // namespace kinex
