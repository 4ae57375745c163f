// SPDX-License-Identifier: GPL-3.0-or-later
// kinex ccd from outside: answers, tallies, exit codes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "experiments/formats/json_document.h"
#include "tests/program/spawn.h"

namespace kinex {
namespace ccd_verb_test {

using testing::HasSubstr;

// A vertex that falls through a triangle with the height 1 - 3 t, or beside it.
std::string falling(const char* x, const std::string& truth) {
  const std::string triangle =
      "-1,1,-1,1,0,1" + truth + "\n2,1,-1,1,0,1" + truth + "\n-1,1,2,1,0,1" + truth + "\n";
  return std::string(x) + ",1,0,1,1,1" + truth + "\n" + triangle + std::string(x) + ",1,0,1,-2,1" +
         truth + "\n" + triangle;
}

// A triangle that turns while a vertex goes over it at height 2: contact when 4 t^2 = 2.
std::string turning() {
  return "0,1,-4,1,2,1\n-9,1,-4,1,0,1\n9,1,-4,1,0,1\n0,1,4,1,0,1\n"
         "0,1,0,1,2,1\n-9,1,-4,1,0,1\n9,1,-4,1,0,1\n0,1,4,1,8,1\n";
}

class CcdVerb : public testing::Test {
 protected:
  std::string file(const std::string& name, const std::string& text) {
    const std::string path = scratch_.file(name);
    write_file(path, text);
    return path;
  }
  ScratchFolder scratch_;
};

TEST_F(CcdVerb, AnswersWithExactTimes) {
  const std::string path = file("vertex-face.csv", falling("0", "") + falling("9", "") + turning());
  const Finished run = run_kinex({"ccd", path});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(run.out,
            "query 1 (line 1): contact at 1/3 = 0.33333333333333333\n"
            "query 2 (line 9): no contact\n"
            "query 3 (line 17): contact at 0.70710678118654752, root 2 of -1 0 2 (low degree "
            "first), in [1/2, 1]\n" +
                path + ": 3 queries, vertex-face: 2 contacts; the file tells no truth\n");
}

TEST_F(CcdVerb, Json) {
  const std::string path = file("q.csv", falling("0", "") + turning() + falling("9", ""));
  const Finished run = run_kinex({"ccd", path, "--kind", "vertex-face", "--json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  std::vector<formats::JsonDocument> lines;
  for (std::size_t at = 0; at < run.out.size(); at = run.out.find('\n', at) + 1) {
    lines.push_back(formats::parse_json(run.out.substr(at, run.out.find('\n', at) - at), "out"));
  }
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(run.out.substr(0, run.out.find('\n')),
            "{\"query\": 1, \"line\": 1, \"contact\": true, \"time\": {\"polynomial\": [\"-1\", "
            "\"3\"], \"root\": 1, \"interval\": [\"1/3\", \"1/3\"], \"decimal\": "
            "\"0.33333333333333333\"}, \"truth\": null}");
  const formats::JsonValue& time = *lines[1]->find("time");
  EXPECT_EQ(time.find("polynomial")->items().size(), 3u);
  EXPECT_EQ(time.find("root")->text(), "2");
  EXPECT_EQ(time.find("decimal")->text(), "0.70710678118654752");
  EXPECT_EQ(lines[2]->find("line")->text(), "17");
  EXPECT_EQ(lines[3]->find("contacts")->text(), "2");
}

TEST_F(CcdVerb, TruthDecidesTheExitCode) {
  const std::string right = file("vertex-face-right.csv", falling("0", ",1") + falling("9", ",0"));
  const std::string wrong =
      file("vertex-face-wrong.csv", falling("0", ",0") + falling("9", ",1") + falling("0", ",1"));
  const Finished fine = run_kinex({"ccd", right});
  EXPECT_EQ(fine.exit_code, 0);
  EXPECT_THAT(
      fine.out,
      HasSubstr("1 true positive, 1 true negative, 0 false positives, 0 false negatives\n"));
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{}, std::vector<std::string>{"--tally"}}) {
    std::vector<std::string> arguments{"ccd", wrong, right};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Finished bad = run_kinex(arguments);
    EXPECT_EQ(bad.exit_code, 1);
    EXPECT_THAT(bad.out, HasSubstr("wrong.csv: 3 queries, vertex-face: 2 contacts; against the "
                                   "file: 1 true positive, 0 true negatives, 1 false positive, "
                                   "1 false negative\n"));
    EXPECT_THAT(bad.out, HasSubstr("right.csv: 2 queries"));
    EXPECT_EQ(bad.out.find("query 1") == std::string::npos, !more.empty());
  }
  EXPECT_THAT(run_kinex({"ccd", wrong}).out,
              HasSubstr("query 2 (line 9): no contact; the file says contact\n"));
}

TEST_F(CcdVerb, TheKindIsToldOrAskedFor) {
  const std::string path = file("data.csv", falling("0", ""));
  const Finished unknown = run_kinex({"ccd", path});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_EQ(unknown.out, "");
  EXPECT_THAT(unknown.err, HasSubstr("give --kind vertex-face or --kind edge-edge"));
  EXPECT_EQ(run_kinex({"ccd", path, "--kind", "edge-edge"}).exit_code, 0);
  const Finished wrong = run_kinex({"ccd", path, "--kind", "face-vertex"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("--kind: \"face-vertex\" is not a kind of query; write"));
  EXPECT_EQ(run_kinex({"ccd", "-", "--kind", "vertex-face"}, falling("0", "")).exit_code, 0);
  EXPECT_EQ(run_kinex({"ccd", "-"}, falling("0", "")).exit_code, 2);
  EXPECT_EQ(run_kinex({"ccd"}).exit_code, 2);
  EXPECT_EQ(run_kinex({"ccd", scratch_.file("edge-edge-missing.csv")}).exit_code, 2);
}

TEST_F(CcdVerb, ManyQueries) {
  std::string text;
  for (int i = 0; i < 3000; ++i) text += falling(i % 3 == 0 ? "0" : "9", i % 3 == 0 ? ",1" : ",0");
  const Finished run = run_kinex({"ccd", file("vertex-face.csv", text)});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 3001);
  EXPECT_THAT(run.out, HasSubstr("1000 true positives, 2000 true negatives"));
}

}  // namespace ccd_verb_test
}  // namespace kinex
