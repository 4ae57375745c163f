// SPDX-License-Identifier: GPL-3.0-or-later
// Queries in scenes and on the command line: what is read, written and refused.
#include "experiments/formats/box_queries.h"

#include <gtest/gtest.h>

#include "experiments/formats/scene_reader.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/formats/summary.h"
#include "experiments/lab/scene_run.h"
#include "tests/experiments/expect_input_error.h"

namespace kinex {
namespace box_queries_test {

Scene parse(const std::string& text) { return formats::parse_scene(text, "s.json"); }

// A scene of two points from 0 to 4, with this "queries".
std::string asking(const std::string& queries, const std::string& maintain = R"("rank_kd_tree_2")",
                   const std::string& end = R"(, "end": 4)") {
  return R"({"kinex": 1, "dimension": 2, "time": {"start": 0)" + end + R"(},
             "objects": [{"id": "a", "motion": [[0, 1], [1]]}, {"id": "b", "motion": [[2], [3, -1]]}],
             "maintain": [)" +
         maintain + R"(], "queries": )" + queries + "}";
}

constexpr const char* kGood = R"([{"at": "1/2", "box": [["0", "1"], ["1/4", 0.75]]},
                                  {"at": 4, "box": [[-1, -1], [0, 1e2]]}])";

TEST(BoxQueries, AreReadAndWritten) {
  const Scene scene = parse(asking(kGood));
  ASSERT_EQ(scene.queries.size(), 2u);
  EXPECT_EQ(scene.queries[0].at, Rational(Integer(1), Integer(2)));
  EXPECT_EQ(scene.queries[0].box[1][0], Rational(Integer(1), Integer(4)));
  EXPECT_EQ(scene.queries[0].box[1][1], Rational(Integer(3), Integer(4)));
  EXPECT_EQ(scene.queries[1].box[1][1], Rational(100));
  const std::string text = formats::write_scene(scene);
  EXPECT_THAT(text, testing::HasSubstr(R"(  {"at": "1/2", "box": [[0, 1], ["1/4", "3/4"]]})"));
  EXPECT_EQ(formats::write_scene(parse(text)), text);
  Scene silent = scene;
  silent.queries.clear();
  EXPECT_NE(formats::scene_hash(silent), formats::scene_hash(scene));
  EXPECT_EQ(formats::scene_hash(silent), formats::scene_hash(parse(asking("[]"))));
}

