// SPDX-License-Identifier: GPL-3.0-or-later
// Words of a command line that are easily taken for something else: no value behind an =, brackets, bytes that are no UTF-8,
// options that would be ignored.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/formats/utf8.h"
#include "tests/program/spawn.h"

namespace kinex {
namespace unusual_words_test {

using testing::HasSubstr;
using testing::Not;
using Words = std::vector<std::string>;

class UnusualWords : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(run_kinex({"gen", "grid", "--n", "9", "-o", scene_}).exit_code, 0);
  }
  void expect_refused(const Words& words, const std::string& message,
                      const std::string& input = "") const {
    const Finished refused = run_kinex(words, input);
    EXPECT_EQ(refused.exit_code, 2) << testing::PrintToString(words) << refused.out;
    EXPECT_THAT(refused.err, HasSubstr(message)) << testing::PrintToString(words);
    EXPECT_EQ(refused.out, "") << testing::PrintToString(words);
  }
  ScratchFolder scratch_;
  const std::string scene_ = scratch_.file("scene.json");
};

TEST_F(UnusualWords, NothingBehindAnEqualsSign) {
  expect_refused({"gen", "grid", "--n", "4", "--output=", "--force"},
                 "--output: there is nothing behind the =");
  expect_refused({"run", scene_, "--events=", "--json"}, "--events: there is nothing behind the =");
  EXPECT_FALSE(std::filesystem::exists("--force"));
}

TEST_F(UnusualWords, NamesInBrackets) {
  const std::string plan = scratch_.file("plan.json"), folder = scratch_.file("a");
  write_file(plan, R"({"kinex_plan": 1, "name": "p", "blocks": [{"structure": ["sorted_list"],
    "workload": ["uniform-square"], "n": [4], "seed": [1]}]})");
  const Finished ran = run_kinex({"sweep", "run", plan, "-o", folder});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(scratch_.path());
  std::filesystem::create_directory("[a]");
  const Finished other = run_kinex({"sweep", "status", "[a]"});
  const Finished itself = run_kinex({"sweep", "status", "a"});
  const Finished named = run_kinex({"gen", "grid", "--n", "4", "--name", "[x]"});
  const Finished unknown = run_kinex({"[x]"});
  std::filesystem::current_path(before);
  EXPECT_EQ(other.exit_code, 2) << other.out;
  EXPECT_THAT(other.err, HasSubstr("[a]: there is no attempt file in it"));
  EXPECT_EQ(itself.exit_code, 0) << itself.err;
  EXPECT_THAT(named.out, HasSubstr("\"name\": \"[x]\""));
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.err, Not(HasSubstr("\x01")));
}

TEST_F(UnusualWords, FlagsThatAreFalse) {
  EXPECT_NE(run_kinex({"run", scene_, "--quiet=false"}).out, "");
  EXPECT_EQ(run_kinex({"run", scene_, "--quiet=true"}).out, "");
}

TEST_F(UnusualWords, BytesThatAreNoUtf8) {
  const std::string odd = scratch_.file("s\xe9.json"), log = scratch_.file("log.jsonl");
  std::filesystem::copy_file(scene_, odd);
  const Finished summary = run_kinex({"run", odd, "--summary", "-"});
  EXPECT_EQ(summary.exit_code, 0) << summary.err;
  EXPECT_TRUE(formats::is_utf8(summary.out)) << summary.out;
  EXPECT_EQ(run_kinex({"run", odd, "-q", "--events", log, "--provenance"}).exit_code, 0);
  const Finished checked = run_kinex({"check", log, "--scene", odd});
  EXPECT_EQ(checked.exit_code, 0) << checked.err;
  const Finished trade =
      run_kinex({"trade", odd, "--quick", "--arithmetic", "double", "-o", scratch_.file("trade")});
  EXPECT_EQ(trade.exit_code, 0) << trade.err;
}

TEST_F(UnusualWords, ASceneWhoseNameIsFormat) {
  const std::string path = scratch_.file("format.json"), page = scratch_.file("page.html");
  ASSERT_EQ(run_kinex({"gen", "grid", "--n", "4", "--name", "format", "-o", path}).exit_code, 0);
  const Finished checked = run_kinex({"check", path});
  EXPECT_EQ(checked.exit_code, 0) << checked.err;
  const Finished seen = run_kinex({"view", path, "-o", page});
  EXPECT_EQ(seen.exit_code, 0) << seen.err;
}

TEST_F(UnusualWords, ANameThatIsTooLong) {
  expect_refused({"view", scene_, "--with", std::string(300, 'x'), "-o", scratch_.file("p.html")},
                 "is neither an arithmetic nor a file");
}

