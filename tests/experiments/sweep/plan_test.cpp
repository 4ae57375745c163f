// SPDX-License-Identifier: GPL-3.0-or-later
// Plans: their cells, keys, order and shards; what is refused, and where.
#include "experiments/sweep/plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "experiments/formats/input_error.h"
#include "experiments/formats/sha256.h"
#include "tests/experiments/expect_input_error.h"

namespace kinex::sweep {
namespace plan_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

Plan plan_of(const std::string& blocks) {
  return parse_plan(R"({"kinex_plan": 1, "name": "test", "blocks": [)" + blocks + "]}", "plan.json",
                    PlanCheck::kScenes);
}

std::vector<std::string> texts_of(const std::vector<PlanCell>& cells) {
  std::vector<std::string> texts;
  for (const PlanCell& cell : cells) texts.push_back(cell.text);
  return texts;
}

TEST(SweepPlan, ABlockIsAProduct) {
  const Plan plan = plan_of(
      R"({"structure": ["sorted_list", "delaunay_2"], "workload": "uniform-square", "n": [4, 8],
          "degree": [1, 2], "seed": {"from": 7, "to": 9}, "arithmetic": ["exact", "gsl"]})");
  EXPECT_EQ(plan.cells.size(), 2u * 2 * 2 * 3 * 2);
  std::set<std::string> keys;
  for (const PlanCell& cell : plan.cells) keys.insert(cell.key);
  EXPECT_EQ(keys.size(), plan.cells.size());
}

// A key outlives the program: records in people's folders are found by it.
TEST(SweepPlan, KeysAreStable) {
  const Plan plan =
      plan_of(R"({"structure": "delaunay_2", "workload": "uniform-square", "n": 100, "seed": 3})");
  ASSERT_EQ(plan.cells.size(), 1u);
  EXPECT_EQ(plan.cells[0].text,
            R"({"arithmetic":"exact","degree":1,"dimension":2,"n":100,"seed":3,)"
            R"("structure":"delaunay_2","workload":"uniform-square"})");
  EXPECT_EQ(plan.cells[0].key, formats::sha256_hex(plan.cells[0].text));
  EXPECT_EQ(plan.cells[0].key, "898eae45a7cd1196e71efc4eec0c959552ea5f140f6e1edf09feb54c950d8aa4");
}

// What is written out, and what is left to the workload, give the same cell.
TEST(SweepPlan, DefaultsDoNotMatter) {
  const std::string brief = R"({"structure": "sorted_list", "workload": "grid", "n": 9})";
  const std::string full =
      R"({"n": [9], "structure": [["sorted_list"]], "workload": ["grid"], "seed": [1], "degree": 1,
          "dimension": [2], "arithmetic": "exact", "scheduling": "lazy", "audit": "end"})";
  const Plan both = plan_of(brief + "," + full);
  ASSERT_EQ(both.cells.size(), 1u);
  EXPECT_EQ(both.cells[0].key, plan_of(brief).cells[0].key);
}

// Families that draw nothing have one scene, whatever the seeds.
TEST(SweepPlan, SeedsAreForRandomFamilies) {
  const Plan plan = plan_of(
      R"({"structure": "sorted_list", "workload": ["sort-worst", "grid"], "n": 8,
          "dimension": 1, "seed": {"from": 1, "to": 5}})");
  EXPECT_EQ(plan.cells.size(), 1u + 5u);
}

RunCell run_of(const PlanCell& cell) { return parse_cell(cell.text, "cell"); }

TEST(SweepPlan, EveryOptionIsInTheCell) {
  const Plan plan = plan_of(
      R"({"structure": "separation_mixed", "workload": "polygon-orbit", "n": 8, "m": 12,
          "separation": 0.50, "turns": 2, "arithmetic": "sturm", "scheduling": "eager",
          "audit": "none", "until": "2/8", "max_events": 3})");
  ASSERT_EQ(plan.cells.size(), 1u);
  EXPECT_EQ(plan.cells[0].text,
            R"({"arithmetic":"sturm","audit":"none","dimension":2,"m":12,"max_events":3,"n":8,)"
            R"("scheduling":"eager","separation":"1/2","structure":"separation_mixed","turns":2,)"
            R"("until":"1/4","workload":"polygon-orbit"})");
  EXPECT_EQ(scheduling_of(run_of(plan.cells[0])), Scheduling::kEager);
  EXPECT_EQ(audit_of(run_of(plan.cells[0])), AuditLevel::kNone);
}

TEST(SweepPlan, ACellReadsItselfBack) {
  const Plan plan = plan_of(
      R"({"structure": ["sorted_list:y", ["sorted_list", {"structure": "delaunay_2", "as": "d"}],
                        {"key": {"direction": [1, "1/3"]}, "structure": "maximum_heap"}],
          "workload": ["new-plans", "hull-worst"], "n": 6, "m": 5, "seed": 18446744073709551615})");
  EXPECT_EQ(plan.cells.size(), 6u);
  for (const PlanCell& cell : plan.cells) {
    EXPECT_EQ(cell_key(parse_cell(cell.text, "cell")), cell.key) << cell.text;
  }
  const auto together = std::find_if(plan.cells.begin(), plan.cells.end(), [](const auto& cell) {
    return run_of(cell).maintain.size() == 2;
  });
  ASSERT_NE(together, plan.cells.end());
  const Scene scene = scene_of(run_of(*together));
  ASSERT_EQ(scene.maintain.size(), 2u);
  EXPECT_EQ(scene.maintain[1].label, "d");
}