TEST(BoxQueries, BadOnesAreRefused) {
  struct Bad {
    const char* queries;
    const char* says;
  };
  const Bad all[] = {
      {"7", "/queries: 7 is not"},
      {"null", "/queries"},
      {"{}", "/queries"},
      {"[7]", "/queries/0: 7 is not"},
      {R"(["box"])", "/queries/0: \"box\" is not"},
      {"[[]]", "/queries/0"},
      {"[{}]", "/queries/0: \"at\" is missing"},
      {R"([{"at": 1}])", "/queries/0: \"box\" is missing"},
      {R"([{"box": [[0, 1], [0, 1]]}])", "/queries/0: \"at\" is missing"},
      {R"([{"at": 1, "box": [[0, 1], [0, 1]], "in": 7}])", "\"in\""},
      {R"([{"at": "soon", "box": [[0, 1], [0, 1]]}])", "/queries/0/at: \"soon\" is not"},
      {R"([{"at": [], "box": [[0, 1], [0, 1]]}])", "/queries/0/at"},
      {R"([{"at": "1/0", "box": [[0, 1], [0, 1]]}])", "/queries/0/at: \"1/0\" has the denominator 0"},
      {R"([{"at": -1, "box": [[0, 1], [0, 1]]}])", "/queries/0/at: a query at -1, outside"},
      {R"([{"at": "9/2", "box": [[0, 1], [0, 1]]}])", "write a time from 0 on, at most 4"},
      {R"([{"at": 1, "box": 3}])", "/queries/0/box: 3 is not"},
      {R"([{"at": 1, "box": {}}])", "/queries/0/box"},
      {R"([{"at": 1, "box": []}])", "a box of 0 axes in a scene of 2 axes"},
      {R"([{"at": 1, "box": [[0, 1]]}])", "a box of 1 axis in a scene of 2 axes; write"},
      {R"([{"at": 1, "box": [[0, 1], [0, 1], [0, 1]]}])", "a box of 3 axes"},
      {R"([{"at": 1, "box": [0, 1]}])", "/queries/0/box/0: 0 is not"},
      {R"([{"at": 1, "box": [[0, 1], [0]]}])", "/queries/0/box/1: a side of 1 number; write"},
      {R"([{"at": 1, "box": [[0, 1, 2], [0, 1]]}])", "/queries/0/box/0: a side of 3 numbers"},
      {R"([{"at": 1, "box": [[], [0, 1]]}])", "a side of 0 numbers"},
      {R"([{"at": 1, "box": [[0, 1], ["a", 1]]}])", "/queries/0/box/1/0: \"a\" is not"},
      {R"([{"at": 1, "box": [[0, null], [0, 1]]}])", "/queries/0/box/0/1: null is not"},
      {R"([{"at": 1, "box": [[0, 1], [1, "3/4"]]}])",
       "/queries/0/box/1: an empty box: along y it begins at 1 and ends at 3/4 (0.75); write"},
      {R"([{"at": 1, "box": [[1, 0], [0, 1]]}])", "an empty box: along x"},
      {R"([{"at": 1, "box": [[0, 1], [0, 1]]}, {"at": 5, "box": [[0, 1], [0, 1]]}])",
       "/queries/1/at: a query at 5"},
  };
  for (const Bad& bad : all) {
    SCOPED_TRACE(bad.queries);
    EXPECT_INPUT_ERROR(parse(asking(bad.queries)), bad.says);
    EXPECT_INPUT_ERROR(parse(asking(bad.queries)), "s.json: /queries");
  }
}

TEST(BoxQueries, ScenesThatCannotAnswerAreRefused) {
  const std::string unanswered =
      "s.json: /queries/0: a query that no structure answers; maintain one of "
      "range_tree_2, rank_kd_tree_2, pseudo_kd_tree_2";
  EXPECT_INPUT_ERROR(parse(asking(kGood, R"("sorted_list")")), unanswered);
  EXPECT_INPUT_ERROR(parse(asking(kGood, R"("delaunay_2", "bounding_box")")), unanswered);
  EXPECT_INPUT_ERROR(parse(asking(kGood, R"({"structure": "range_tree_2", "as": "box"})")),
                     "the label \"box\" of a structure that answers queries");
  EXPECT_INPUT_ERROR(parse(asking(kGood, R"({"structure": "range_tree_2", "as": "queries"})")),
                     "/maintain/0/as: \"queries\" is not a usable label");
  // --maintain may give an answer; without end every later time is the scene's.
  EXPECT_EQ(parse(asking(kGood, "")).queries.size(), 2u);
  EXPECT_EQ(parse(asking(R"([{"at": 99, "box": [[0, 1], [0, 1]]}])", R"("range_tree_2")", ""))
                .queries.size(),
            1u);
  EXPECT_INPUT_ERROR(parse(asking("[]", R"({"structure": "pseudo_kd_tree_2", "delta": "1/2"})")),
                     "cannot have delta = \"1/2\"; write a number of at least 0 and less than 1/2");
  EXPECT_INPUT_ERROR(parse(asking("[]", R"({"structure": "pseudo_kd_tree_2", "delta": -1})")),
                     "cannot have delta = -1");
  EXPECT_INPUT_ERROR(parse(asking("[]", R"({"structure": "rank_kd_tree_2", "delta": 0})")),
                     "delta");
  EXPECT_INPUT_ERROR(parse(asking("[]", R"({"structure": "rank_kd_tree_2", "key": "x"})")),
                     "takes no key");
  EXPECT_INPUT_ERROR(parse(R"({"kinex": 1, "dimension": 1, "time": {"start": 0}, "objects": [],
                "maintain": ["range_tree_2"]})"),
                     "needs 2 axes, the scene has 1");
  EXPECT_INPUT_ERROR(parse(R"({"kinex": 1, "dimension": 3, "time": {"start": 0}, "objects": [],
                "maintain": ["range_tree_2"]})"),
                     "is for 2 axes, the scene has 3");
}