TEST_F(UnusualWords, LimitsThatAreNone) {
  const std::string folder = scratch_.file("trade");
  expect_refused({"trade", "sorted_list", "--quick", "--max-seconds", "inf", "-o", folder},
                 "--max-seconds: inf is not finite");
  expect_refused({"run", scene_, "--max-seconds", "inf"}, "--max-seconds: inf is not finite");
  EXPECT_FALSE(std::filesystem::exists(folder));
  const std::string cell = R"({"structure": "sorted_list", "workload": "uniform-square", "n": 4})";
  expect_refused({"sweep", "cell", cell, "--seconds", "-5"}, "--seconds: -5 is below 0");
  expect_refused({"sweep", "cell", cell, "--megabytes", "-1"}, "--megabytes: -1 is below 0");
  expect_refused({"sweep", "list", "trade", "sorted_list", "--quick", "--arithmetic", "foo"},
                 "foo");
  for (const char* seconds : {"soon", "5x", "-5", "nan", "inf", ""}) {
    write_file(
        scratch_.file("plan.json"),
        std::string(
            R"({"kinex_plan": 1, "name": "p", "select": {"experiment": "trade", "names": ["sorted_list"],
                 "quick": true, "options": {"max-seconds": [")") +
            seconds + "\"]}}}");
    expect_refused({"sweep", "list", scratch_.file("plan.json")}, "is no number of seconds");
  }
}

TEST_F(UnusualWords, OptionsThatWouldBeIgnored) {
  expect_refused({"sweep", "list", "--json"}, "--json: it is for the cells of a plan");
  expect_refused({"sweep", "list", "--shard", "0/2"}, "--shard: it is for the cells of a plan");
  expect_refused({"sweep", "list", "--quick"}, "--quick: it is for the cells of a plan");
  for (const char* verb : {"verify", "trade", "reproduce"}) {
    const Words from{verb, "sorted_list", "--from", "nowhere", "-o", scratch_.file("out")};
    Words fresh = from, jobs = from;
    fresh.push_back("--fresh");
    jobs.insert(jobs.end(), {"--jobs", "8"});
    if (std::string(verb) == "reproduce") fresh[1] = jobs[1] = "kds-report-1998";
    expect_refused(fresh, "--fresh: --from reports on what has been run, and runs nothing");
    expect_refused(jobs, "--jobs: --from reports on what has been run, and runs nothing");
  }
  write_file(scratch_.file("plan.json"),
             R"({"kinex_plan": 1, "name": "p", "select": {"experiment": "verify",
    "names": ["sorted_list"], "quick": true, "options": ["seeds", "8"]}})");
  expect_refused({"sweep", "list", scratch_.file("plan.json")}, "/select/options");
}

class UnusualImports : public UnusualWords {
 protected:
  const std::string body_ = scratch_.file("body.json");
  const std::string polygons_ = scratch_.file("polygons.csv");
  void SetUp() override {
    write_file(polygons_, "id,x,y\na,0,0\na,1,0\na,0,1\n");
    write_file(body_,
               R"({"type": "Feature", "id": "a", "temporalGeometry": {"type": "MovingPolygon",
      "datetimes": [0, 1000], "coordinates": [[[[0, 0], [1, 0], [0, 1], [0, 0]]], [[[2, 0], [3, 0], [2, 1], [2, 0]]]],
      "interpolation": "Linear"}})");
  }
};

TEST_F(UnusualImports, OptionsThatWouldBeIgnored) {
  const Words import{"import", body_, "--planar"};
  const auto with = [&](const Words& more) {
    Words all = import;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  const Finished made = run_kinex(import);
  ASSERT_EQ(made.exit_code, 0) << made.err;
  expect_refused(with({"--polygons", polygons_}),
                 "--polygons: the features have polygons of their own");
  expect_refused(with({"--ignore-columns"}), "--ignore-columns: it is for tables");
  expect_refused(with({"--column", "id=a", "--column", "id=b"}), "--column: id is named twice");
  const Finished contact = run_kinex(with({"--overlapping-starts", "contact"}));
  EXPECT_EQ(contact.exit_code, 0) << contact.err;
  EXPECT_THAT(contact.out, HasSubstr(R"("overlapping_starts": "contact")"));
}

// Queries of an exported scene stay where a structure answers them, and are named where none does.
TEST_F(UnusualImports, QueriesAreKept) {
  const std::string scene = scratch_.file("queries.json"),
                    exported = scratch_.file("queries.mf.json");
  write_file(scene, R"({"kinex": 1, "name": "q", "dimension": 2, "time": {"start": 0, "end": 2},
    "objects": [{"id": "a", "motion": [[0, 1], [0]]}, {"id": "b", "motion": [[1], [1, 1]]}],
    "maintain": ["range_tree_2"], "queries": [{"at": 1, "box": [[0, 2], [0, 2]]}]})");
  const Finished out = run_kinex({"export", scene, "--mf-json", "-o", exported});
  ASSERT_EQ(out.exit_code, 0) << out.err;
  for (const Words& maintain : {Words{}, Words{"--maintain", "range_tree_2"}}) {
    Words words{"import", exported, "--planar"};
    words.insert(words.end(), maintain.begin(), maintain.end());
    const Finished back = run_kinex(words);
    EXPECT_EQ(back.exit_code, 0) << back.err;
    EXPECT_THAT(back.out, HasSubstr("\"queries\""));
  }
  const Finished other = run_kinex({"import", exported, "--planar", "--maintain", "delaunay_2"});
  EXPECT_EQ(other.exit_code, 0) << other.err;
  EXPECT_THAT(other.out, Not(HasSubstr("\"queries\"")));
  EXPECT_THAT(other.err, HasSubstr("1 query was left out: no structure answers it"));
}

}  // namespace unusual_words_test
}  // namespace kinex