TEST(SweepPlan, LargestCostFirstThenTheKey) {
  const Plan plan = plan_of(
      R"({"structure": "sorted_list", "workload": "uniform-square", "n": [10, 30, 20],
          "seed": {"from": 1, "to": 6}, "arithmetic": ["exact", "mpfr:53", "sturm"]})");
  ASSERT_EQ(plan.cells.size(), 54u);
  EXPECT_EQ(run_of(plan.cells.front()).parameters.n, 30);
  EXPECT_EQ(run_of(plan.cells.front()).arithmetic, "sturm");
  EXPECT_EQ(run_of(plan.cells.back()).parameters.n, 10);
  EXPECT_EQ(run_of(plan.cells.back()).arithmetic, "exact");
  for (std::size_t i = 1; i < plan.cells.size(); ++i) {
    const PlanCell &a = plan.cells[i - 1], &b = plan.cells[i];
    EXPECT_TRUE(a.cost > b.cost || (a.cost == b.cost && a.key < b.key)) << i;
  }
}

TEST(SweepPlan, TheOrderOfTheFileDoesNotMatter) {
  const Plan a =
      plan_of(R"({"structure": ["delaunay_2", "sorted_list"], "workload": "grid", "n": [5, 6]})");
  const Plan b =
      plan_of(R"({"n": [6], "workload": "grid", "structure": ["sorted_list", "delaunay_2"]},
                            {"n": [5], "workload": "grid", "structure": ["sorted_list", "delaunay_2"]})");
  EXPECT_EQ(texts_of(a.cells), texts_of(b.cells));
  EXPECT_NE(a.hash, b.hash);
}

TEST(SweepPlan, ShardsArePartsOfThePlan) {
  const Plan plan = plan_of(
      R"({"structure": "sorted_list", "workload": "uniform-square", "n": [3, 4, 5, 6],
          "seed": {"from": 1, "to": 8}})");
  for (const int count : {1, 2, 3, 7, 32, 50}) {
    std::vector<std::string> all;
    for (int i = 0; i < count; ++i) {
      const std::vector<std::string> part = texts_of(shard_of(plan, {i, count}));
      if (count == 3 && i == 1) {
        EXPECT_EQ(part[1], plan.cells[4].text);
      }
      all.insert(all.end(), part.begin(), part.end());
    }
    std::sort(all.begin(), all.end());
    std::vector<std::string> expected = texts_of(plan.cells);
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(all, expected) << count;
  }
}

TEST(SweepPlan, ShardsAsText) {
  EXPECT_EQ(shard_text(parse_shard("3/64")), "3/64");
  for (const char* text : {"", "3", "4/4", "-1/4", "0/0", "1/2/3", "a/4", "0x1/4", " 1/4", "1/"}) {
    EXPECT_INPUT_ERROR(parse_shard(text), "is not a shard");
  }
}

TEST(SweepPlan, LimitsAndHash) {
  const std::string text =
      R"({"kinex_plan": 1, "name": "a", "limits": {"seconds": 9, "megabytes": 512},
          "blocks": [{"structure": "delaunay_2", "workload": "grid", "n": 4}]})";
  const Plan plan = parse_plan(text, "plan.json", PlanCheck::kScenes);
  EXPECT_EQ(plan.limits.seconds, 9);
  EXPECT_EQ(plan.limits.megabytes, 512);
  const Plan again = parse_plan(plan.text, "header", PlanCheck::kFormOnly);
  EXPECT_EQ(again.hash, plan.hash);
  EXPECT_EQ(texts_of(again.cells), texts_of(plan.cells));
}