TEST(BoxQueries, TheOption) {
  const Scene scene = parse(asking("[]"));
  const auto box = formats::read_box_option("-1,1/2,0,1e1", scene);
  ASSERT_EQ(box.size(), 2u);
  EXPECT_EQ(box[0][1], Rational(Integer(1), Integer(2)));
  EXPECT_EQ(box[1][1], Rational(10));
  EXPECT_INPUT_ERROR(formats::read_box_option("", scene), "--query: \"\" of \"\" is no number");
  EXPECT_INPUT_ERROR(formats::read_box_option("1,2,3", scene),
                     "--query: \"1,2,3\" has 3 numbers, the scene has 2 axes; write two numbers");
  EXPECT_INPUT_ERROR(formats::read_box_option("1,2,3,4,5", scene), "has 5 numbers");
  EXPECT_INPUT_ERROR(formats::read_box_option("1,2,x,4", scene),
                     "\"x\" of \"1,2,x,4\" is no number");
  EXPECT_INPUT_ERROR(formats::read_box_option("1,2,,4", scene), "\"\" of \"1,2,,4\" is no number");
  EXPECT_INPUT_ERROR(formats::read_box_option("1,2,3,4,", scene), "is no number");
  EXPECT_INPUT_ERROR(formats::read_box_option("2,1,3,4", scene), "an empty box: along x");
  EXPECT_INPUT_ERROR(formats::read_box_option("1,2,4,3", scene),
                     "along y it begins at 4 and ends at 3; write the smaller number first");
}

TEST(BoxQueries, AnswersStandInTheSample) {
  const Scene scene = parse(asking(
      R"([{"at": 2, "box": [[0, 2], [1, 1]]}, {"at": 1, "box": [[1, 2], [1, 2]]},
          {"at": 2, "box": [[2, 3], [-9, 9]]}])",
      R"("range_tree_2", "rank_kd_tree_2", "bounding_box",
         {"structure": "pseudo_kd_tree_2", "as": "half", "delta": "2/5"})"));
  const auto simulator = lab::make_simulator(scene, "exact", {});
  const formats::RunOutcome outcome = lab::run_scene(*simulator, {Rational(3)});
  ASSERT_EQ(outcome.samples.size(), 3u);  // at 1, 2 and 3
  EXPECT_EQ(outcome.samples[0].queries.size(), 1u);
  ASSERT_EQ(outcome.samples[1].queries.size(), 2u);
  EXPECT_TRUE(outcome.samples[2].queries.empty());
  const auto ids = [&](std::size_t sample, std::size_t query) {
    const auto& answers = outcome.samples[sample].queries[query].answers;
    EXPECT_EQ(answers.size(), 3u);
    for (const auto& answer : answers) EXPECT_EQ(answer.ids, answers[0].ids);
    return answers[0].ids;
  };
  // a = (t, 1), b = (2, 3 - t): right after 1 both are in the box; right after 2 a has left, and
  // b is below.
  EXPECT_EQ(ids(0, 0), (std::vector<ObjectId>{0, 1}));
  EXPECT_EQ(ids(1, 0), std::vector<ObjectId>{});
  EXPECT_EQ(ids(1, 1), (std::vector<ObjectId>{0, 1}));
  const std::string summary = formats::write_summary(*simulator, outcome, "", "", {});
  EXPECT_THAT(summary,
              testing::HasSubstr(R"("queries": [{"box": [["1", "2"], ["1", "2"]], "range_tree_2": )"
                                 R"({"ids": ["a", "b"], "nodes": )"));
  EXPECT_THAT(summary, testing::HasSubstr(R"("half": {"ids": ["a", "b"], "nodes": )"));
}

}  // namespace box_queries_test
}  // namespace kinex