TEST(SweepPlan, DefectsHaveAPlace) {
  const auto refused = [](const std::string& block, const std::string& place,
                          const std::string& problem) {
    EXPECT_INPUT_ERROR(plan_of(block), "plan.json: /blocks/0" + place + ": ");
    EXPECT_INPUT_ERROR(plan_of(block), problem);
  };
  refused(R"({"structure": "sorted_list", "workload": "grid"})", "", "\"n\" is missing");
  refused(R"({"structure": "sorted_list", "workload": "grid", "n": 4, "m": 4})", "/m",
          "this workload has one size only");
  refused(R"({"structure": "sorted_list", "workload": "grid", "n": [4, 0]})", "/n/1",
          "0 is not an integer from 1 to");
  refused(R"({"structure": "sorted_list", "workload": "grid", "n": []})", "/n",
          "an axis without values");
  refused(R"({"structure": "sorted_list", "workload": ["grid", "gird"], "n": 4})", "/workload/1",
          "\"gird\" is not a workload");
  refused(R"({"structure": ["sorted_list", "sortedlist"], "workload": "grid", "n": 4})",
          "/structure/1", "\"sortedlist\" is not a known structure");
  refused(R"({"structure": "sorted_list,delaunay_2", "workload": "grid", "n": 4})", "/structure",
          "is not a structure");
  refused(R"({"structure": "separation_mixed", "workload": "grid", "n": 4})", "/structure",
          "separation_mixed");
  refused(R"({"structure": "delaunay_2", "workload": "grid", "n": 4, "dimension": [2, 1]})",
          "/structure", "needs 2 axes, a scene of grid has 1; write \"dimension\": 2");
  refused(R"({"structure": "sorted_list", "workload": "grid", "n": 4, "degree": [1, 2]})",
          "/degree/1", "this workload has a degree of its own");
  refused(R"({"structure": "sorted_list", "workload": "grid", "n": 4, "seed": -1})", "/seed",
          "-1 is not a seed");
  refused(
      R"({"structure": "sorted_list", "workload": "grid", "n": 4, "seed": {"from": 3, "to": 2}})",
      "/seed", "seeds from 3 to 2");
  refused(R"({"structure": "sorted_list", "workload": "grid", "n": 4, "arithmetic": "exakt"})",
          "/arithmetic", "exakt");
  refused(R"({"structure": "sorted_list", "workload": "grid", "n": 4, "audit": ["end", "all"]})",
          "/audit/1", "\"all\" is not known here");
  refused(R"({"structure": "sorted_list", "workload": "grid", "n": 4, "until": 9})", "/until",
          "9 is outside of the scene's time");
  refused(R"({"structure": "sorted_list", "workload": "grid", "n": 4, "sede": 1})", "/sede",
          "\"sede\" is not a known field");
  refused(R"({"structure": "emst_cycles", "workload": "random-graph", "n": 4})", "/structure",
          "\"emst_cycles\" needs 2 axes, a scene of random-graph has 1; name another structure, or "
          "another workload, as uniform-square");
  refused(
      R"({"structure": "sorted_list", "workload": "grid", "n": [3, 4, 5, 6, 7, 8, 9, 10, 11, 12],
              "seed": {"from": 1, "to": 200000}})",
      "", "more than 200000 cells");
}

// The path goes into the entry; the one line is that of the plan.
TEST(SweepPlan, DefectsOfStructuresHaveTheirLines) {
  const auto refused = [](const std::string& second, const std::string& message) {
    const std::string block =
        R"({"workload": "uniform-square", "n": 5, "structure": ["sorted_list",)" + second + "]}";
    try {
      plan_of(block);
      ADD_FAILURE() << second << " is taken";
    } catch (const formats::InputError& error) {
      const std::string text = error.what();
      EXPECT_THAT(text, HasSubstr("plan.json: /blocks/0/structure/1" + message));
      EXPECT_THAT(text.substr(text.size() - 9), HasSubstr(" (line 3)"));
      EXPECT_THAT(text.substr(0, text.size() - 9), Not(HasSubstr("(line"))) << text;
    }
  };
  refused("\n{\"structure\": \"diameter_2\",\n\"over\": \"zzz\"}",
          "/over: \"zzz\" is not a known structure; ");
  refused("\n{\"structure\": \"diameter_2\",\n\"over\": {\"structure\": \"zzz\"}}",
          "/over/structure: \"zzz\" is not a known structure; ");
  refused("\n{\"structure\": \"delaunay_2\",\n\"key\": \"x\"}",
          "/key: \"delaunay_2\" takes no key; ");
  refused("\n{\"structure\": \"delaunay_2\",\n\"sead\": 1}",
          "/sead: \"sead\" is not a known field; ");
  refused("\n{\"structure\": \"emst_clusters\",\n\"cluster\": -1}",
          "/cluster: \"emst_clusters\" cannot have cluster = -1; ");
  refused("\n\n\"zzz\"", ": \"zzz\" is not a known structure; ");
  refused("\n\n[\"delaunay_2\", {\"structure\": \"delaunay_2\", \"of\": [\"zzz\"]}]",
          "/1/of/0: there is no object \"zzz\"; ");
  refused("\n\n[\"delaunay_2\", {\"structure\": \"delaunay_2\"}]",
          "/1: the label \"delaunay_2\" is used twice; ");
}

TEST(SweepPlan, DefectsOfTheWhole) {
  const auto refused = [](const std::string& text, const std::string& message) {
    EXPECT_INPUT_ERROR(parse_plan(text, "plan.json", PlanCheck::kScenes), message);
  };
  refused("[]", "in place of an object");
  refused(R"({"kinex_plan": 2, "name": "a", "blocks": []})", "/kinex_plan: 2 is not a version");
  refused(R"({"kinex_plan": 1, "name": "a", "blocks": []})", "/blocks: a plan without blocks");
  refused(R"({"kinex_plan": 1, "name": "a", "blocks": [{}], "limits": {"seconds": 0}})",
          "/limits/seconds: 0 is not an integer from 1");
}

}  // namespace plan_test
}  // namespace kinex::sweep
